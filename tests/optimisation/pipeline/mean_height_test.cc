// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/mean_height.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

/// Adds a foot that stands at x and then at x + forward_m, higher by `up`.
void AddFoot(FootstepPlan& footsteps, int foot, const Vector2& at, double forward_m, double up_m) {
  Foothold from, to;
  from.foot = to.foot = foot;
  from.liftoff_s = 1.0;
  to.touchdown_s = 2.0;
  to.liftoff_s = 3.0;
  from.X_WF.translation() = Vector3(at.x(), at.y(), 0.0);
  to.X_WF.translation() = Vector3(at.x() + forward_m, at.y(), up_m);
  footsteps.footholds.push_back(from);
  footsteps.footholds.push_back(to);
}

/// Four feet that leap all at once.
FootstepPlan Leap(double up_m) {
  FootstepPlan footsteps;
  for (const Vector2& at : {Vector2(0.2, 0.1), Vector2(0.2, -0.1), Vector2(-0.2, 0.1), Vector2(-0.2, -0.1)})
    AddFoot(footsteps, static_cast<int>(footsteps.footholds.size() / 2), at, 0.5, up_m);
  SortFootholds(footsteps);
  return footsteps;
}

/// A motion of three seconds at a height that is a function of time.
template <class Height>
CentroidalTrajectory MotionAt(const Height& height) {
  CentroidalTrajectory motion;
  motion.step_s = 0.01;
  for (int k = 0; k <= 300; ++k) {
    const double time_s = k * motion.step_s;
    motion.p_WC.emplace_back(0.2 * time_s, 0.0, height(time_s));
  }
  return motion;
}

TEST(MeanHeightOverFeet, OverFeetThatStayAtOneHeightIsTheMeanHeight) {
  const auto swaying = [](double t) { return 0.3 + 0.05 * std::sin(2.0 * std::numbers::pi * t); };
  EXPECT_NEAR(MeanHeightOverFeet(MotionAt(swaying), Leap(0.0), 4), 0.3, 1e-9);
}

TEST(MeanHeightOverFeet, ABodyThatRisesEvenlyWithItsFeetInTheAirKeepsItsHeight) {
  for (const double up_m : {0.2, -0.2}) {
    const auto with_feet = [&](double t) { return 0.3 + up_m * std::clamp(t - 1.0, 0.0, 1.0); };
    EXPECT_NEAR(MeanHeightOverFeet(MotionAt(with_feet), Leap(up_m), 4), 0.3, 1e-9);
    const auto at_once = [&](double t) { return 0.3 + (t < 1.0 ? 0.0 : up_m); };
    EXPECT_NEAR(MeanHeightOverFeet(MotionAt(at_once), Leap(up_m), 4), 0.3 + up_m / 6.0, 2e-3);
  }
}

TEST(MeanHeightOverFeet, IsOverThePlaneThroughFeetThatStandOnASlope) {
  FootstepPlan footsteps = Leap(0.0);
  for (Foothold& foothold : footsteps.footholds)
    foothold.X_WF.translation().z() = 0.5 * foothold.X_WF.translation().x();
  const auto along = [](double t) { return 0.3 + 0.5 * 0.2 * t; };
  EXPECT_NEAR(MeanHeightOverFeet(MotionAt(along), footsteps, 4), 0.3, 1e-9);
}

TEST(MeanHeightOverFeet, RefusesAMotionWithoutSamplesAndAFootWithoutFootholds) {
  EXPECT_THROW((void)MeanHeightOverFeet({}, Leap(0.0), 4), InvalidArgument);
  const auto still = [](double) { return 0.3; };
  EXPECT_THROW((void)MeanHeightOverFeet(MotionAt(still), Leap(0.0), 5), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
