// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/hands_on.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/result.h"
#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

const RobotModel& HeldRobot() {
  static const RobotModel model = synthetic::Robot(2, FootType::kSole);
  return model;
}

TEST(HandsOnRobots, TheSpringScalesWithWeightAndLeg) {
  const RobotModel& model = HeldRobot();
  const PullSpring spring = PullSpringFor(model);
  EXPECT_NEAR(spring.n_per_m * model.leg_length_m(), 2.0 * model.weight_n(), 1e-9) << "a leg's length, two weights";
  EXPECT_NEAR(spring.most_n, 2.0 * model.weight_n(), 1e-9);
  RobotModel heavy = model;
  heavy.total_mass_kg *= 3.0;
  EXPECT_NEAR(PullSpringFor(heavy).n_per_m, 3.0 * spring.n_per_m, 1e-9);
}

TEST(HandsOnRobots, EachHandHoldsOnePointAndLetsGoOfItsOwn) {
  HandsOn hands(HeldRobot());
  hands.Pull(1, 0, Vector3::Zero(), Vector3::UnitX());
  hands.Pull(2, 0, Vector3::Zero(), Vector3::UnitY());
  hands.Pull(1, 3, Vector3::UnitZ(), Vector3::UnitX());
  ASSERT_EQ(hands.grips().size(), 2U);
  EXPECT_EQ(hands.grips()[0].body, 3);
  EXPECT_EQ(hands.grips()[0].p_Body, Vector3::UnitZ());
  hands.LetGo(1);
  ASSERT_EQ(hands.grips().size(), 1U);
  EXPECT_EQ(hands.grips()[0].hand, 2U);
  hands.LetGo(7);
  EXPECT_EQ(hands.grips().size(), 1U) << "nobody's hand";
  hands.Off();
  EXPECT_TRUE(hands.grips().empty());
}

TEST(HandsOnRobots, PullsThatCannotBeAreRefusedAndChangeNothing) {
  HandsOn hands(HeldRobot());
  const int bodies = static_cast<int>(HeldRobot().bodies.size());
  const Vector3 wild(0.0, std::nan(""), 0.0);
  EXPECT_THROW(hands.Pull(1, -1, Vector3::Zero(), Vector3::Zero()), InvalidArgument);
  EXPECT_THROW(hands.Pull(1, bodies, Vector3::Zero(), Vector3::Zero()), InvalidArgument);
  EXPECT_THROW(hands.Pull(1, 0, wild, Vector3::Zero()), InvalidArgument);
  EXPECT_THROW(hands.Pull(1, 0, Vector3::Zero(), wild), InvalidArgument);
  EXPECT_TRUE(hands.grips().empty());
}

TEST(HandsOnRobots, EightHandsAreTheMost) {
  HandsOn hands(HeldRobot());
  for (HandId hand = 0; hand < HandsOn::kMostGrips; ++hand) hands.Pull(hand, 0, Vector3::Zero(), Vector3::Zero());
  EXPECT_THROW(hands.Pull(99, 0, Vector3::Zero(), Vector3::Zero()), InvalidArgument);
  EXPECT_NO_THROW(hands.Pull(3, 1, Vector3::Zero(), Vector3::Zero())) << "a hand that holds may go on";
  hands.LetGo(0);
  EXPECT_NO_THROW(hands.Pull(99, 0, Vector3::Zero(), Vector3::Zero()));
}

TEST(HandsOnRobots, APushIsOfAtMostTenWeights) {
  HandsOn hands(HeldRobot());
  const double weight_n = HeldRobot().weight_n();
  EXPECT_NO_THROW(hands.Push(Vector3(9.99 * weight_n, 0.0, 0.0), 1.0));
  ASSERT_TRUE(hands.push_W());
  EXPECT_NEAR(hands.push_W()->x(), 9.99 * weight_n, 1e-9);
  EXPECT_THROW(hands.Push(Vector3(0.0, 10.01 * weight_n, 0.0), 1.0), InvalidArgument);
  EXPECT_THROW(hands.Push(Vector3(0.0, std::nan(""), 0.0), 1.0), InvalidArgument);
  hands.Off();
  EXPECT_FALSE(hands.push_W());
}

TEST(HandsOnRobots, ANudgeIsShorterOfAJointThatSlides) {
  RobotModel model = HeldRobot();
  model.joints[1].type = JointType::kRevolute;
  HandsOn hands(model);
  EXPECT_NO_THROW(hands.Nudge(0, 0.3, 1.0));
  EXPECT_THROW(hands.Nudge(0, 0.31, 1.0), InvalidArgument) << "metres";
  EXPECT_NO_THROW(hands.Nudge(1, -1.0, 1.0));
  EXPECT_THROW(hands.Nudge(1, 1.01, 1.0), InvalidArgument) << "radians";
  EXPECT_THROW(hands.Nudge(-1, 0.1, 1.0), InvalidArgument);
  EXPECT_THROW(hands.Nudge(model.num_dofs(), 0.1, 1.0), InvalidArgument);
  EXPECT_THROW(hands.Nudge(1, std::nan(""), 1.0), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
