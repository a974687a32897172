// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/base_over_feet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

/// Feet of a standing robot, moved to a place on a plane with a slope forward and to the left.
std::vector<Pose> OnPlane(const std::vector<Pose>& standing, const PlanarPose& at, double height,
                          const Vector2& slope_B) {
  std::vector<Pose> feet;
  for (const Pose& X_BF : standing) {
    Pose X_WF = Carried(at, X_BF);
    X_WF.translation().z() = height + slope_B.dot(X_BF.translation().head<2>());
    feet.push_back(X_WF);
  }
  return feet;
}

TEST(BaseOverFeet, FindsThePlaneThatTheFeetOfAQuadrupedStandOn) {
  const auto standing = StandingFeet(*LoadNamedRobot("a1"));
  const Vector2 slope(0.3, -0.2);
  const BaseOverFeet base = FitBase(standing, OnPlane(standing, {1.0, -2.0, 0.7}, 0.4, slope));
  EXPECT_NEAR(base.plan.x_m, 1.0, 1e-12);
  EXPECT_NEAR(base.plan.y_m, -2.0, 1e-12);
  EXPECT_NEAR(base.plan.yaw_rad, 0.7, 1e-12);
  EXPECT_NEAR(base.ground_m, 0.4, 1e-12);
  // The plane's normal is the vertical axis of the base.
  const Matrix3 R =
      (Eigen::AngleAxisd(base.pitch_rad, Vector3::UnitY()) * Eigen::AngleAxisd(base.roll_rad, Vector3::UnitX()))
          .toRotationMatrix();
  EXPECT_NEAR((R.col(2) - Vector3(-slope.x(), -slope.y(), 1.0).normalized()).norm(), 0.0, 1e-12);
}

TEST(BaseOverFeet, StaysLevelOnTwoFeetAndBetweenTheirHeights) {
  const auto standing = StandingFeet(*LoadNamedRobot("nao"));
  auto feet = OnPlane(standing, {0.0, 0.0, -0.3}, 0.0, Vector2::Zero());
  feet[0].translation().z() = 0.04;
  const BaseOverFeet base = FitBase(standing, feet);
  EXPECT_EQ(base.roll_rad, 0.0);
  EXPECT_EQ(base.pitch_rad, 0.0);
  EXPECT_NEAR(base.ground_m, 0.02, 1e-12);
  EXPECT_NEAR(base.plan.yaw_rad, -0.3, 1e-12);
}

TEST(BaseOverFeet, RefusesFeetThatDoNotMatch) {
  const auto standing = StandingFeet(*LoadNamedRobot("nao"));
  EXPECT_THROW(FitBase(standing, {standing[0]}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
