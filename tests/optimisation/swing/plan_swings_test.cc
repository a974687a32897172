// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/plan_swings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "kinematics/model/load_robot.h"
#include "optimisation/swing/refine_swing.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

/// Level ground with a box across the path.
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

double Margin(const RobotModel& model, const Terrain& terrain, const SwingTrajectory& swing, double clearance_m) {
  return ClearanceMargin(
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

TEST(PlanSwings, AFootThatFliesAlongKeepsAnEighthOfItsLiftOverAnEdge) {
  const RobotModel model = *LoadNamedRobot("a1");
  const Terrain terrain = WithBox(0.1, 0.8, 0.15);
  for (const double lift_m : {0.15, 0.24, 0.3}) {
    FormerMotion flight;
    flight.lift_m = [&](const SwingTrajectory&) { return lift_m; };
    flight.cruise = [](const SwingTrajectory&) { return 0.6; };
    const auto swings = PlanSwings(model, terrain, OneStep(0.5, 0.15), {}, flight);
    ASSERT_TRUE(swings.ok()) << swings.failure().message;
    EXPECT_GE(Margin(model, terrain, swings->front(), 0.35 * 0.125 * lift_m), -1e-6) << lift_m;
    EXPECT_GE(swings->front().clearance_m, 0.125 * lift_m - 1e-6) << lift_m;
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
    EXPECT_GT(Margin(model, terrain, swing, swing.detour_W.empty() ? 0.007 : 0.02), -0.0012)
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

Obstacle Box(const char* name, const Vector3& middle_W, const Vector3& size_m) {
  Obstacle box;
  box.name = name;
  box.X_WO.translation() = middle_W;
  box.size_m = size_m;
  return box;
}

/// Smallest distance of a spherical foot from an upright box along its whole swing, in closed form.
double LeastGap(const SwingTrajectory& swing, double radius_m, const Vector3& middle_W, const Vector3& size_m) {
  double least = 1e9;
  for (int k = 0; k <= 200; ++k) {
    const Pose X_WF = Evaluate(CurveOf(swing), swing.start_s + (swing.end_s - swing.start_s) * k / 200.0).X_WF;
    const Vector3 centre = X_WF.translation() + radius_m * X_WF.linear().col(2) - middle_W;
    least = std::min(least, (centre.cwiseAbs() - 0.5 * size_m).cwiseMax(0.0).norm() - radius_m);
  }
  return least;
}

TEST(PlanSwings, ALowObstacleIsSteppedOver) {
  const RobotModel model = *LoadNamedRobot("a1");
  const Vector3 middle(0.1, 0.0, 0.03), size(0.03, 1.0, 0.06);
  Terrain terrain = FlatTerrain();
  terrain.obstacles = {Box("beam", middle, size)};
  const auto swings = PlanSwings(model, terrain, OneStep(0.2, 0.0), {});
  ASSERT_TRUE(swings.ok()) << swings.failure().message;
  EXPECT_FALSE(swings->front().detour_W.empty());
  EXPECT_GT(swings->front().lift_m, 0.06);
  EXPECT_GT(LeastGap(swings->front(), 0.02, middle, size), 0.004);
  EXPECT_NEAR(Evaluate(CurveOf(swings->front()), 1.05).X_WF.translation().y(), 0.0, 1e-9);
}

TEST(PlanSwings, APostIsPassedBeside) {
  const RobotModel model = *LoadNamedRobot("a1");
  const Vector3 middle(0.1, 0.0, 0.5), size(0.02, 0.02, 1.0);
  Terrain terrain = FlatTerrain();
  terrain.obstacles = {Box("post", middle, size)};
  const auto swings = PlanSwings(model, terrain, OneStep(0.2, 0.0), {});
  ASSERT_TRUE(swings.ok()) << swings.failure().message;
  EXPECT_GT(std::abs(Evaluate(CurveOf(swings->front()), 1.05).X_WF.translation().y()), 0.03);
  EXPECT_GT(LeastGap(swings->front(), 0.02, middle, size), 0.003);
}

TEST(PlanSwings, WhatCannotBePassedIsNamed) {
  const RobotModel model = *LoadNamedRobot("a1");
  Terrain terrain = FlatTerrain();
  terrain.obstacles = {Box("gate", Vector3(0.1, 0.0, 0.5), Vector3(0.02, 2.0, 1.0))};
  const auto swings = PlanSwings(model, terrain, OneStep(0.2, 0.0), {});
  ASSERT_FALSE(swings.ok());
  const std::string& message = swings.failure().message;
  EXPECT_NE(message.find("the swing of foot '" + model.feet[0].name + "' at 0.80 s"), std::string::npos) << message;
  EXPECT_NE(message.find("'gate'"), std::string::npos) << message;
}

TEST(PlanSwings, AFootRisesBeforeARiserAndGoesForwardBeforeItComesDown) {
  const RobotModel model = *LoadNamedRobot("a1");
  for (const double rise : {0.1, -0.1}) {
    // The upper tread's edge is 45 mm from the lower foothold's middle, 25 mm from the ball.
    Terrain terrain = rise > 0.0 ? WithBox(0.045, 1.0, rise) : WithBox(-1.0, 0.2 - 0.045, 0.0);
    if (rise < 0.0) terrain.patches[0].X_WT.translation().z() = rise;
    const auto swings = PlanSwings(model, terrain, OneStep(0.2, rise), {});
    ASSERT_TRUE(swings.ok()) << swings.failure().message;
    const SwingTrajectory& swing = swings->front();
    const Vector3 size(2.0, 2.0, 1.0), middle(rise > 0.0 ? 1.045 : 0.155 - 1.0, 0.0, std::max(rise, 0.0) - 0.5);
    const double upper_s = rise > 0.0 ? swing.end_s : swing.start_s;
    double least_beside = 1e9;  // distance to the upper tread while the foot is not above it
    for (int k = 1; k < 200; ++k) {
      const double t = swing.start_s + (swing.end_s - swing.start_s) * k / 200.0;
      const Vector3 p = Evaluate(CurveOf(swing), t).X_WF.translation();
      if (std::abs(t - upper_s) < 0.2) continue;
      const Vector3 centre = p + Vector3(0.0, 0.0, 0.02) - middle;
      least_beside = std::min(least_beside, (centre.cwiseAbs() - 0.5 * size).cwiseMax(0.0).norm() - 0.02);
    }
    EXPECT_GT(least_beside, 0.005) << "rise " << rise;
  }
}

TEST(PlanSwings, WhatASphereRollsOffItsCurveIsReckonedWith) {
  const RobotModel model = *LoadNamedRobot("a1");
  const SwingRoll roll({Vector3::Zero(), 0.03 * Vector3::UnitX(), 0.035 * Vector3::UnitX(), Vector3::Zero()});
  FormerMotion former;
  former.roll = [&](const SwingTrajectory&) { return SwingRoll(roll); };
  const Terrain terrain = WithBox(0.05, 3.0, 0.1);
  const auto margin = [&](const SwingTrajectory& swing) {
    return ClearanceMargin(
        CurveOf(swing), UndersideOf(model.feet[0]), [&](const Vector2& p) { return GroundAt(terrain, p).height_m; },
        0.0, roll);
  };
  const auto blind = PlanSwings(model, terrain, OneStep(0.2, 0.1), {});
  ASSERT_TRUE(blind.ok()) << blind.failure().message;
  EXPECT_LT(margin(blind->front()), -1e-3);
  const auto seeing = PlanSwings(model, terrain, OneStep(0.2, 0.1), {}, former);
  ASSERT_TRUE(seeing.ok()) << seeing.failure().message;
  EXPECT_GT(margin(seeing->front()), -1e-4);
}

TEST(PlanSwings, AShankGoesAroundWhatTheFootPassesUnder) {
  const RobotModel model = *LoadNamedRobot("a1");
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  const Foot& foot = model.feet[0];
  const Vector3 p_WF = FramePose(scratch, foot.body, foot.X_BF).translation();
  FootstepPlan steps = OneStep(0.2, 0.0);
  for (Foothold& foothold : steps.footholds) foothold.X_WF.translation() += Vector3(p_WF.x() - 0.1, p_WF.y(), 0.0);
  const Pose X_WB = FramePose(scratch, 0, Pose::Identity());
  const BaseMotion still = [X_WB](double) { return Pose(X_WB); };
  // A knob beside the shank, below its middle, in mid swing; half of the knob is inside the shank.
  const auto shank = std::find_if(model.collision_shapes.begin(), model.collision_shapes.end(),
                                  [&](const Shape& shape) { return shape.body == model.legs[0].knee_joint + 1; });
  ASSERT_NE(shank, model.collision_shapes.end());
  const SwingTrajectory free = PlanSwings(model, FlatTerrain(), steps, {})->front();
  Pose X_WF = Evaluate(CurveOf(free), 0.5 * (free.start_s + free.end_s)).X_WF;
  X_WF.translation().z() += foot.radius;
  const LegIk ik(model, 0);
  const VectorX joints = ik.Solve(X_WB.inverse() * X_WF)->joints;
  VectorX q = StandingConfiguration(model);
  for (Eigen::Index i = 0; i < joints.size(); ++i) q[7 + ik.dofs()[static_cast<std::size_t>(i)]] = joints[i];
  ForwardKinematics(model, q, scratch);
  const Vector3 knob = FramePose(scratch, shank->body, shank->X_BS) * Vector3(0.05, 0.008, 0.0);
  Terrain terrain = FlatTerrain();
  terrain.obstacles = {Box("knob", knob, Vector3::Constant(0.01))};
  const auto blind = PlanSwings(model, terrain, steps, {});
  ASSERT_TRUE(blind.ok()) << blind.failure().message;
  const SwingGuard guard(model, terrain, {still, {}, {}});
  const auto hit = guard.Check(blind->front(), 0.0);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->part, shank->link);
  EXPECT_EQ(hit->solid, "knob");
  const auto seeing = PlanSwings(model, terrain, steps, {}, {still, {}, {}});
  ASSERT_TRUE(seeing.ok()) << seeing.failure().message;
  EXPECT_FALSE(guard.Check(seeing->front(), 0.0).has_value());
}

}  // namespace
}  // namespace gaitwright
