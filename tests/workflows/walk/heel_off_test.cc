// SPDX-License-Identifier: BSD-3-Clause
// A walk whose soles turn about their front edges, planned, audited, played in both engines and scored.
#include <gtest/gtest.h>

#include <algorithm>

#include "planning/plan/plan_json.h"
#include "tests/named_robot.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

TEST(HeelOff, AWalkPassesInBothEngines) {
  const RobotModel& model = NamedRobot("nao");
  WalkRequest request;
  request.command.speed_m_s = 0.2;
  request.command.distance_m = 0.3;
  request.motion.trajectory.method = "whole-body";
  request.motion.trajectory.knot_step_s = 0.02;
  request.motion.trajectory.heel_off_rad = 0.2;
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.violations.empty());
  const auto& footholds = planned->motion.plan.footsteps.footholds;
  EXPECT_GT(
      std::count_if(footholds.begin(), footholds.end(), [](const Foothold& f) { return f.heel_off_s.has_value(); }), 2);
  const Result<MotionPlan> read = PlanFromJson(PlanToJson(planned->motion.plan), "plan.json");
  ASSERT_TRUE(read.ok()) << read.failure().message;
  PlayRequest play;
  play.play.world.engine = ProvingEngine();
  const Result<PlayedWalk> played = PlayWalk(model, *read, play);
  ASSERT_TRUE(played.ok()) << played.failure().message;
  EXPECT_TRUE(played->pass()) << played->decisive().report.reason;
}

/// The ankle of the leg behind runs out of range where a flat sole stands 17 cm above the other one.
TEST(HeelOff, RisesOnAStepDownThatFlatSolesCannotDo) {
  const RobotModel& model = NamedRobot("g1");
  WalkRequest request;
  request.terrain = "stairs:rise_m=0.17,tread_m=0.28,count=1,start_m=-0.6,landing_m=0.9";
  request.command.speed_m_s = 0.137;
  request.command.distance_m = 0.7;
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.violations.empty());
  const MotionPlan& plan = planned->motion.plan;
  EXPECT_LT(plan.whole_body.q.back().z(), plan.whole_body.q.front().z() - 0.15);
  EXPECT_TRUE(
      std::ranges::any_of(plan.footsteps.footholds, [](const Foothold& f) { return f.heel_off_s.has_value(); }));
  PlayRequest play;
  play.play.world.engine = ProvingEngine();
  const Result<PlayedWalk> played = PlayWalk(model, plan, play);
  ASSERT_TRUE(played.ok()) << played.failure().message;
  EXPECT_TRUE(played->pass()) << played->decisive().report.reason;
}

}  // namespace
}  // namespace gaitwright
