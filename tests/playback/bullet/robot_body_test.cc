// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "playback/bullet/robot_body_internal.h"
#include "tests/kinematics/made_robots.h"
#include "tests/playback/one_joint.h"

namespace gaitwright::bullet {
namespace {

/// A state with a turned base and moving joints.
struct BodyState {
  VectorX q, v;
};

BodyState SomeState(const RobotModel& model) {
  BodyState state{StandingConfiguration(model), VectorX(model.nv())};
  state.q.head<3>() += Vector3(0.3, -0.2, 1.0);
  state.q.segment<4>(3) = Quaternion(0.8, 0.1, -0.3, 0.5).normalized().coeffs();
  for (Eigen::Index i = 0; i < state.v.size(); ++i) state.v[i] = 0.1 * static_cast<double>(i % 7) - 0.25;
  return state;
}

VectorX OneJointAtRest() {
  VectorX q = VectorX::Zero(8);
  q[6] = 1.0;
  return q;
}

class RobotBodyTest : public testing::TestWithParam<const char*> {
 protected:
  const RobotModel model_ = AnyRobot(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Robots, RobotBodyTest, testing::Values("a1", "nao", "sliding", "hollow", "mimic"),
                         [](const auto& i) { return std::string(i.param); });

// Bullet's base frame is at its centre of mass with principal axes; the state converts back exactly for any place of
// it.
TEST_P(RobotBodyTest, AStateComesBackWhereverTheBasesCentreOfMassIs) {
  const BodyState state = SomeState(model_);
  for (const Vector3& shift_B : {Vector3(0.0, 0.0, 0.0), Vector3(0.05, -0.02, 0.1)}) {
    RobotBody robot(model_, {.base_com_shift_B = shift_B, .locked_dofs = {}, .q0 = StandingConfiguration(model_)});
    robot.SetState(state.q, state.v);
    VectorX q, v;
    robot.GetState(q, v);
    if (q.segment<4>(3).dot(state.q.segment<4>(3)) < 0.0) q.segment<4>(3) *= -1.0;
    EXPECT_LT((q - state.q).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((v - state.v).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST_P(RobotBodyTest, AtRestInTheAirItFallsAsAWhole) {
  RobotBody robot(model_, {.locked_dofs = {}, .q0 = StandingConfiguration(model_)});
  const VectorX a =
      robot.Accelerations(SomeState(model_).q, VectorX::Zero(model_.nv()), VectorX::Zero(model_.num_dofs()));
  EXPECT_LT((a.head<3>() - Vector3(0.0, 0.0, -kGravity)).norm(), 1e-8);
  EXPECT_LT(a.tail(model_.nv() - 3).cwiseAbs().maxCoeff(), 1e-6);
}

TEST_P(RobotBodyTest, TheSharesOfACoordinatesJointsGiveItBack) {
  const RobotBody robot(model_, {.locked_dofs = {}, .q0 = StandingConfiguration(model_)});
  for (int dof = 0; dof < model_.num_dofs(); ++dof) {
    double rate = 0.0;  // of the coordinate, from the joints that follow it
    for (const RobotBody::Member& member : robot.members(dof)) rate += member.share * member.multiplier;
    EXPECT_NEAR(rate, 1.0, 1e-12) << model_.dof_names[static_cast<std::size_t>(dof)];
  }
}

TEST_P(RobotBodyTest, ALockedJointStaysWhereItStartedAndTheOthersDoNot) {
  const VectorX q0 = StandingConfiguration(model_);
  RobotBody robot(model_, {.locked_dofs = {1}, .q0 = q0});
  BodyState state = SomeState(model_);
  state.q[8] += 0.3;
  VectorX q, v;
  robot.SetState(state.q, state.v);
  robot.GetState(q, v);
  EXPECT_EQ(q[8], q0[8]);
  EXPECT_EQ(v[7], 0.0);
  EXPECT_NEAR(q[7], state.q[7], 1e-12);
  EXPECT_TRUE(robot.locked(1));
  EXPECT_EQ(robot.Row(model_.dof_joint[1]), -1);
  const VectorX a = robot.Accelerations(state.q, VectorX::Zero(model_.nv()), VectorX::Ones(model_.num_dofs()));
  EXPECT_EQ(a[7], 0.0);
  EXPECT_NE(a[6], 0.0);
}

TEST_P(RobotBodyTest, TheShapesOfAFootAreKnownAsIts) {
  const RobotBody robot(model_, {.locked_dofs = {}, .q0 = StandingConfiguration(model_)});
  for (std::size_t f = 0; f < model_.feet.size(); ++f) {
    const ColliderPart& part = robot.part(model_.feet[f].body, 0);
    EXPECT_EQ(part.foot, static_cast<int>(f));
    EXPECT_EQ(part.link, model_.feet[f].link);
    EXPECT_EQ(&robot.part(model_.feet[f].body, -1), &part) << "a shape without children is the first";
  }
}

// Two floating bodies: a torque of 2 moves a reduced inertia of 0.8 by 2.5.
TEST(RobotBodyOfOneJoint, ATorqueMovesTheReducedInertia) {
  const VectorX q = OneJointAtRest(), v = VectorX::Zero(7), tau = VectorX::Constant(1, 2.0);
  const auto acceleration = [&](JointType type, double mass_scale, double inertia_scale) {
    const RobotModel model = one_joint::Make(type);
    RobotBody robot(model, {.mass_scale = mass_scale, .inertia_scale = inertia_scale, .locked_dofs = {}, .q0 = q});
    return robot.Accelerations(q, v, tau)[6];
  };
  for (const JointType type : {JointType::kPrismatic, JointType::kRevolute}) {
    EXPECT_NEAR(acceleration(type, 1.0, 1.0), 2.5, 1e-12);
    EXPECT_NEAR(acceleration(type, 2.0, 1.0), 1.25, 1e-12) << "inertias grow with the masses";
  }
  EXPECT_NEAR(acceleration(JointType::kPrismatic, 1.0, 2.0), 2.5, 1e-12) << "moments do not matter to a slide";
  EXPECT_NEAR(acceleration(JointType::kRevolute, 1.0, 2.0), 1.25, 1e-12);
}

}  // namespace
}  // namespace gaitwright::bullet
