// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/model/body_tree.h"
#include "optimisation/search/plan_turn_internal.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

WalkRequest TurnRequest() {
  WalkRequest request;
  request.gait = "backflip";
  request.command.distance_m = 1.0;  // the default of requests
  return request;
}

class TurnsOfQuadrupeds : public testing::TestWithParam<const char*> {};

TEST_P(TurnsOfQuadrupeds, HaveSoundPlansThatTurnOver) {
  SearchTrace trace;
  const Result<PlannedWalk> planned = PlanWalk(NamedRobot(GetParam()), TurnRequest(), &trace);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.violations.empty());
  const MotionPlan& plan = planned->motion.plan;
  double upside_down = 1.0;
  for (const VectorX& q : plan.whole_body.q) upside_down = std::min(upside_down, BaseRotation(q)(2, 2));
  EXPECT_LT(upside_down, -0.9);
  EXPECT_EQ(plan.swings.size(), 4U);
  EXPECT_LT(plan.goal.x_m, -0.2);
  EXPECT_EQ(plan.parts.front().gait.pitch_turns, -1.0);
  EXPECT_FALSE(trace.empty());
  EXPECT_FALSE(trace.back().refused.has_value());
}

INSTANTIATE_TEST_SUITE_P(OfQuadrupeds, TurnsOfQuadrupeds, testing::Values("a1", "mini_cheetah"));

TEST(PlanTurn, TakesNoSpeedDistanceGoalOrSteps) {
  WalkRequest fast = TurnRequest(), far = TurnRequest(), to = TurnRequest(), steps = TurnRequest();
  fast.command.speed_m_s = 1.0;
  far.command.distance_m = 2.0;
  to.command.extent = WalkCommand::Extent::kGoal;
  steps.command.extent = WalkCommand::Extent::kSteps;
  for (const WalkRequest& request : {fast, far, to, steps}) {
    const Result<PlannedWalk> planned = PlanWalk(NamedRobot("a1"), request);
    ASSERT_FALSE(planned.ok());
    EXPECT_EQ(planned.failure().kind, FailureKind::kBadInput);
    EXPECT_EQ(planned.failure().code, FailureCode::kCommand);
  }
}

TEST(PlanTurn, IsRefusedOnOtherGroundAndInSequences) {
  WalkRequest request = TurnRequest();
  request.terrain = "slope";
  const Result<PlannedWalk> on_slope = PlanWalk(NamedRobot("a1"), request);
  ASSERT_FALSE(on_slope.ok());
  EXPECT_EQ(on_slope.failure().kind, FailureKind::kInfeasible);
  request = TurnRequest();
  request.sequence = "trot: speed=0.3, distance=0.5; backflip";
  EXPECT_FALSE(PlanWalk(NamedRobot("a1"), request).ok());
}

TEST(PlanTurn, WeakMotorsAreNamed) {
  RobotModel weak = NamedRobot("a1");
  for (Joint& joint : weak.joints) joint.effort_limit *= 0.25;
  const Result<PlannedWalk> planned = PlanWalk(weak, TurnRequest());
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure().kind, FailureKind::kInfeasible);
}

}  // namespace
}  // namespace gaitwright
