// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/plan_swings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/load_robot.h"
#include "optimisation/swing/refine_swing.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

/// Level ground with a box across the way.
Terrain WithBox(double from_m, double to_m, double height_m) {
  Terrain terrain = FlatTerrain();
  TerrainPatch box;
  box.name = "box";
  box.X_WT.translation().z() = height_m;
  box.outline_T = {{from_m, -1.0}, {to_m, -1.0}, {to_m, 1.0}, {from_m, 1.0}};
  terrain.patches.push_back(box);
  return terrain;
}

FootstepPlan OneStep(double length_m, double rise_m) {
  Foothold from, to;
  from.liftoff_s = 0.8;
  to.touchdown_s = 1.3;
  to.liftoff_s = 2.0;
  to.X_WF.translation() = Vector3(length_m, 0.0, rise_m);
  return {{from, to}};
}

double Spare(const RobotModel& model, const Terrain& terrain, const SwingTrajectory& swing, double clearance_m) {
  return SpareClearance(
      CurveOf(swing), UndersideOf(model.feet[0]), [&](const Vector2& p) { return GroundAt(terrain, p).height_m; },
      clearance_m);
}

TEST(PlanSwings, FlatGroundNeedsNoDetour) {
  for (const char* name : {"nao", "a1"}) {
    const RobotModel model = *LoadNamedRobot(name);
    const auto swings = PlanSwings(model, FlatTerrain(), OneStep(0.08, 0.0), {});
    ASSERT_TRUE(swings.ok()) << swings.failure().message;
    ASSERT_EQ(swings->size(), 1U);
    EXPECT_TRUE(swings->front().detour_W.empty());
    EXPECT_NEAR(swings->front().lift_m, 0.12 * model.leg_length_m(), 1e-12);
  }
}

TEST(PlanSwings, OnLevelGroundALiftThatClearsMidSwingIsLeftAlone) {
  const RobotModel model = *LoadNamedRobot("a1");
  SwingOptions options;
  options.height_m = 0.05;
  const double mid_swing = 0.05 * 64.0 * std::pow(0.35 * 0.65, 3);
  for (const double share : {0.9, 0.999, 1.001, 1.1}) {
    options.clearance_m = share * mid_swing;
    const auto swings = PlanSwings(model, FlatTerrain(), OneStep(0.08, 0.0), options);
    ASSERT_TRUE(swings.ok()) << swings.failure().message;
    EXPECT_EQ(swings->front().detour_W.empty(), share < 1.0) << share;
  }
}

TEST(PlanSwings, ABoxUnderTheSwingMakesADetour) {
  struct Case {
    const char* robot;
    double length_m, rise_m;
    Terrain terrain;
  };
  const std::vector<Case> cases = {{"a1", 0.2, 0.0, WithBox(0.07, 0.12, 0.06)},
                                   {"a1", 0.2, 0.08, WithBox(0.1, 1.0, 0.08)},
                                   {"a1", 0.2, -0.06, WithBox(-1.0, 0.05, 0.0)},
                                   {"nao", 0.25, 0.0, WithBox(0.11, 0.125, 0.05)}};
  for (const Case& c : cases) {
    const RobotModel model = *LoadNamedRobot(c.robot);
    Terrain terrain = c.terrain;
    if (c.rise_m < 0.0) terrain.patches[0].X_WT.translation().z() = c.rise_m;  // down from the box
    SwingOptions options;
    options.clearance_m = 0.02;
    const auto swings = PlanSwings(model, terrain, OneStep(c.length_m, c.rise_m), options);
    ASSERT_TRUE(swings.ok()) << c.robot << ": " << swings.failure().message;
    const SwingTrajectory& swing = swings->front();
    EXPECT_GT(Spare(model, terrain, swing, swing.detour_W.empty() ? 0.007 : 0.02), -0.0012)
        << c.robot << " " << c.rise_m;
    EXPECT_GT(swing.clearance_m, 0.0185);
    EXPECT_TRUE(c.rise_m < 0.0 || !swing.detour_W.empty()) << c.robot << " " << c.rise_m;
  }
}

TEST(PlanSwings, AWallHigherThanTheLegIsNamed) {
  const RobotModel model = *LoadNamedRobot("a1");
  const auto swings = PlanSwings(model, WithBox(0.1, 0.12, 3.0), OneStep(0.2, 0.0), {});
  ASSERT_FALSE(swings.ok());
  EXPECT_EQ(swings.failure().kind, FailureKind::kInfeasible);
  EXPECT_NE(swings.failure().message.find("at 0.80 s cannot clear the ground"), std::string::npos)
      << swings.failure().message;
}

}  // namespace
}  // namespace gaitwright
