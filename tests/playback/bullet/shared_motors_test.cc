// SPDX-License-Identifier: BSD-3-Clause
// Motors of a transmission in playback: each stays within its own limit for all commands to the joints.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kinematics/model/actuator.h"
#include "playback/bullet/bullet_world.h"
#include "tests/playback/two_joints.h"

namespace gaitwright {
namespace {

constexpr double kMotorEffort = two_joints::kEffort;

VectorX UpThere(double first = 0.0, double second = 0.0) {
  VectorX q = VectorX::Zero(9);
  q[2] = 1000.0;
  q[6] = 1.0;
  q.tail<2>() << first, second;
  return q;
}

MatrixX Matrix(double a, double b, double c, double d) {
  MatrixX ratios(2, 2);
  ratios << a, b, c, d;
  return ratios;
}

MatrixX Differential() { return Matrix(1.0, 1.0, 1.0, -1.0); }

/// By feed-forward only, or by velocity gains that are high enough to request the same torques.
JointCommand AskBoth(double first, double second, bool by_gain) {
  const VectorX zero = VectorX::Zero(2), torque = Vector2(first, second);
  JointCommand command{zero, zero, zero, zero, zero};
  if (by_gain) {
    command.damping = VectorX::Constant(2, 1e5);
    command.v = torque / 1e5;
  } else {
    command.tau_ff = torque;
  }
  return command;
}

TEST(SharedMotors, OfOneJointBothMotorsGiveTwiceWhatOneGivesAndOfBothLess) {
  for (const std::string actuation : {"pd", "torque"}) {
    WorldOptions options;
    if (actuation == "torque") options.actuation = actuation;
    const RobotModel model = two_joints::Driven(Differential());
    for (const bool by_gain : {false, true}) {
      const auto first_step = [&](double first, double second) {
        BulletWorld world(model, FlatTerrain(), UpThere(), options);
        world.Step(AskBoth(first, second, by_gain));
        for (int m = 0; m < 2; ++m)
          EXPECT_NEAR(world.motor_torque()[m], ActuatorOf(model, m).Effort(world.tau()), 1e-9);
        return std::pair<VectorX, VectorX>(world.tau(), world.effort_use());
      };
      const auto [alone, use_alone] = first_step(1e4, 0.0);
      EXPECT_NEAR(alone[0], 2.0 * kMotorEffort, 1e-6) << "both motors push the first joint";
      EXPECT_EQ(use_alone[0], 1.0);
      EXPECT_EQ(use_alone[1], 1.0);
      const auto [both, use_both] = first_step(15.0, 15.0);
      if (by_gain) continue;  // a gain requests less, the more the joint moves
      EXPECT_NEAR(both[0], kMotorEffort, 1e-9) << "within a box of 20, but one motor would have to give 15";
      EXPECT_NEAR(both[1], kMotorEffort, 1e-9);
      EXPECT_EQ(use_both[0], 1.0);
      EXPECT_EQ(use_both[1], 0.0);
    }
  }
}

TEST(SharedMotors, WithinTheirLimitsTheyActAsMotorsOfTheJoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    MatrixX ratios = MatrixX::NullaryExpr(2, 2, [&] { return number(random); });
    if (trial % 2 == 1) ratios(trial / 2 % 2, trial / 4 % 2) = 0.0;  // a motor of one joint, coupled to the other
    if (Regularity(ratios) < 0.1) continue;
    const RobotModel plain = two_joints::Make(), driven = two_joints::Driven(ratios, 1e6);
    WorldOptions options;
    options.motor_strength = trial % 2 == 0 ? 1.0 : 10.0;
    options.torque_scale = trial % 3 == 0 ? 0.7 : 1.0;
    RobotModel strong = plain;
    for (Joint& joint : strong.joints) joint.effort_limit = 1e6;
    BulletWorld one(strong, FlatTerrain(), UpThere(), options), other(driven, FlatTerrain(), UpThere(), options);
    const VectorX zero = VectorX::Zero(2);
    JointCommand command{zero, zero, zero, zero, zero};
    command.stiffness = Vector2(300.0, trial % 5 == 0 ? 300.0 : 40.0);
    command.damping = Vector2(8.0, 3.0);
    for (int k = 0; k < 300; ++k) {
      command.q = Vector2(0.3 * std::sin(0.02 * k), 0.2 * std::cos(0.03 * k));
      command.tau_ff = Vector2(2.0 * number(random), number(random));
      one.Step(command);
      other.Step(command);
      ASSERT_TRUE(other.q().isApprox(one.q(), 1e-9)) << k;
      ASSERT_TRUE(other.tau().isApprox(one.tau(), 1e-6))
          << k << ": " << other.tau().transpose() << " for " << one.tau().transpose();
    }
  }
}

TEST(SharedMotors, IdentityIsWhatBoxesAre) {
  const RobotModel plain = two_joints::Make(), same = two_joints::Driven(Matrix(1.0, 0.0, 0.0, 1.0));
  BulletWorld one(plain, FlatTerrain(), UpThere(), {}), other(same, FlatTerrain(), UpThere(), {});
  const VectorX zero = VectorX::Zero(2);
  JointCommand command{zero, zero, zero, zero, zero};
  command.stiffness = Vector2(300.0, 500.0);
  command.damping = Vector2(8.0, 3.0);
  bool limited = false;
  for (int k = 0; k < 1000; ++k) {
    command.q = Vector2(0.3 * std::sin(0.02 * k), 0.2 * std::cos(0.03 * k));
    one.Step(command);
    other.Step(command);
    ASSERT_TRUE(other.q().isApprox(one.q(), 1e-12));
    ASSERT_TRUE(other.tau().isApprox(one.tau(), 1e-9) || one.tau().norm() < 1e-6);
    ASSERT_TRUE((other.effort_use() - one.effort_use()).isZero(1e-9));
    limited = limited || one.effort_use().maxCoeff() >= 1.0;
  }
  EXPECT_TRUE(limited);
}

/// Among the possible motor torques, those nearest to the wanted ones, weighted by the joints' softness.
TEST(SharedMotors, AMotorAtItsLimitLeavesWhatIsNearestToTheWantedTorques) {
  const MatrixX ratios = Matrix(1.0, 1.0, 1.0, -1.0);
  const RobotModel model = two_joints::Driven(ratios);
  WorldOptions options;
  const double h = options.step_s;
  BulletWorld world(model, FlatTerrain(), UpThere(), options);
  JointCommand command = AskBoth(0.0, 0.0, true);
  command.damping = Vector2(30.0, 90.0);
  command.v = Vector2(18.0 / 30.0, 4.0 / 90.0);
  world.Step(command);
  // tau of a joint, by its speed after the step: damping (v* - v'), v' = h tau / I.
  const Vector2 inertia(1.0, 2.0);
  const auto off = [&](const Vector2& tau) {
    double sum = 0.0;
    for (int i = 0; i < 2; ++i) {
      const double asked = command.damping[i] * command.v[i], drive = 1.0 + h * command.damping[i] / inertia[i];
      sum += 0.5 * drive * tau[i] * tau[i] / command.damping[i] - asked * tau[i] / command.damping[i];
    }
    return sum;
  };
  const Vector2 found = world.tau();
  const Vector2 motors = ratios.transpose().inverse() * found;
  EXPECT_NEAR(motors[0], kMotorEffort, 1e-9);
  EXPECT_LT(std::abs(motors[1]), kMotorEffort);
  for (const double step : {-0.01, 0.01}) {
    const Vector2 beside = ratios.transpose() * (motors + Vector2(0.0, step));
    EXPECT_GT(off(beside), off(found)) << "the other motor gives what is best";
  }
}

TEST(SharedMotors, RotorsAreFeltThroughTheTransmission) {
  const MatrixX ratios = Matrix(2.0, 1.0, 0.0, 3.0);
  const RobotModel model = two_joints::Driven(ratios, 1e3, 0.1);
  BulletWorld world(model, FlatTerrain(), UpThere(), {});
  world.Step(AskBoth(1.0, 0.0, false));
  const MatrixX M = MatrixX(Vector2(1.0, 2.0).asDiagonal()) + model.transmissions[0].RotorInertia();
  const Vector2 expected = WorldOptions().step_s * M.inverse() * Vector2(1.0, 0.0);
  EXPECT_NEAR(world.v()[6], expected[0], 1e-9);
  EXPECT_NEAR(world.v()[7], expected[1], 1e-9);
}

TEST(SharedMotors, TheCurveGoesByTheMotorsSpeed) {
  RobotModel model = two_joints::Driven(Differential());
  for (TransmissionMotor& motor : model.transmissions[0].motors) {
    motor.motor.corner_speed = 3.0;
    motor.motor.no_load_speed = 5.0;
  }
  BulletWorld world(model, FlatTerrain(), UpThere(), {});
  VectorX v = VectorX::Zero(8);
  v.tail<2>() << 2.0, 2.0;  // motors: 4 and 0
  world.SetState(UpThere(), v);
  world.Step(AskBoth(1e3, 0.0, false));
  EXPECT_NEAR(world.motor_torque()[0], 0.5 * kMotorEffort, 1e-9);
  EXPECT_NEAR(world.motor_torque()[1], kMotorEffort, 1e-9);
}

TEST(SharedMotors, StopsOfTheJointsHold) {
  RobotModel model = two_joints::Driven(Differential(), 1e4);
  for (Joint& joint : model.joints) joint.lower = -0.2, joint.upper = 0.2;
  BulletWorld world(model, FlatTerrain(), UpThere(), {});
  JointCommand command = AskBoth(0.0, 0.0, true);
  command.stiffness = VectorX::Constant(2, 5000.0);
  command.damping = VectorX::Constant(2, 10.0);
  command.q = Vector2(2.0, -2.0);
  for (int k = 0; k < 500; ++k) {
    world.Step(command);
    ASSERT_LT(world.q()[7], 0.2 + 1e-6);
    ASSERT_GT(world.q()[8], -0.2 - 1e-6);
  }
  EXPECT_NEAR(world.q()[7], 0.2, 1e-6);
}

TEST(SharedMotors, AJointThatIsLockedIsHeldAndTheOtherMoves) {
  WorldOptions options;
  options.locked_dofs = {1};
  const RobotModel model = two_joints::Driven(Differential());
  for (const bool by_gain : {false, true}) {
    BulletWorld world(model, FlatTerrain(), UpThere(0.0, 0.3), options);
    for (int k = 0; k < 100; ++k) world.Step(AskBoth(5.0, 0.0, by_gain));
    EXPECT_NEAR(world.q()[8], 0.3, 1e-12);
    EXPECT_EQ(world.tau()[1], 0.0);
    EXPECT_GT(world.q()[7], 0.0);
  }
}

}  // namespace
}  // namespace gaitwright
