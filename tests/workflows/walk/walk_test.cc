// SPDX-License-Identifier: BSD-3-Clause
// The decisive playback, and refusals before playback.
#include "workflows/walk/walk.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "planning/plan/robot_of_plan.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

PlayedWalk PlayedBy(bool first_passes, double first_score, bool second_passes, double second_score) {
  PlayedWalk walk;
  walk.report.pass = first_passes;
  walk.report.score = first_score;
  SecondPlayback second;
  second.report.pass = second_passes;
  second.report.score = second_score;
  walk.second = std::make_shared<const SecondPlayback>(second);
  return walk;
}

TEST(PlayedWalk, BothEnginesMustPassAndTheLowerScoreCounts) {
  EXPECT_TRUE(PlayedBy(true, 80.0, true, 70.0).pass());
  EXPECT_FALSE(PlayedBy(true, 80.0, false, 20.0).pass());
  EXPECT_FALSE(PlayedBy(false, 20.0, true, 80.0).pass());
  EXPECT_EQ(PlayedBy(true, 80.0, true, 70.0).score(), 70.0);
  EXPECT_EQ(PlayedBy(true, 60.0, true, 70.0).score(), 60.0);
  PlayedWalk alone;
  alone.report.pass = true;
  alone.report.score = 55.0;
  EXPECT_TRUE(alone.pass());
  EXPECT_EQ(alone.score(), 55.0);
  EXPECT_EQ(&alone.decisive(), &alone);
}

TEST(PlayedWalk, TheOneThatFailsDecidesElseTheLowerScore) {
  const auto second_decides = [](const PlayedWalk& walk) {
    return &walk.decisive() == static_cast<const ScoredPlayback*>(walk.second.get());
  };
  EXPECT_TRUE(second_decides(PlayedBy(true, 10.0, false, 90.0))) << "a fail outweighs any score";
  EXPECT_FALSE(second_decides(PlayedBy(false, 90.0, true, 10.0)));
  EXPECT_TRUE(second_decides(PlayedBy(true, 80.0, true, 70.0)));
  EXPECT_FALSE(second_decides(PlayedBy(true, 70.0, true, 80.0)));
  EXPECT_FALSE(second_decides(PlayedBy(true, 70.0, true, 70.0))) << "the first of equal ones";
}

// Explicit gains are bounded by the step and the delay of the sensor feedback loop.
TEST(GainsFor, ExplicitTorquesKnowTheirStep) {
  PlayRequest request;
  EXPECT_EQ(GainsFor(request).explicit_step_s, 0.0) << "implicit PD needs no bound";
  request.play.world.actuation = "torque";
  request.play.world.step_s = 0.002;
  EXPECT_EQ(GainsFor(request).explicit_step_s, 0.002);
  request.sensing.drive_loop = "sensed";
  EXPECT_EQ(GainsFor(request).explicit_step_s, 0.002 + request.sensing.LoopDelay());
  request.gains.explicit_step_s = 0.005;
  EXPECT_EQ(GainsFor(request).explicit_step_s, 0.005) << "as given";
}

TEST(CheckController, NamesThoseThatThereAre) {
  for (const std::string& name : ControllerNames()) EXPECT_NO_THROW(CheckController(name));
  try {
    CheckController("stabilized");
    ADD_FAILURE();
  } catch (const InvalidArgument& error) {
    for (const std::string& name : ControllerNames())
      EXPECT_NE(std::string(error.what()).find("'" + name + "'"), std::string::npos) << error.what();
  }
}

TEST(RobotOf, APlanIsOfTheRobotInIt) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  MotionPlan plan = standing::Plan(a1, 0.1);
  SetRobot(a1, plan);
  const Result<RobotModel> robot = RobotOf(plan);
  ASSERT_TRUE(robot.ok()) << robot.failure().message;
  EXPECT_EQ(robot->hash, a1.hash);
  plan.robot_hash = "0123456789abcdef";
  const Result<RobotModel> other = RobotOf(plan);
  ASSERT_FALSE(other.ok());
  EXPECT_EQ(other.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(other.failure().code, FailureCode::kRobotHash);
}

TEST(MakeController, ASensedLoopNeedsTorques) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  const MotionPlan plan = standing::Plan(a1, 0.1);
  PlayRequest request;
  request.sensing.drive_loop = "sensed";
  EXPECT_THROW(MakeController(a1, plan, request), InvalidArgument);
  request.play.world.actuation = "torque";
  EXPECT_EQ(MakeController(a1, plan, request)->Name(), "stabilised");
}

TEST(ChangedOptions, AreThoseOfPlanAndPlayback) {
  MotionPlan plan;
  PlaybackLog log;
  PlayRequest play;
  log.options = TextsOf(play.Fields());
  EXPECT_TRUE(ChangedOptions(plan, log).empty());
  for (auto& [key, text] : log.options) {
    if (key == "play.friction") text = "0.3";
  }
  const std::vector<OptionChange> changes = ChangedOptions(plan, log);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].key, "play.friction");
}

}  // namespace
}  // namespace gaitwright
