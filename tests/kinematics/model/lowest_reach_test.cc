// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/lowest_reach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

/// A joint about y (positive angles move parts in front down) or along an axis.
Joint MadeJoint(int parent, const Vector3& at, double lower, double upper) {
  Joint joint;
  joint.parent_body = parent;
  joint.X_PJ.translation() = at;
  joint.axis_J = Vector3::UnitY();
  joint.lower = lower;
  joint.upper = upper;
  return joint;
}

/// An arm that is level at zero, 1 m up: upper arm 0.5 m, forearm 0.4 m to a joint at its end.
RobotModel Arm(double shoulder, double elbow) {
  RobotModel model;
  model.joints = {MadeJoint(0, {0.0, 0.0, 1.0}, -shoulder, shoulder), MadeJoint(1, {0.5, 0.0, 0.0}, 0.0, elbow),
                  MadeJoint(2, {0.4, 0.0, 0.0}, -1.0, 1.0)};
  model.bodies.resize(4);
  return model;
}

TEST(LowestReach, StopsAtTheLimitsOfItsJoints) {
  EXPECT_NEAR(LowestReach(Arm(0.5, 0.3), {0, 1, 2}), 1.0 - 0.5 * std::sin(0.5) - 0.4 * std::sin(0.8), 1e-5);
  EXPECT_NEAR(LowestReach(Arm(3.0, 3.0), {0, 1, 2}), 0.1, 1e-5) << "straight down";
  // With an elbow bent by a right angle or more, the end is lowest below the shoulder.
  RobotModel bent = Arm(4.0, 2.0);
  bent.joints[1].lower = 0.5 * std::numbers::pi;
  EXPECT_NEAR(LowestReach(bent, {0, 1, 2}), 1.0 - std::hypot(0.5, 0.4), 1e-5);
}

TEST(LowestReach, AWaistThatTurnsLowersNoShoulder) {
  RobotModel model = Arm(3.0, 3.0);
  model.joints[0].axis_J = Vector3::UnitZ();
  EXPECT_NEAR(LowestReach(model, {0, 1, 2}), 0.6, 1e-5);
}

TEST(LowestReach, SlidesGoToTheirLowerEndAndEndlessOnesNowhere) {
  RobotModel model = Arm(0.0, 0.0);
  model.joints[2].type = JointType::kPrismatic;
  model.joints[2].axis_J = Vector3::UnitZ();
  EXPECT_NEAR(LowestReach(model, {0, 1, 2}), 0.0, 1e-9);
  model.joints[2].lower = -std::numeric_limits<double>::infinity();
  EXPECT_NEAR(LowestReach(model, {0, 1, 2}), 1.0, 1e-9);
}

TEST(LowestReach, TheEndIsAllOfTheLastBody) {
  RobotModel model = Arm(3.0, 3.0);
  Shape ball;
  ball.type = ShapeType::kSphere;
  ball.body = 3;
  ball.X_BS.translation() = Vector3(0.0, 0.2, 0.0);
  ball.size = Vector3(0.05, 0.0, 0.0);
  model.collision_shapes = {ball};
  EXPECT_NEAR(LowestReach(model, {0, 1, 2}), 0.1 - 0.25, 1e-5);
}

/// The shoulders are 0.43 m above the joint of the waist, so from there the arms are as long as the legs.
TEST(LowestReach, ArmsAboveAWaistAreNoLegs) {
  const RobotModel h1 = Robot("h1");
  ASSERT_EQ(h1.legs.size(), 2U);
  EXPECT_EQ(h1.feet[0].link, "left_ankle_link");
  EXPECT_EQ(h1.feet[0].type, FootType::kLine);
}

}  // namespace
}  // namespace gaitwright
