// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/can_walk.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "tests/built_paths.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

void ExpectRefused(const std::string& urdf, FailureCode code, const std::vector<std::string>& parts) {
  const Result<RobotModel> model = LoadRobotFromText(urdf, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const auto failure = ReasonCannotWalk(*model);
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->kind, FailureKind::kInfeasible);
  EXPECT_EQ(failure->code, code);
  for (const std::string& part : parts)
    EXPECT_NE(failure->message.find(part), std::string::npos) << "'" << failure->message << "' lacks '" << part << "'";
}

TEST(CanWalk, ABipedOnTwoPointsCannotStandStillButFallsFromFootToFoot) {
  const RobotModel model = LoadRobotFromText(unusual::PointBiped(), "").value();
  EXPECT_FALSE(ReasonCannotWalk(model).has_value());
  const auto failure = ReasonCannotStand(model);
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->code, FailureCode::kNoSupport);
  for (const char* part : {"cannot stand still", "'a_foot'", "'b_foot'", "two points"})
    EXPECT_NE(failure->message.find(part), std::string::npos) << failure->message;
  EXPECT_FALSE(ReasonCannotStand(LoadNamedRobot("nao").value()).has_value());
}

TEST(CanWalk, FeetWithoutAnyShapeAreSaidToHaveNone) {
  std::string urdf = unusual::PointBiped();
  const std::string ball = unusual::UrdfText().Ball(0.02);
  for (std::size_t at = 0; (at = urdf.find(ball)) != std::string::npos;) urdf.erase(at, ball.size());
  ExpectRefused(urdf, FailureCode::kNoSupport, {"'a_foot'", "'b_foot'", "neither collision nor visual geometry"});
}

TEST(CanWalk, ALegNeedsAMotorAtEachOfItsJoints) {
  unusual::UrdfText::Motion knee = unusual::Knee();
  knee.effort = 0.0;
  ExpectRefused(unusual::FourLegged(unusual::Abduction(), knee), FailureCode::kPassiveJoint,
                {"leg 'a_foot'", "'a3_joint'"});
}

TEST(CanWalk, LegsOnOneAxisAreTheHalvesOfOneLeg) {
  ExpectRefused(unusual::OpenFiveBars(), FailureCode::kParallelLegs, {"'a_foot'", "'b_foot'", "two halves of one leg"});
}

TEST(CanWalk, ALegNeedsTwoFreedomsAndThreeToSidestep) {
  ExpectRefused(unusual::Pantograph(), FailureCode::kFreedoms, {"leg 'a_foot'", "1 of 2", "'a1_joint', 'a2_joint'"});
  const RobotModel planar = LoadRobotFromText(unusual::Planar(), "").value();
  EXPECT_FALSE(ReasonCannotWalk(planar).has_value()) << "straight ahead it can";
  const auto failure = ReasonCannotSidestep(planar);
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->code, FailureCode::kFreedoms);
  for (const char* part :
       {"leg 'a_foot'", "2 of 3", "lacks a joint to move its foot sideways;", "'a2_joint', 'a3_joint'"})
    EXPECT_NE(failure->message.find(part), std::string::npos) << failure->message;
  EXPECT_TRUE(ReasonCannotTurn(planar).has_value());
}

TEST(CanWalk, OthersCan) {
  for (const std::string& urdf :
       {unusual::Plain(), unusual::Telescopic(), unusual::Insect(), unusual::Tripod(), unusual::Wheeled(),
        unusual::SoledBiped(true, false), LoadNamedRobot("a1")->urdf_text, LoadNamedRobot("nao")->urdf_text}) {
    const auto failure = ReasonCannotWalk(*LoadRobotFromText(urdf, ""));
    EXPECT_FALSE(failure.has_value()) << failure->message;
  }
}

TEST(CanWalk, TurningTakesAJointForEachSole) {
  for (const char* name : {"a1", "nao", "h1"}) {
    const auto failure = ReasonCannotTurn(*LoadNamedRobot(name));
    EXPECT_FALSE(failure.has_value()) << failure->message;
  }
  const RobotModel stork = LoadRobot(SourceFolder() + "/examples/robots/stork.urdf", "none").value();
  EXPECT_FALSE(ReasonCannotWalk(stork).has_value());
  const auto failure = ReasonCannotTurn(stork);
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->code, FailureCode::kFreedoms);
  for (const char* part : {"leg 'sx_piede' cannot turn", "5 of 6", "lacks a joint to yaw its sole;"})
    EXPECT_NE(failure->message.find(part), std::string::npos) << failure->message;
}

}  // namespace
}  // namespace gaitwright
