// SPDX-License-Identifier: BSD-3-Clause
// Rows of motors and gears on one joint between two floating bodies, with values computed by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "playback/bullet/joint_rows_internal.h"
#include "tests/kinematics/made_robots.h"
#include "tests/playback/bullet/small_world.h"
#include "tests/playback/one_joint.h"

namespace gaitwright::bullet {
namespace {

constexpr double kRowStep = 0.001;  // [s]

class JointRowsTest : public testing::Test {
 protected:
  using Traits = engine::JointTraits;

  static VectorX State(double position) {
    VectorX q = VectorX::Zero(8);
    q[6] = 1.0;
    q[7] = position;
    return q;
  }

  /// The rows of a step that begins at a position and a rate.
  const btMultiBodyConstraintArray& Rows(MotorRow& motor, const MotorRow::Target& target, double position,
                                         double rate) {
    VectorX v = VectorX::Zero(7);
    v[6] = rate;
    robot_.SetState(State(position), v);
    robot_.inertia().Update();
    motor.SetTarget(target);
    btContactSolverInfo info;
    info.m_timeStep = kRowStep;
    rows_.resize(0);
    data_.m_jacobians.resize(0);
    motor.createConstraintRows(rows_, data_, info);
    return rows_;
  }

  /// Stiffness 1000 and damping 10, with a limit of 10 in both directions.
  static MotorRow::Target Driven(double q_target) {
    MotorRow::Target target{q_target, 0.0, 0.0, 1000.0, 10.0};
    target.limits = {-one_joint::kEffort, one_joint::kEffort};
    return target;
  }
  static MotorRow::Target Idle() {
    MotorRow::Target target{};
    target.limits = {-one_joint::kEffort, one_joint::kEffort};
    return target;
  }
  static Traits Free() { return {-kFar, kFar, 0.0, 0.0, 0.0}; }

  static constexpr double kFar = std::numeric_limits<double>::infinity();
  const RobotModel model_ = one_joint::Make(JointType::kPrismatic);
  RobotBody robot_{model_, {.locked_dofs = {}, .q0 = State(0.0)}};
  btMultiBodyConstraintArray rows_;
  btMultiBodyJacobianData data_;
};

// h^2 kp + h kd = 0.011: softness 1 / 0.011, velocity h kp 0.1 / 0.011, impulse up to h 10.
TEST_F(JointRowsTest, ADriveIsAnImplicitPd) {
  MotorRow motor(robot_, 0, Free());
  const auto& rows = Rows(motor, Driven(0.1), 0.0, 0.5);
  ASSERT_EQ(rows.size(), 1);
  EXPECT_EQ(rows[0].m_orgDofIndex, MotorRow::kDrive);
  EXPECT_NEAR(rows[0].m_cfm, 1.0 / 0.011, 1e-9);
  EXPECT_NEAR(rows[0].m_rhs, 0.1 / 0.011 - 0.5, 1e-9);
  EXPECT_NEAR(rows[0].m_lowerLimit, -0.01, 1e-15);
  EXPECT_NEAR(rows[0].m_upperLimit, 0.01, 1e-15);
}

TEST_F(JointRowsTest, AFeedForwardTakesItsPartOfTheLimit) {
  MotorRow motor(robot_, 0, Free());
  MotorRow::Target target = Driven(0.1);
  target.tau_ff = 4.0;
  const auto& rows = Rows(motor, target, 0.0, 0.0);
  EXPECT_NEAR(rows[0].m_lowerLimit, -0.014, 1e-15);
  EXPECT_NEAR(rows[0].m_upperLimit, 0.006, 1e-15);
}

TEST_F(JointRowsTest, AMotorWithoutGainsHasNoRow) {
  MotorRow motor(robot_, 0, Free());
  EXPECT_EQ(Rows(motor, Idle(), 0.0, 1.0).size(), 0);
}

// At 1 m/s a step of 1 ms passes a stop at a distance of 0.5 mm: the row requires 0.5 m/s, and may only push back.
TEST_F(JointRowsTest, AStopActsWhereTheStepCouldPassIt) {
  MotorRow near(robot_, 0, {-kFar, 0.0005, 0.0, 0.0, 0.0});
  const auto& rows = Rows(near, Idle(), 0.0, 1.0);
  ASSERT_EQ(rows.size(), 1);
  EXPECT_EQ(rows[0].m_orgDofIndex, MotorRow::kStop);
  EXPECT_NEAR(rows[0].m_rhs, 0.5 - 1.0, 1e-12);
  EXPECT_EQ(rows[0].m_cfm, 0.0);
  EXPECT_LT(rows[0].m_lowerLimit, -1e20);
  EXPECT_EQ(rows[0].m_upperLimit, 0.0);
  MotorRow below(robot_, 0, {-0.0005, kFar, 0.0, 0.0, 0.0});
  const auto& other = Rows(below, Idle(), 0.0, -1.0);
  ASSERT_EQ(other.size(), 1);
  EXPECT_NEAR(other[0].m_rhs, -0.5 + 1.0, 1e-12);
  EXPECT_EQ(other[0].m_lowerLimit, 0.0);
  MotorRow far(robot_, 0, {-0.01, 0.01, 0.0, 0.0, 0.0});
  EXPECT_EQ(Rows(far, Idle(), 0.0, 1.0).size(), 0) << "the step ends 9 mm before it";
}

// J + h d = 0.5 + 0.003: the row requires J qd / 0.503.
TEST_F(JointRowsTest, LossesAreARowOfDragAndOneOfFriction) {
  MotorRow motor(robot_, 0, {-kFar, kFar, 3.0, 2.0, 0.5});
  const auto& rows = Rows(motor, Idle(), 0.0, 1.0);
  ASSERT_EQ(rows.size(), 2);
  EXPECT_EQ(rows[0].m_orgDofIndex, MotorRow::kLoss);
  EXPECT_NEAR(rows[0].m_cfm, 1.0 / 0.503, 1e-12);
  EXPECT_NEAR(rows[0].m_rhs, 0.5 / 0.503 - 1.0, 1e-12);
  EXPECT_EQ(rows[1].m_orgDofIndex, MotorRow::kDryFriction);
  EXPECT_NEAR(rows[1].m_rhs, -1.0, 1e-12);
  EXPECT_EQ(rows[1].m_cfm, 0.0);
  EXPECT_NEAR(rows[1].m_lowerLimit, -0.002, 1e-15);
  EXPECT_NEAR(rows[1].m_upperLimit, 0.002, 1e-15);
}

TEST_F(JointRowsTest, TheTorqueIsTheSumWithinTheLimit) {
  MotorRow motor(robot_, 0, Free());
  MotorRow::Target target = Driven(0.1);
  target.tau_ff = 3.0;
  Rows(motor, target, 0.0, 0.0);
  motor.internalSetAppliedImpulse(MotorRow::kDrive, 0.004);
  EXPECT_NEAR(motor.Torque(kRowStep), 7.0, 1e-12);
  motor.internalSetAppliedImpulse(MotorRow::kDrive, 0.05);
  EXPECT_EQ(motor.Torque(kRowStep), 10.0);
  motor.internalSetAppliedImpulse(MotorRow::kDrive, -0.05);
  EXPECT_EQ(motor.Torque(kRowStep), -10.0);
}

// All joints that follow the coordinate give the same value for it, so their mean equals it.
TEST(JointRowsOfGears, PositionAndRateAreTheCoordinates) {
  const RobotModel model = AnyRobot("mimic");
  VectorX q = StandingConfiguration(model), v = VectorX::Zero(model.nv());
  for (int dof = 0; dof < model.num_dofs(); ++dof) v[6 + dof] = 0.1 * (dof + 1);
  RobotBody robot(model, {.locked_dofs = {}, .q0 = q});
  robot.SetState(q, v);
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    const MotorRow motor(robot, dof, {-1.0, 1.0, 0.0, 0.0, 0.0});
    EXPECT_NEAR(motor.Position(), q[7 + dof], 1e-12);
    EXPECT_NEAR(motor.Rate(), v[6 + dof], 1e-12);
  }
}

TEST(JointRowsOfGears, AGearTakesHalfOfItsErrorBackInAStep) {
  const RobotModel model = AnyRobot("mimic");
  const Gear of = FirstGear(model);
  const VectorX q = StandingConfiguration(model);
  RobotBody robot(model, {.locked_dofs = {}, .q0 = q});
  GearRow gear(robot, of.joint, of.follower, of.leader);
  EXPECT_NEAR(gear.Error(), 0.0, 1e-12);
  robot.multibody().setJointPos(of.follower, robot.multibody().getJointPos(of.follower) + 0.002);
  EXPECT_NEAR(gear.Error(), 0.002, 1e-12);
  robot.inertia().Update();
  btMultiBodyConstraintArray rows;
  btMultiBodyJacobianData data;
  btContactSolverInfo info;
  info.m_timeStep = kRowStep;
  gear.createConstraintRows(rows, data, info);
  ASSERT_EQ(rows.size(), 1);
  EXPECT_NEAR(rows[0].m_rhs, -0.5 * 0.002 / kRowStep, 1e-9);
  EXPECT_EQ(rows[0].m_cfm, 0.0);
}

}  // namespace
}  // namespace gaitwright::bullet
