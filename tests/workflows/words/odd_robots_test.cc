// SPDX-License-Identifier: BSD-3-Clause
// Robots in examples/robots that were not made for the program: from their URDF alone they get up and walk a metre.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/model/load_robot.h"
#include "tests/built_paths.h"
#include "tests/workflows/words/done_in_words.h"

namespace gaitwright {
namespace {

RobotModel Odd(const std::string& name) {
  return LoadRobot(SourceFolder() + "/examples/robots/" + name + ".urdf", "none").value();
}

class OddRobot : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, OddRobot, testing::Values("hexapod", "goat", "stork"),
                         [](const auto& name) { return name.param; });

TEST_P(OddRobot, StandsUpAndWalksAMetre) {
  const Done up = DoneInWords(Odd(GetParam()), "stand up, then stand still for a second", FlatTerrain());
  EXPECT_LT(ZmpErrorAtEnd(up), 0.012);
  const Done walked = DoneInWords(Odd(GetParam()), "walk forward one metre", FlatTerrain());
  const auto& q = walked.played.log.samples;
  EXPECT_NEAR(q.back().q[0] - q.front().q[0], 1.0, 0.05);
}

TEST_P(OddRobot, HasARepertoire) {
  DoneInWords(Odd(GetParam()), "stand up, take a step back, side-step left 5 cm, squat, bow, and nod", FlatTerrain());
}

TEST(OddRobots, TheGoatTrotsTurnsAndSits) {
  DoneInWords(Odd("goat"), "stand up, trot half a metre, turn left, brace yourself, then sit", FlatTerrain());
}

/// Its servos allow the default speed of its leg length only with its whole body optimised; weaker ones do not.
TEST(OddRobots, TheHexapodIsAsFastAsItsServos) {
  RobotModel hexapod = Odd("hexapod");
  WalkRequest request;
  request.command.distance_m = 0.2;
  const Result<PlannedWalk> own = PlanWalk(hexapod, request);
  ASSERT_TRUE(own.ok()) << own.failure().message;
  EXPECT_TRUE(own->motion.finished) << "the whole body is optimised";
  EXPECT_TRUE(own->audit.pass());
  EXPECT_TRUE(own->motion.plan.adjustments.empty());

  for (Joint& joint : hexapod.joints) joint.velocity_limit *= 0.5;
  const Result<PlannedWalk> slow = PlanWalk(hexapod, request);
  ASSERT_TRUE(slow.ok()) << slow.failure().message;
  const double speed = slow->motion.plan.parts.front().command.speed_m_s;
  EXPECT_GT(speed, 0.0);
  EXPECT_LT(speed, hexapod.nominal_speed_m_s);
  const std::vector<Adjustment>& adjustments = slow->motion.plan.adjustments;
  const auto lowered =
      std::find_if(adjustments.begin(), adjustments.end(), [](const auto& a) { return a.what == "speed"; });
  ASSERT_NE(lowered, adjustments.end());
  EXPECT_EQ(lowered->unit, "m/s");
  EXPECT_NEAR(lowered->asked, hexapod.nominal_speed_m_s, 1e-12);
  EXPECT_EQ(lowered->given, speed);
  EXPECT_EQ(lowered->why, FailureCode::kLimits);
}

TEST(OddRobots, TheHexapodTurnsAndCrouches) {
  DoneInWords(Odd("hexapod"), "turn left 30 degrees, then crouch walk 10 cm", FlatTerrain());
}

/// Its legs have half its weight and are near the ground: in a brace they must carry their own weight there.
TEST(OddRobots, TheHexapodBraces) { DoneInWords(Odd("hexapod"), "brace yourself", FlatTerrain()); }

/// With knees that point at each other and feet directly under the hips, the body cannot reach the ground.
TEST(OddRobots, ARobotThatCannotLieIsRefusedWithTheReasonAndGetsUpFromACrouch) {
  for (const auto& [name, why] :
       {std::pair("goat", "'TORSO' and 'Q3c' would collide"), std::pair("hexapod", "too close below")}) {
    const Result<PlannedTasks> lying = PlannedInWords(Odd(name), "lie down", FlatTerrain());
    ASSERT_FALSE(lying.ok());
    EXPECT_NE(lying.failure().message.find(why), std::string::npos) << lying.failure().message;
    const PlannedTasks up = PlannedInWords(Odd(name), "stand up", FlatTerrain()).value();
    EXPECT_GT(up.plan.centroidal.p_WC.back().z() - up.plan.centroidal.p_WC.front().z(), 0.1 * Odd(name).leg_length_m());
    ASSERT_FALSE(up.notes.empty());
    EXPECT_NE(up.notes.front().find(why), std::string::npos) << up.notes.front();
  }
}

TEST(OddRobots, TheStorkSaysThatItCannotTurn) {
  const Result<PlannedTasks> turned = PlannedInWords(Odd("stork"), "turn left", FlatTerrain());
  ASSERT_FALSE(turned.ok());
  EXPECT_NE(turned.failure().message.find("no joints that yaw its soles"), std::string::npos)
      << turned.failure().message;
  WalkRequest curve;
  curve.command.distance_m = 1.0;
  curve.command.yaw_rate_rad_s = 0.1;
  const Result<PlannedWalk> curved = PlanWalk(Odd("stork"), curve);
  ASSERT_FALSE(curved.ok());
  EXPECT_EQ(curved.failure().code, FailureCode::kFreedoms);
  EXPECT_NE(curved.failure().message.find("cannot turn while it walks"), std::string::npos) << curved.failure().message;
}

}  // namespace
}  // namespace gaitwright
