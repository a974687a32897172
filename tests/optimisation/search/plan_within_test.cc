// SPDX-License-Identifier: BSD-3-Clause
// Invalid requests are refused before anything is planned, by the stage that checks them.
#include "optimisation/search/plan_within.h"

#include <gtest/gtest.h>

#include <string>

#include "optimisation/search/plan_parts.h"
#include "planning/gait/find_gait.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

WalkRequest ForwardBy(double distance_m, const std::string& gait = "") {
  WalkRequest request;
  request.gait = gait;
  request.command.distance_m = distance_m;
  return request;
}

AskedPart ForwardPart(const std::string& gait, double speed_m_s = 0.2) {
  AskedPart part{gait, {}};
  part.command.speed_m_s = speed_m_s;
  part.command.distance_m = 0.2;
  return part;
}

AskedPart StandFor(double duration_s) {
  AskedPart part{"stand", {}};
  part.command.extent = WalkCommand::Extent::kDuration;
  part.command.duration_s = duration_s;
  return part;
}

TEST(PlanWithin, AGaitThatDoesNotExistIsRefusedAsByFindGait) {
  SearchTrace trace;
  const RobotModel& a1 = NamedRobot("a1");
  const Result<PlannedWalk> planned = PlanWithin(a1, FlatTerrain(), ForwardBy(0.3, "tort"), &trace);
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure(), FindGait(a1, "tort", CommandedSpeed(a1, {}), {}).failure());
  EXPECT_EQ(planned.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(planned.failure().code, FailureCode::kGait);
  EXPECT_TRUE(trace.empty()) << "nothing was planned";
}

TEST(PlanWithin, AContradictoryCommandHasNoSlowerWalkInstead) {
  SearchTrace trace;
  WalkRequest request = ForwardBy(-0.3);
  const Result<PlannedWalk> planned = PlanWithin(NamedRobot("a1"), FlatTerrain(), request, &trace);
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(planned.failure().code, FailureCode::kCommand);
  for (const Suggestion& suggestion : planned.failure().suggestions) EXPECT_NE(suggestion.what, "speed");
}

TEST(PlanWithin, WithoutGroundThereIsNoWalkAtAnyPace) {
  Terrain nothing;
  WalkRequest request = ForwardBy(0.3);
  request.command.speed_m_s = 0.2;
  const Result<PlannedWalk> planned = PlanWithin(NamedRobot("a1"), nothing, request);
  ASSERT_FALSE(planned.ok());
  for (const Suggestion& suggestion : planned.failure().suggestions) EXPECT_NE(suggestion.what, "speed");
}

/// Number of leaps of a plan of an A1's jump that keeps room for controllers.
int LeapsOf(const WalkRequest& request, int at_least = 1) {
  const Result<PlannedWalk> planned = PlanInFewestStrides(NamedRobot("a1"), FlatTerrain(), request, at_least);
  EXPECT_TRUE(planned.ok()) << planned.failure().message;
  if (!planned) return 0;
  EXPECT_TRUE(planned->audit.violations.empty());
  const std::optional<FinishReport>& finished = planned->motion.finished;
  EXPECT_TRUE(finished && finished->keeps_room && finished->effort_use > 0.3 && finished->effort_use <= 0.85);
  return static_cast<int>(planned->motion.plan.swings.size()) / 4;
}

TEST(PlanInFewestStrides, LeapsAreAsFewAsMotorsAllow) {
  EXPECT_EQ(LeapsOf(ForwardBy(0.6, "jump")), 1);
  EXPECT_EQ(LeapsOf(ForwardBy(0.6, "jump"), 2), 2) << "at least as many as given";
  EXPECT_EQ(LeapsOf(ForwardBy(1.0, "jump")), 2);
}

TEST(PlanInFewestStrides, TurnsAreLeapsToo) {
  WalkRequest turn = ForwardBy(0.0, "jump");
  turn.command.extent = WalkCommand::Extent::kGoal;
  turn.command.goal_yaw_rad = 1.57;
  EXPECT_EQ(LeapsOf(turn), 1);
}

TEST(PlanInFewestStrides, ADistanceBeyondAllNumbersOfLeapsIsRefused) {
  const Result<PlannedWalk> planned = PlanInFewestStrides(NamedRobot("a1"), FlatTerrain(), ForwardBy(20.0, "jump"), 1);
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure().kind, FailureKind::kInfeasible);
}

TEST(PlanPartsWithin, AGaitThatDoesNotExistIsNamedWithItsPart) {
  const RobotModel& a1 = NamedRobot("a1");
  const Failure alone = FindGait(a1, "tort", 0.2, {}).failure();
  for (const std::size_t wrong : {0U, 2U}) {
    std::vector<AskedPart> parts = {ForwardPart("trot"), StandFor(0.5), ForwardPart("trot")};
    parts[wrong].gait = "tort";
    const Result<PlannedWalk> planned = PlanPartsWithin(a1, FlatTerrain(), {}, parts);
    ASSERT_FALSE(planned.ok());
    EXPECT_EQ(planned.failure(), OfPart(wrong, "tort", alone));
    EXPECT_NE(planned.failure().message.find("part " + std::to_string(wrong + 1)), std::string::npos);
  }
}

TEST(PlanPartsWithin, AStandThatIsTooShortIsABadCommand) {
  SearchTrace trace;
  const std::vector<AskedPart> parts = {ForwardPart("trot"), StandFor(0.01), ForwardPart("trot")};
  const Result<PlannedWalk> planned = PlanPartsWithin(NamedRobot("a1"), FlatTerrain(), {}, parts, &trace);
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(planned.failure().code, FailureCode::kCommand);
  EXPECT_NE(planned.failure().message.find("part 2"), std::string::npos) << planned.failure().message;
  EXPECT_TRUE(trace.empty()) << "no part was planned alone";
}

TEST(PlanPartsWithin, StandingStillAloneIsAPlanThatStands) {
  WalkRequest request;
  request.motion.pipeline.grid_step_s = 0.01;
  const Result<PlannedWalk> planned = PlanPartsWithin(NamedRobot("a1"), FlatTerrain(), request, {StandFor(0.3)});
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  const MotionPlan& plan = planned->motion.plan;
  EXPECT_TRUE(planned->audit.pass());
  ASSERT_EQ(plan.parts.size(), 1U);
  EXPECT_TRUE(StandsStill(plan.parts[0].gait));
  EXPECT_TRUE(plan.swings.empty());
  EXPECT_TRUE(plan.adjustments.empty());
  EXPECT_LT((plan.whole_body.q.back() - plan.whole_body.q.front()).norm(), 1e-6);
}

}  // namespace
}  // namespace gaitwright
