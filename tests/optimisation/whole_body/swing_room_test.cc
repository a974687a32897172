// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/whole_body/finish_problem_internal.h"
#include "optimisation/whole_body/swing_room_internal.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/plan/sample_plan.h"
#include "tests/kinematics/made_robots.h"
#include "tests/optimisation/whole_body/stepping_plan.h"

namespace gaitwright {
namespace {

constexpr double kMost = 0.04, kClearance = 0.01;  // [m]

MotionPlan StepOn(const RobotModel& model, const Terrain& terrain) {
  MotionPlan plan = SteppingPlan(model);
  plan.terrain = terrain;
  plan.swings.front().clearance_m = 0.03;
  return plan;
}

/// The problem of a plan with its swings free.
BodyProblem FreeProblem(const RobotModel& model, const MotionPlan& plan, const SwingFreedom& freedom) {
  const std::vector<FootCourse> courses = CoursesOf(model, plan);
  BodyProblem problem = ProblemOf(model, plan, courses, KnotTimesOf(plan, 0.01), {});
  FreeSwings(model, plan, courses, freedom, problem);
  return problem;
}

TEST(FreeSwings, MakesTheHeightOfAFootAOneSidedConstraint) {
  const RobotModel model = AnyRobot("a1");
  const MotionPlan plan = StepOn(model, FlatTerrain());
  const BodyProblem problem = FreeProblem(model, plan, {kMost, kClearance});
  bool in_mid_swing = false;
  for (std::size_t k = 0; k < problem.knots.size(); ++k) {
    const double share = (problem.time_s[k] - 0.1) / 0.135;
    for (const FootGoal& goal : problem.knots[k].feet) {
      for (const std::size_t i : {3u, 4u, 5u}) EXPECT_EQ(goal.below[i] + goal.above[i], 0.0) << "rotations stay";
      if (!goal.swings) {
        EXPECT_EQ(goal.below, (std::array<double, 6>{}));
        EXPECT_EQ(goal.above, (std::array<double, 6>{}));
        continue;
      }
      const double height_m = goal.p_W.z() - model.feet[0].radius;
      EXPECT_GE(height_m - goal.below[2], kClearance * (share > 0.35 && share < 0.65 ? 1.0 : 0.0) - 1e-9);
      EXPECT_LE(goal.above[2], kMost);
      if (share < 0.45 || share > 0.55) continue;
      in_mid_swing = true;
      EXPECT_NEAR(goal.below[2], std::min(kMost, height_m - kClearance), 1e-9);
      for (const std::size_t i : {0u, 1u}) EXPECT_NEAR(goal.below[i] + goal.above[i], 2.0 * kMost, 1e-9);
      EXPECT_NEAR(goal.above[2], kMost, 1e-9);
    }
  }
  EXPECT_TRUE(in_mid_swing);
}

TEST(FreeSwings, LeavesLessRoomBesideARiser) {
  const RobotModel model = AnyRobot("a1");
  Terrain terrain = FlatTerrain();
  // A wall 2 cm to the left of the path, as high as the foot never is.
  constexpr double kWall = 0.02;
  terrain.patches.push_back(PatchThrough(
      "wall", {{-1.0, kWall, 0.3}, {1.0, kWall, 0.3}, {1.0, kWall + 1.0, 0.3}, {-1.0, kWall + 1.0, 0.3}}, 0.8));
  const BodyProblem open = FreeProblem(model, StepOn(model, FlatTerrain()), {kMost, kClearance}),
                    beside = FreeProblem(model, StepOn(model, terrain), {kMost, kClearance});
  bool has_room = false;
  for (std::size_t k = 0; k < beside.knots.size(); ++k) {
    const FootGoal &wide = open.knots[k].feet[0], &narrow = beside.knots[k].feet[0];
    EXPECT_LE(narrow.above[1], wide.above[1]);
    EXPECT_LT(narrow.above[1] + model.feet[0].radius, std::max(kWall, model.feet[0].radius + 1e-9));
    has_room = has_room || wide.above[1] > 0.03;
  }
  EXPECT_TRUE(has_room);
}

TEST(FreeSwings, KeepsHalfOfThePlannedHeightByDefault) {
  SwingTrajectory swing;
  swing.clearance_m = 0.03;
  EXPECT_NEAR(ClearanceToKeep(swing, {}), 0.015, 1e-12);
  EXPECT_EQ(ClearanceToKeep(swing, {.clearance_m = 0.02}), 0.02);
}

}  // namespace
}  // namespace gaitwright
