// SPDX-License-Identifier: BSD-3-Clause
// Jumps and flips as plans: audited, played in both engines and scored.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "kinematics/spatial/rotation.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/plan/carried_plan.h"
#include "tests/workflows/words/told_tasks.h"
#include "workflows/words/plan_tasks_internal.h"

namespace gaitwright {
namespace {

using tasks_in_words::Planned;

RobotModel Jumper() { return LoadNamedRobot("a1").value(); }

/// Plans and audits, then plays in both engines; all must pass.
Done DoneInBoth(const std::string& text, const Terrain& terrain) {
  SCOPED_TRACE(text);
  const RobotModel a1 = Jumper();
  Result<PlannedTasks> planned = PlannedInWords(a1, text, terrain);
  EXPECT_TRUE(planned.ok()) << (planned ? "" : planned.failure().message);
  if (!planned) return {};
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  PlayRequest request;
  request.play.world.engine = ProvingEngine();
  const Result<PlayedWalk> played = PlayWalk(a1, planned->plan, request);
  EXPECT_TRUE(played.ok()) << (played ? "" : played.failure().message);
  if (!played) return {};
  EXPECT_TRUE(played->pass()) << played->decisive().report.reason;
  testing::Test::RecordProperty("score", std::to_string(played->score()));
  return {std::move(*planned), *played};
}

/// Base at the end of the plan, in plan view, and its height above that of standing.
struct EndOfJump {
  PlanarPose base;
  double height_m = 0.0, joints = 0.0;
};

EndOfJump EndOf(const Done& done) {
  const VectorX &q = done.planned.plan.whole_body.q.back(), standing = StandingConfiguration(Jumper());
  return {BaseInPlan(q), q[2] - standing[2], (q - standing).tail(q.size() - 7).cwiseAbs().maxCoeff()};
}

void ExpectStanding(const EndOfJump& end, double ground_m = 0.0) {
  EXPECT_NEAR(end.height_m, ground_m, 3e-3);
  EXPECT_LT(end.joints, 0.05) << "the end is nearly the standing posture";
}

TEST(Jumps, AreJoinedWithOtherTasks) {
  const Done done = DoneInBoth("walk forward 1 m, jump 0.4 m forward, turn left, then sit", FlatTerrain());
  ASSERT_EQ(done.planned.task_ends_s.size(), 4U);
  EXPECT_NEAR(LongestFlight(done.planned.plan.schedule), 0.3, 0.1);
  const EndOfJump end = EndOf(done);
  EXPECT_NEAR(end.base.yaw_rad, 0.5 * std::numbers::pi, 0.02);
  EXPECT_GT(end.base.x_m, 1.2);
}

/// A jump ends beside the standing posture by millimetres, which the robot settles before the next task.
TEST(Jumps, AreFollowedByAnyTask) {
  for (const char* text : {"jump back 30 cm, then sit", "jump 20 cm forward, then bow, then lie down"}) {
    const Result<PlannedTasks> planned = Planned("a1", text, FlatTerrain());
    ASSERT_TRUE(planned.ok()) << text << ": " << planned.failure().message;
    EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  }
}

TEST(Jumps, GoToTheRequestedPlace) {
  struct Case {
    const char* text;
    PlanarPose end;
  };
  for (const Case& c :
       {Case{"jump three times", {0.0, 0.0, 0.0}}, Case{"jump back 30 cm", {-0.3, 0.0, 0.0}},
        Case{"jump 20 cm to the right", {0.0, -0.2, 0.0}},
        Case{"jump 0.3 m forward with a quarter turn to the left", {0.3, 0.0, 0.5 * std::numbers::pi}}}) {
    const Done done = DoneInWords(Jumper(), c.text, FlatTerrain());
    const EndOfJump end = EndOf(done);
    EXPECT_NEAR(end.base.x_m, c.end.x_m, 0.02) << c.text;
    EXPECT_NEAR(end.base.y_m, c.end.y_m, 0.01) << c.text;
    EXPECT_NEAR(end.base.yaw_rad, c.end.yaw_rad, 0.02) << c.text;
    ExpectStanding(end);
  }
}

TEST(Jumps, TurnInTheAir) {
  const EndOfJump end = EndOf(DoneInBoth("jump with a quarter turn to the left", FlatTerrain()));
  EXPECT_NEAR(end.base.yaw_rad, 0.5 * std::numbers::pi, 0.02);
  ExpectStanding(end);
}

TEST(Jumps, SeveralLeapsOfOneJumpAreReported) {
  const Result<PlannedTasks> planned = Planned("a1", "jump 1 m forward", FlatTerrain());
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  ASSERT_EQ(planned->notes.size(), 1U);
  EXPECT_EQ(planned->notes[0], "'jump 1 m forward' takes 2 leaps");
}

TEST(Jumps, GoOntoABlockAndDownFromIt) {
  const Terrain block = MakeTerrain("block:height_m=0.2,start_m=0.31,length_m=0.9", ScaleOf(Jumper())).value();
  const EndOfJump up = EndOf(DoneInBoth("jump onto the block", block));
  ExpectStanding(up, 0.2);
  const Terrain below = MakeTerrain("block:height_m=0.2,start_m=-1.5,length_m=1.72", ScaleOf(Jumper())).value();
  const EndOfJump down = EndOf(DoneInBoth("jump down", below));
  EXPECT_GT(down.base.x_m, 0.45);
  ExpectStanding(down);
}

TEST(Jumps, ThereIsNothingLowerOnFlatGround) {
  const Result<PlannedTasks> planned = Planned("a1", "jump down", FlatTerrain());
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure().code, FailureCode::kPlace);
  EXPECT_NE(planned.failure().message.find("lower ground"), std::string::npos) << planned.failure().message;
}

TEST(Jumps, GoToAMarker) {
  const Done done = DoneInWords(Jumper(), "jump to the red marker", tasks_in_words::WithMarkers());
  const VectorX& q = done.played.log.samples.back().q;
  EXPECT_LT((Vector2(q[0], q[1]) - Vector2(0.5, 0.0)).norm(), 0.05);
}

/// After the flip, the base is where the gait's own travel leads, with its heading and height as before.
TEST(Flips, ABackflipEndsWhereItsGaitLeads) {
  const Done done = DoneInBoth("do a backflip", FlatTerrain());
  const EndOfJump end = EndOf(done);
  EXPECT_NEAR(end.base.yaw_rad, 0.0, 1e-3);
  EXPECT_NEAR(end.base.y_m, 0.0, 1e-3);
  EXPECT_LT(end.base.x_m, -0.1);
  ExpectStanding(end);
  double most_tilt = 1.0;
  for (const VectorX& q : done.planned.plan.whole_body.q) most_tilt = std::min(most_tilt, BaseRotation(q)(2, 2));
  EXPECT_LT(most_tilt, -0.95) << "the body is upside down at some time";
}

/// Feet land so that they end at their places of the standing posture, from which any task goes on.
TEST(Flips, AndJumpsWithATurnAreFollowedByAnyTask) {
  for (const char* words : {"do a backflip, then walk 0.5 m", "jump with a quarter turn to the left, then trot 0.5 m",
                            "do a barrel roll to the left, then sit"}) {
    const Done done = DoneInBoth(words, FlatTerrain());
    EXPECT_EQ(done.planned.task_ends_s.size(), 2U) << words;
  }
}

/// Legs that are too weak or too slow refuse as `walk --gait` does.
TEST(Jumps, WhatMotorsDoNotAllowIsRefusedByTheirLimit) {
  const Result<PlannedTasks> planned = Planned("nao", "nod, then jump", FlatTerrain());
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure().code, FailureCode::kLegsTooSlow);
  for (const char* text : {"task 2, 'jump'", "lift-off speed", "KneePitch"})
    EXPECT_NE(planned.failure().message.find(text), std::string::npos) << planned.failure().message;
  for (const Suggestion& said : planned.failure().suggestions)
    EXPECT_EQ(said.text.find("--set gait."), std::string::npos);
}

/// A biped whose motors allow it jumps by its own gait for leaps.
TEST(Jumps, ABipedHops) {
  const Done done = DoneInWords(LoadNamedRobot("humanoid").value(), "jump", FlatTerrain());
  EXPECT_GT(LongestFlight(done.planned.plan.schedule), 0.03);
}

TEST(TaskJumps, AJumpIsAskedOfTheGaitForLeaps) {
  const WalkRequest in_place = tasks::JumpRequestOf(Jumper(), {}, {});
  EXPECT_EQ(in_place.gait, "jump");
  EXPECT_EQ(in_place.command.extent, WalkCommand::Extent::kSteps);
  EXPECT_EQ(in_place.command.steps, 4);
  EXPECT_TRUE(in_place.motion.pipeline.end_as_standing);
  const WalkRequest lateral = tasks::JumpRequestOf(Jumper(), {Vector2(0.0, 0.2), 0.5}, {});
  EXPECT_EQ(lateral.command.extent, WalkCommand::Extent::kGoal);
  EXPECT_EQ(lateral.command.goal_y_m, 0.2);
  EXPECT_EQ(lateral.command.goal_yaw_rad, 0.5);
}

}  // namespace
}  // namespace gaitwright
