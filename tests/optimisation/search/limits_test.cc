// SPDX-License-Identifier: BSD-3-Clause
// Walks within the robot's limits pass their audit; others are refused, with a feasible alternative.
#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/model/load_robot.h"
#include "optimisation/search/refuse_walk.h"
#include "tests/built_paths.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

using Extent = WalkCommand::Extent;

WalkRequest Asked(double speed, double lateral, double yaw_rate) {
  WalkRequest request;
  request.command.speed_m_s = speed;
  request.command.lateral_speed_m_s = lateral;
  request.command.yaw_rate_rad_s = yaw_rate;
  if (speed != 0.0 || lateral != 0.0) request.command.distance_m = 0.3;
  return request;
}

void ExpectSound(const Result<PlannedWalk>& planned) {
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  EXPECT_TRUE(BrokenLimits(planned->audit).empty());
}

void ExpectPasses(const RobotModel& model, const WalkRequest& request) { ExpectSound(PlanWalk(model, request)); }

TEST(Limits, CountedStepsOfAnyNumberPassTheirAudit) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = *LoadNamedRobot(name);
    for (int count = 1; count <= 12; ++count) {
      SCOPED_TRACE(testing::Message() << name << ", " << count << " steps");
      WalkRequest request;
      request.command.extent = Extent::kSteps;
      request.command.steps = count;
      request.command.step_length_m = 0.3 * model.leg_length_m() / static_cast<double>(model.feet.size());
      ExpectPasses(model, request);
    }
  }
}

TEST(Limits, SideStepsAndTurnsInOrdinaryRangesAreAtTheSpeedAskedFor) {
  const RobotModel nao = *LoadNamedRobot("nao");
  for (const WalkRequest& request : {Asked(0, -0.04, 0), Asked(0, 0.05, 0), Asked(0, -0.06, 0), Asked(0, 0, 0.4)}) {
    const Result<PlannedWalk> planned = PlanWalk(nao, request);
    ExpectSound(planned);
    if (!planned) continue;
    const MotionPlan& plan = planned->motion.plan;
    EXPECT_LE(plan.parts.front().gait.cycle_s, FindGait(nao, "", nao.nominal_speed_m_s, {})->cycle_s);
    EXPECT_EQ(plan.parts.front().command, request.command);
  }
}

/// Passes of the pendulum exceed torques and ranges of the ankles at this speed.
TEST(Limits, ABipedWalksFastWithItsWholeBodyOptimised) {
  const RobotModel nao = *LoadNamedRobot("nao");
  WalkRequest request = Asked(0.25, 0.0, 0.0);
  request.command.distance_m = 0.4;
  SearchTrace trace;
  const Result<PlannedWalk> planned = PlanWalk(nao, request, &trace);
  ExpectSound(planned);
  EXPECT_TRUE(planned->motion.finished);
  EXPECT_FALSE(trace.front().whole_body);
  EXPECT_TRUE(std::any_of(trace.begin(), trace.end(), [](const auto& tried) { return tried.whole_body; }));
}

TEST(Limits, AGivenTimeOfSteppingStays) {
  const RobotModel nao = *LoadNamedRobot("nao");
  WalkRequest request = Asked(0.0, -0.06, 0.0);
  request.gait_options.cycle_s = 1.4;
  const Result<PlannedWalk> planned = PlanWalk(nao, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  EXPECT_EQ(planned->motion.plan.parts.front().gait.cycle_s, 1.4);
  request.gait_options.cycle_s = 2.8;  // steps that are twice as wide
  const Result<PlannedWalk> slow = PlanWalk(nao, request);
  ASSERT_FALSE(slow.ok());
  EXPECT_EQ(slow.failure().kind, FailureKind::kInfeasible);
  request.motion.pipeline.allow_limits = true;
  const Result<PlannedWalk> any = PlanWalk(nao, request);
  EXPECT_TRUE(!any.ok() || !any->audit.pass());
}

TEST(Limits, AMotorThatTurnsTooFastIsNamedForThatRatherThanForTheTorqueThatItHasLeft) {
  const std::string root = SourceFolder();
  const RobotModel nao = *LoadRobot(root + "/robots/nao/robot.urdf", root + "/examples/motors/nao.yaml");
  WalkRequest request = Asked(0.2, 0.0, 0.0);
  request.command.distance_m = 1.0;
  request.motion.pipeline.allow_limits = true;
  const std::vector<Violation> broken = BrokenLimits(PlanWalk(nao, request)->audit);
  ASSERT_FALSE(broken.empty());
  EXPECT_EQ(broken.front().law, Law::kJointVelocity);
  EXPECT_TRUE(std::any_of(broken.begin(), broken.end(), [](const auto& v) { return v.law == Law::kTorqueSpeed; }));
}

TEST(Limits, WhereNothingIsPossibleNoSpeedIsNamed) {
  RobotModel stiff = *LoadNamedRobot("a1");
  for (Joint& joint : stiff.joints) joint.effort_limit = 0.5;  // less than standing needs
  const Result<PlannedWalk> planned = PlanWalk(stiff, Asked(0.3, 0.0, 0.0));
  ASSERT_FALSE(planned.ok());
  EXPECT_NE(planned.failure().message.find("no speed of robot 'a1' was found"), std::string::npos);
  EXPECT_NE(planned.failure().message.find("N m past its limit of 0.5"), std::string::npos);
  for (const Suggestion& suggestion : planned.failure().suggestions) EXPECT_NE(suggestion.what, "speed");
}

/// The walk must have a sound plan with the cycle of its request, or else of its gait.
void ExpectPassesWithItsCycle(const RobotModel& model, const WalkRequest& request) {
  ExpectPasses(model, request);
  const MotionPlan plan = PlanWalk(model, request)->motion.plan;
  const Gait gait = *FindGait(model, request.gait, CommandedSpeed(model, request.command), request.gait_options);
  EXPECT_NEAR(plan.parts.front().gait.cycle_s, gait.cycle_s, 0.01);
  EXPECT_EQ(plan.parts.front().command, request.command);
}

TEST(Limits, MotionsThatPassesLeaveUnsettledAreFinishedWithTheirCycle) {
  const RobotModel a1 = *LoadNamedRobot("a1"), tripod = *LoadRobotFromText(unusual::Tripod(), "");
  WalkRequest amble = Asked(0.8, 0.0, 0.0), pace = Asked(0.7, 0.0, 0.0), wave = Asked(0.32, 0.0, 0.0);
  amble.gait = "amble";
  pace.gait = "pace";
  wave.gait = "wave";
  wave.command.distance_m = 0.6;
  for (const WalkRequest& request : {amble, pace}) ExpectPassesWithItsCycle(a1, request);
  ExpectPassesWithItsCycle(tripod, wave);
  amble.gait_options.cycle_s = 0.38;
  ExpectPassesWithItsCycle(a1, amble);
  wave.gait_options.cycle_s = 0.72;
  ExpectPassesWithItsCycle(tripod, wave);
}

TEST(Limits, ComeBeforeOtherLaws) {
  AuditReport audit;
  EXPECT_TRUE(Forbidding(audit).empty());
  audit.violations = {{Law::kBodyClearance, 1.0, "trunk", -0.002, 0.0, "m"}};
  audit.violations.push_back({Law::kJointVelocity, 1.2, "FR_hip_joint", 22.0, 21.0, "rad/s"});
  const std::vector<Violation> forbidding = Forbidding(audit);
  ASSERT_EQ(forbidding.size(), 2u);
  EXPECT_EQ(forbidding[0].law, Law::kJointVelocity);
  EXPECT_EQ(LimitText(forbidding[1]), "'trunk' is 2.0 mm in the ground or an obstacle at 1.00 s");
}

}  // namespace
}  // namespace gaitwright
