// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "optimisation/trajectory/motor_rows_internal.h"
#include "planning/audit/motor_effort.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

class RowsOfMotors : public testing::TestWithParam<const char*> {
 protected:
  RowsOfMotors() {
    for (Joint& joint : model_.joints) joint.friction = 0.0;
    model_.joints[1].damping = 0.4;
    model_.motors[0].rotor_inertia = 0.05;
  }

  RobotModel model_ = AnyRobot(GetParam());
};

TEST_P(RowsOfMotors, EffortsAreSharesOfThoseOfTheAudit) {
  const BodyLimitUse use;
  const MotorRows rows(model_, use);
  const MotorEffort effort(model_);
  RandomState random(1);
  const VectorX torque = random.Vector(model_.num_dofs()), v = random.Vector(model_.num_dofs()),
                a = random.Vector(model_.num_dofs());
  VectorX shares(rows.count());
  rows.Efforts(torque, v, a, shares);
  ASSERT_FALSE(rows.limited().empty());
  for (const int motor : rows.limited()) {
    const double limit = rows.motors()[static_cast<std::size_t>(motor)].effort_limit;
    EXPECT_NEAR(shares[motor] * use.effort * limit, effort.Of(motor, torque, v, a), 1e-12 * limit);
  }
}

TEST_P(RowsOfMotors, DerivativesAreLinear) {
  const MotorRows rows(model_, {});
  RandomState random(2);
  const Eigen::Index n = model_.num_dofs();
  const VectorX v = random.Vector(n), a = random.Vector(n);
  MatrixX torque = MatrixX::Zero(n, 1), by_torque(rows.count(), 1);
  torque.col(0) = random.Vector(n);
  rows.ToMotors(torque, by_torque);
  MatrixX by_v = MatrixX::Zero(rows.count(), n), by_a = by_v;
  rows.AddLosses(by_v, by_a);
  VectorX shares(rows.count());
  rows.Efforts(torque.col(0), v, a, shares);
  EXPECT_LT((by_torque.col(0) + by_v * v + by_a * a - shares).norm(), 1e-12);
}

TEST(MotorRows, JointsOfMuchFrictionStick) {
  RobotModel model = AnyRobot("nao");
  for (Joint& joint : model.joints) joint.friction = 0.0;
  Joint& grips = model.joints[3];
  const BodyLimitUse use;
  const auto share_of_grip = [&] {
    const MotorRows rows(model, use);
    VectorX torque = VectorX::Zero(model.num_dofs()), shares(rows.count());
    torque[grips.dof] = 1.0;
    rows.Efforts(torque, VectorX::Zero(model.num_dofs()), VectorX::Zero(model.num_dofs()), shares);
    return shares.cwiseAbs().maxCoeff();
  };
  ASSERT_TRUE(model.LeaderOf(grips.dof).effort_limit > 0.0);
  const double without = share_of_grip();
  grips.friction = 0.3 * grips.effort_limit;
  EXPECT_FALSE(MotorRows(model, use).Sticks(grips.dof));
  EXPECT_GT(share_of_grip(), 1.2 * without) << "friction takes some of the limit";
  grips.friction = 0.9 * grips.effort_limit;
  EXPECT_TRUE(MotorRows(model, use).Sticks(grips.dof));
  EXPECT_FALSE(MotorRows(model, use).Sticks((grips.dof + 1) % model.num_dofs()));
  EXPECT_DOUBLE_EQ(share_of_grip(), without) << "a joint at rest has no friction to overcome";
}

TEST(MotorRows, KeepsTorqueSpeedCurves) {
  RobotModel model = AnyRobot("a1");
  model.motors[0].corner_speed = 5.0;
  model.motors[0].no_load_speed = 12.0;
  const MotorRows rows(model, {});
  const auto curve = std::find_if(rows.curves().begin(), rows.curves().end(),
                                  [](const MotorRows::Curve& c) { return c.motor == 0 && c.by_effort > 0.0; });
  ASSERT_NE(curve, rows.curves().end());
  // At the bound: the whole torque at the corner, none at the no-load speed.
  EXPECT_NEAR(curve->by_effort + 5.0 / curve->speed_scale, 1.0, 1e-12);
  EXPECT_NEAR(12.0 / curve->speed_scale, 1.0, 1e-12);
}

TEST(MotorRows, NameTheLargestShares) {
  RobotModel model = AnyRobot("a1");
  model.motors[0].corner_speed = 5.0;
  model.motors[0].no_load_speed = 12.0;
  const MotorRows rows(model, {1.0, 1.0, 0.0, 0.0});
  const Eigen::Index n = model.num_dofs();
  VectorX torque = VectorX::Zero(n), v = VectorX::Zero(n);
  torque[0] = 0.5 * rows.motors()[0].effort_limit;
  MotorRows::Largest largest;
  rows.Raise(torque, v, v, largest);
  EXPECT_NEAR(largest.effort[0], 0.5, 1e-9);
  EXPECT_NEAR(largest.curve[0], 0.5 * (12.0 - 5.0) / 12.0, 1e-9);
  EXPECT_EQ(largest.effort.tail(largest.effort.size() - 1).maxCoeff(), 0.0);
  v[0] = 6.0;
  rows.Raise(torque, v, 0.0 * v, largest);
  EXPECT_NEAR(largest.curve[0], 0.5 * (12.0 - 5.0) / 12.0 + 0.5, 0.02);
  rows.Raise(0.0 * torque, 0.0 * v, 0.0 * v, largest);
  EXPECT_NEAR(largest.effort[0], 0.5, 1e-9) << "the largest so far";
}

TEST(MotorRows, FactorsLowerTheLimitsOfTheirMotorsAlone) {
  const RobotModel model = AnyRobot("a1");
  BodyLimitUse use;
  const MotorRows all(model, use);
  use.effort_of.assign(static_cast<std::size_t>(all.count()), 1.0);
  use.speed_of = use.effort_of;
  use.effort_of[1] = 0.8;
  use.speed_of[2] = 0.7;
  const MotorRows rows(model, use);
  for (int motor = 0; motor < rows.count(); ++motor)
    EXPECT_NEAR(rows.EffortOf(motor), (motor == 1 ? 0.8 : 1.0) * all.EffortOf(motor), 1e-12) << motor;
  ASSERT_EQ(rows.curves().size(), all.curves().size());
  for (std::size_t i = 0; i < rows.curves().size(); ++i) {
    const double factor = rows.curves()[i].motor == 2 ? 0.7 : 1.0;
    EXPECT_NEAR(rows.curves()[i].speed_scale, factor * all.curves()[i].speed_scale, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, RowsOfMotors, testing::ValuesIn(kAnyRobots));

}  // namespace
}  // namespace gaitwright
