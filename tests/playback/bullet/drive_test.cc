// SPDX-License-Identifier: BSD-3-Clause
// Torque of a motor at speed and when it is warm.
#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/motor_warmth.h"
#include "playback/bullet/bullet_world.h"
#include "tests/playback/one_joint.h"

namespace gaitwright {
namespace {

using one_joint::kEffort, one_joint::kInertia;

VectorX HighUp() {
  VectorX q = VectorX::Zero(8);
  q[2] = 1000.0;
  q[6] = 1.0;
  return q;
}

void SetRate(BulletWorld& world, double rate) {
  VectorX v = VectorX::Zero(7);
  v[6] = rate;
  world.SetState(HighUp(), v);
}

/// By feed-forward only, or by a velocity gain that requests the same torque.
JointCommand Ask(double torque, bool by_gain = false) {
  const VectorX zero = VectorX::Zero(1);
  JointCommand command{zero, zero, zero, zero, zero};
  if (by_gain) {
    command.damping[0] = 1e3;
    command.v[0] = torque;
  } else {
    command.tau_ff[0] = torque;
  }
  return command;
}

RobotModel WithCurve() {
  RobotModel model = one_joint::Make(JointType::kRevolute);
  model.motors[0].corner_speed = 3.0;
  model.motors[0].no_load_speed = 5.0;
  return model;
}

TEST(TorqueSpeedCurve, FullTorqueEndsAtTheNoLoadSpeed) {
  const RobotModel model = WithCurve();
  const double h = WorldOptions().step_s;
  for (const double sign : {1.0, -1.0}) {
    for (const bool by_gain : {false, true}) {
      BulletWorld world(model, FlatTerrain(), HighUp(), {});
      double expected = 0.0;
      for (int k = 0; k < 3000; ++k) {
        const double limit = expected <= 3.0 ? kEffort : kEffort * (5.0 - expected) / 2.0;
        expected += h * limit / kInertia;
        world.Step(Ask(sign * 100.0, by_gain));
        ASSERT_NEAR(world.v()[6], sign * expected, 1e-9) << k;
        ASSERT_NEAR(world.tau()[0], sign * limit, 1e-9) << k;
        ASSERT_EQ(world.effort_use()[0], 1.0) << k;
      }
      EXPECT_NEAR(world.v()[6], sign * 5.0, 1e-6);

      world.Step(Ask(-sign * 100.0, by_gain));
      EXPECT_NEAR(world.tau()[0], -sign * kEffort, 1e-9) << "braking is whole";
    }
  }
}

TEST(TorqueSpeedCurve, OverTheNoLoadSpeedItGivesNothing) {
  const RobotModel model = WithCurve();
  BulletWorld world(model, FlatTerrain(), HighUp(), {});
  SetRate(world, 6.0);
  for (const bool by_gain : {false, true}) {
    world.Step(Ask(50.0, by_gain));
    EXPECT_EQ(world.tau()[0], 0.0);
    EXPECT_EQ(world.effort_use()[0], 1.0);
    EXPECT_NEAR(world.v()[6], 6.0, 1e-9);
  }
  world.Step(Ask(0.0));
  EXPECT_LT(world.effort_use()[0], 1.0);
  world.Step(Ask(-4.0));
  EXPECT_EQ(world.tau()[0], -4.0);
  EXPECT_NEAR(world.effort_use()[0], 4.0 / kEffort, 1e-12) << "of the whole where it brakes";
}

TEST(TorqueSpeedCurve, CanBeSwitchedOff) {
  WorldOptions options;
  options.motor_curve = false;
  const RobotModel model = WithCurve();
  BulletWorld world(model, FlatTerrain(), HighUp(), options);
  for (int k = 0; k < 1000; ++k) world.Step(Ask(100.0));
  EXPECT_NEAR(world.v()[6], kEffort / kInertia, 1e-9);
}

TEST(TorqueSpeedCurve, HoldsForExplicitTorqueToo) {
  WorldOptions options;
  options.actuation = "torque";
  const RobotModel model = WithCurve();
  BulletWorld world(model, FlatTerrain(), HighUp(), options);
  for (int k = 0; k < 3000; ++k) world.Step(Ask(8.0, true));
  EXPECT_NEAR(world.v()[6], 5.0, 1e-6);
}

/// The motor pushes against dry friction, so that the joint does not move.
struct Warming {
  explicit Warming(bool limited = true, double peak_torque = kEffort) {
    model.motors[0].continuous_effort = kContinuous;
    model.motors[0].thermal_s = kThermal_s;
    model.joints[0].effort_limit = peak_torque;
    model.joints[0].effort_limit_is_placeholder = !std::isfinite(peak_torque);
    model.joints[0].friction = 1000.0;
    options.thermal_limit = limited;
    world = std::make_unique<BulletWorld>(model, FlatTerrain(), HighUp(), options);
  }

  double Torque(double wanted, bool by_gain = false) {
    world->Step(Ask(wanted, by_gain));
    return world->tau()[0];
  }

  static constexpr double kContinuous = 4.0, kThermal_s = 0.5;
  RobotModel model = one_joint::Make(JointType::kRevolute);
  WorldOptions options;
  std::unique_ptr<BulletWorld> world;
};

TEST(ThermalLimit, FullTorqueLastsAsLongAsTheClosedFormSays) {
  const double c = Warming::kContinuous, T = Warming::kThermal_s;
  Warming motor;
  const double until_s = -T * std::log(1.0 - 0.8 * c * c / (kEffort * kEffort));
  for (int k = 0; k < 400; ++k) {
    const double start_s = 0.001 * k;
    const double torque = motor.Torque(50.0, k % 2 == 0);
    if (start_s < until_s) {
      ASSERT_NEAR(torque, kEffort, 1e-9) << k;
      const double w = kEffort * kEffort * -std::expm1(-(start_s + 0.001) / T);
      ASSERT_NEAR(motor.world->mean_square_effort()[0], w, 1e-9);
    } else {
      ASSERT_LT(torque, kEffort) << k;
      ASSERT_GE(torque, c - 1e-9) << k;
    }
    ASSERT_EQ(motor.world->effort_use()[0], 1.0);
  }
}

/// dw/dt = (L(w)^2 - w) / T is solved with a time step a thousand times finer.
TEST(ThermalLimit, ComesDownAsItsDifferentialEquationDoes) {
  const double c = Warming::kContinuous, T = Warming::kThermal_s;
  Warming motor;
  double w = 0.0;
  for (int k = 0; k < 300; ++k) {
    for (int fine = 0; fine < 1000; ++fine) {
      const double share = std::clamp((c * c - w) / (0.2 * c * c), 0.0, 1.0);
      const double limit = c + (kEffort - c) * share;
      w += 1e-6 / T * (limit * limit - w);
    }
    motor.Torque(50.0);
    ASSERT_NEAR(motor.world->mean_square_effort()[0], w, 0.02 * c * c) << k;
  }
  EXPECT_GT(w, 0.95 * c * c);
}

TEST(ThermalLimit, UnderLastingDemandTheRootMeanSquareIsTheContinuousEffort) {
  for (const double peak : {kEffort, Motor::kNone}) {
    Warming motor(true, peak);
    double squares = 0.0;
    for (int k = 0; k < 8000; ++k) {
      const double torque = motor.Torque(12.0 * std::cos(0.01 * k) > 0.0 ? 50.0 : -50.0);
      if (k >= 4000) squares += torque * torque / 4000.0;
    }
    EXPECT_NEAR(std::sqrt(squares), Warming::kContinuous, 1e-3);
  }
}

TEST(ThermalLimit, DoesNotActBelowItsLimitAndRecoversAfterARest) {
  Warming spared;
  for (int k = 0; k < 4000; ++k) ASSERT_EQ(spared.Torque(3.5), 3.5);  // 3.5^2 < 0.8 c^2
  Warming rests;
  for (int k = 0; k < 2000; ++k) rests.Torque(50.0);
  EXPECT_LT(rests.Torque(50.0), 4.1);
  for (int k = 0; k < 2000; ++k) rests.Torque(0.0);
  EXPECT_NEAR(rests.Torque(50.0), kEffort, 1e-9);
}

TEST(ThermalLimit, CanBeSwitchedOff) {
  Warming motor(false);
  for (int k = 0; k < 2000; ++k) ASSERT_NEAR(motor.Torque(50.0), kEffort, 1e-9);
  EXPECT_EQ(motor.world->mean_square_effort()[0], 0.0);
}

TEST(ThermalLimit, TheCurveHoldsBesideIt) {
  RobotModel model = WithCurve();
  model.motors[0].continuous_effort = 9.0;
  model.motors[0].thermal_s = 1000.0;
  BulletWorld world(model, FlatTerrain(), HighUp(), {});
  SetRate(world, 4.0);
  world.Step(Ask(50.0));
  EXPECT_NEAR(world.tau()[0], 0.5 * kEffort, 1e-9);
}

}  // namespace
}  // namespace gaitwright
