// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/planar_swings.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/sample_plan.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

SwingTrajectory Step() {
  SwingTrajectory swing;
  swing.start_s = 1.0;
  swing.end_s = 1.5;
  swing.X_WF_end.translation() = Vector3(0.1, 0.0, 0.0);
  swing.lift_m = 0.05;
  return swing;
}

/// A base that leans to the right.
Pose Leaning(double roll_rad) { return Pose(Eigen::AngleAxisd(roll_rad, Vector3::UnitX())); }

TEST(PlanarSwings, OnlyLegsWhoseAxesAreParallelStayInAPlane) {
  for (const auto& plane : PlanesOfLegs(LoadRobotFromText(unusual::Planar(), "").value())) {
    ASSERT_TRUE(plane.has_value());
    EXPECT_NEAR(std::abs(plane->y()), 1.0, 1e-9);
  }
  for (const auto& plane : PlanesOfLegs(LoadRobotFromText(unusual::Plain(), "").value()))
    EXPECT_FALSE(plane.has_value());
}

TEST(PlanarSwings, AFootMovesLaterallyAsItsPlaneLeans) {
  constexpr double kRoll = -0.04;
  std::vector<SwingTrajectory> swings = {Step()};
  const Vector3 normal_B = Vector3::UnitY(), normal_W = Leaning(kRoll).linear() * normal_B;
  const double change = LeanSwings(
      {normal_B}, [](double) { return Leaning(kRoll); }, swings);
  EXPECT_NEAR(change, 0.05 * std::tan(-kRoll), 1e-9);
  double farthest = 0.0;
  for (int i = 0; i <= 50; ++i) {
    const double time_s = 1.0 + 0.01 * i;
    const Vector3 p_W = Evaluate(CurveOf(swings[0]), time_s).X_WF.translation();
    const Vector3 plain_W = Evaluate(CurveOf(Step()), time_s).X_WF.translation();
    EXPECT_NEAR(normal_W.dot(p_W), 0.0, 1e-12);
    EXPECT_NEAR(p_W.x(), plain_W.x(), 1e-12);
    EXPECT_NEAR(p_W.z(), plain_W.z(), 1e-5) << "it is lifted as before";
    farthest = std::max(farthest, std::abs(p_W.y()));
  }
  EXPECT_GT(farthest, 1e-3);
  EXPECT_NEAR(LeanSwings(
                  {normal_B}, [](double) { return Leaning(kRoll); }, swings),
              0.0, 1e-12)
      << "once is enough";
}

TEST(PlanarSwings, OthersAreLeftAlone) {
  std::vector<SwingTrajectory> swings = {Step()};
  EXPECT_EQ(LeanSwings(
                {std::nullopt}, [](double) { return Leaning(0.1); }, swings),
            0.0);
  EXPECT_TRUE(swings[0].detour_W.empty());
  EXPECT_EQ(LeanSwings(
                {Vector3::UnitY()}, [](double) { return Pose::Identity(); }, swings),
            0.0);
  EXPECT_TRUE(swings[0].detour_W.empty()) << "upright";
}

}  // namespace
}  // namespace gaitwright
