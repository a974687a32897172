// SPDX-License-Identifier: BSD-3-Clause
// Motors in MuJoCo: one joint between two floating bodies, whose reduced inertia is 0.8.
#include <gtest/gtest.h>

#include "playback/mujoco/motors_internal.h"
#include "playback/mujoco/mujoco_world.h"
#include "tests/kinematics/made_robots.h"
#include "tests/playback/one_joint.h"

namespace gaitwright {
namespace {

VectorX StartOfJoint() {
  VectorX q = VectorX::Zero(8);
  q[2] = 100.0;
  q[6] = 1.0;
  return q;
}

JointCommand CommandOfOne(double q, double tau_ff, double stiffness, double damping) {
  const auto one = [](double value) { return VectorX(VectorX::Constant(1, value)); };
  return {one(q), one(0.0), one(tau_ff), one(stiffness), one(damping)};
}

/// A world of one joint with an initial rate.
struct JointWorld {
  JointWorld(const RobotModel& robot, double rate, const WorldOptions& options = {})
      : model(robot), world(model, FlatTerrain(), StartOfJoint(), options) {
    VectorX v = VectorX::Zero(7);
    v[6] = rate;
    world.SetState(StartOfJoint(), v);
  }

  RobotModel model;
  MujocoWorld world;
};

class MujocoMotorsTest : public testing::TestWithParam<JointType> {
 protected:
  RobotModel model_ = one_joint::Make(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Types, MujocoMotorsTest, testing::Values(JointType::kPrismatic, JointType::kRevolute),
                         [](const auto& i) { return i.param == JointType::kPrismatic ? "slide" : "hinge"; });

TEST_P(MujocoMotorsTest, ATorqueMovesTheReducedInertia) {
  JointWorld made(model_, 0.0);
  for (int k = 0; k < 10; ++k) made.world.Step(CommandOfOne(0.0, 2.0, 0.0, 0.0));
  EXPECT_NEAR(made.world.v()[6], 10 * 0.001 * 2.0 / one_joint::kInertia, 1e-9);
  EXPECT_NEAR(made.world.tau()[0], 2.0, 1e-9);
}

// I v' = h (kp (q* - h v') - kd v'): with kp 1000, kd 10, q* 0.005 and h 1 ms, v' = 0.005 / 0.811.
TEST_P(MujocoMotorsTest, PdActsAtTheEndOfTheStep) {
  JointWorld made(model_, 0.0);
  made.world.Step(CommandOfOne(0.005, 0.0, 1000.0, 10.0));
  const double rate = made.world.v()[6];
  EXPECT_NEAR(rate, 0.005 / 0.811, 1e-9);
  EXPECT_NEAR(made.world.tau()[0], one_joint::kInertia * rate / 0.001, 1e-6);
}

TEST_P(MujocoMotorsTest, NoGainIsTooStiff) {
  model_.joints[0].effort_limit = 1e9;
  JointWorld made(model_, 0.0);
  for (int k = 0; k < 50; ++k) made.world.Step(CommandOfOne(0.01, 0.0, 1e8, 1e5));
  EXPECT_NEAR(made.world.q()[7], 0.01, 1e-4);
  EXPECT_NEAR(made.world.v()[6], 0.0, 1e-3);
}

TEST_P(MujocoMotorsTest, TheLimitHoldsForTheSumAndIsUsedUp) {
  JointWorld made(model_, 0.0);
  made.world.Step(CommandOfOne(1.0, 5.0, 1000.0, 10.0));
  EXPECT_NEAR(made.world.tau()[0], one_joint::kEffort, 1e-9);
  EXPECT_NEAR(made.world.effort_use()[0], 1.0, 1e-9);
  EXPECT_NEAR(made.world.v()[6], 0.001 * one_joint::kEffort / one_joint::kInertia, 1e-9);
  JointWorld half(model_, 0.0);
  half.world.Step(CommandOfOne(0.0, -5.0, 0.0, 0.0));
  EXPECT_NEAR(half.world.effort_use()[0], 0.5, 1e-9);
}

TEST_P(MujocoMotorsTest, AStopHoldsAtItsLimit) {
  model_.joints[0].upper = 0.01;
  JointWorld made(model_, 2.0);
  for (int k = 0; k < 50; ++k) {
    made.world.Step(CommandOfOne(0.0, one_joint::kEffort, 0.0, 0.0));
    ASSERT_LT(made.world.q()[7], 0.01 + 1e-5) << "at step " << k;
  }
  EXPECT_NEAR(made.world.q()[7], 0.01, 1e-5);
}

TEST_P(MujocoMotorsTest, ALockedJointHasNoMotor) {
  WorldOptions options;
  options.locked_dofs = {0};
  JointWorld made(model_, 0.0, options);
  for (int k = 0; k < 5; ++k) made.world.Step(CommandOfOne(0.1, 5.0, 100.0, 1.0));
  EXPECT_EQ(made.world.tau()[0], 0.0);
  EXPECT_EQ(made.world.q()[7], 0.0);
}

// All joints that follow the coordinate give the same rate for it, so their mean equals it.
TEST(MujocoMotorsOfGears, TheRateOfACoordinateIsThatOfItsJoints) {
  const RobotModel model = AnyRobot("mimic");
  const WorldOptions options;
  const mujoco::ModelPtr m =
      mujoco::Compile(mujoco::WriteModel(model, FlatTerrain(), StandingConfiguration(model), options));
  const mujoco::DataPtr d(mj_makeData(m.get()));
  const mujoco::Motors motors(model, options, *m, *d);
  std::vector<mjtNum> rates(static_cast<std::size_t>(m->nv), 0.0);
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    for (const mujoco::Member& member : motors.members(dof))
      rates[static_cast<std::size_t>(member.dof)] = member.multiplier * 0.1 * (dof + 1);
  }
  std::size_t most = 0;
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    EXPECT_NEAR(motors.RateOf(dof, rates.data()), 0.1 * (dof + 1), 1e-12);
    most = std::max(most, motors.members(dof).size());
  }
  EXPECT_GT(most, 1U) << "a coordinate has joints that follow it";
}

}  // namespace
}  // namespace gaitwright
