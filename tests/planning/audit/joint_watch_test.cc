// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/joint_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/named_robot.h"

namespace gaitwright {
namespace {

constexpr int kWatchedDof = 2;

/// A robot without motor data except the limits of its joints.
RobotModel WithPlainMotors() {
  RobotModel model = NamedRobot("a1");
  for (Motor& motor : model.motors) motor = Motor();
  return model;
}

Motor& WatchedMotor(RobotModel& model) { return model.motors[kWatchedDof]; }

/// State of one joint at a sample.
struct JointSample {
  double q, v, a, tau;
};

/// The violations of a joint with this motion at 1 kHz, while all others stand still.
std::vector<Violation> FoundOf(const RobotModel& model, int samples, const std::function<JointSample(double)>& motion,
                               const AuditOptions& options = {}) {
  Findings findings;
  JointWatch watch(model, options, samples, findings);
  WholeBodySample sample;
  sample.q = StandingConfiguration(model);
  sample.v = VectorX::Zero(model.nv());
  sample.a = VectorX::Zero(model.nv());
  sample.tau = VectorX::Zero(model.num_dofs());
  sample.wrenches.resize(model.feet.size());
  for (int k = 0; k < samples; ++k) {
    const double time_s = k / options.rate_hz;
    const JointSample joint = motion(time_s);
    sample.q[7 + kWatchedDof] = joint.q;
    sample.v[6 + kWatchedDof] = joint.v;
    sample.a[6 + kWatchedDof] = joint.a;
    sample.tau[kWatchedDof] = joint.tau;
    watch.Look(sample, time_s);
  }
  watch.Finish((samples - 1) / options.rate_hz);
  return findings.Sorted();
}

double StandingAngle(const RobotModel& model) { return model.standing_joints[kWatchedDof]; }

void ExpectOnly(const std::vector<Violation>& found, Law law, double value, double limit, const std::string& unit) {
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, law);
  EXPECT_EQ(found[0].where, NamedRobot("a1").dof_names[kWatchedDof]);
  EXPECT_NEAR(found[0].value, value, 1e-9 * (1.0 + std::abs(value)));
  EXPECT_NEAR(found[0].limit, limit, 1e-9 * (1.0 + std::abs(limit)));
  EXPECT_EQ(found[0].unit, unit);
}

TEST(JointWatch, StandingViolatesNothing) {
  const RobotModel model = WithPlainMotors();
  const double q = StandingAngle(model);
  EXPECT_TRUE(FoundOf(model, 5, [&](double) { return JointSample{q, 0.0, 0.0, 0.0}; }).empty());
}

TEST(JointWatch, APositionPastEitherEndIsFoundAtItsWorstTime) {
  const RobotModel model = WithPlainMotors();
  const double lower = model.dof_lower(kWatchedDof), upper = model.dof_upper(kWatchedDof);
  for (const double end : {lower, upper}) {
    const double out = end == upper ? 1.0 : -1.0;
    const auto at = [&](double past) {
      return FoundOf(model, 11, [&](double t) {
        return JointSample{t == 0.004 ? end + out * past : t == 0.007 ? end + 0.5 * out * past : end, 0.0, 0.0, 0.0};
      });
    };
    EXPECT_TRUE(at(0.0).empty()) << "on the limit";
    ExpectOnly(at(0.1), Law::kJointPosition, end + 0.1 * out, end, "rad");
    EXPECT_NEAR(at(0.1)[0].at_s, 0.004, 1e-12);
  }
}

TEST(JointWatch, ASpeedIsHeldAgainstTheShareThatIsLeftOfIt) {
  const RobotModel model = WithPlainMotors();
  const double q = StandingAngle(model), limit = model.dof_velocity_limit(kWatchedDof);
  ASSERT_TRUE(std::isfinite(limit));
  const auto at = [&](double speed, const AuditOptions& options = {}) {
    return FoundOf(
        model, 3,
        [&](double) {
          return JointSample{q, speed, 0.0, 0.0};
        },
        options);
  };
  AuditOptions half;
  half.derate_speed = 0.5;
  EXPECT_TRUE(at(0.99 * limit).empty());
  EXPECT_TRUE(at(-0.99 * limit).empty());
  ExpectOnly(at(-1.1 * limit), Law::kJointVelocity, 1.1 * limit, limit, "rad/s");
  ExpectOnly(at(0.6 * limit, half), Law::kJointVelocity, 0.6 * limit, 0.5 * limit, "rad/s");
}

TEST(JointWatch, AnEffortIsHeldAgainstTheShareThatIsLeftOfIt) {
  const RobotModel model = WithPlainMotors();
  const double q = StandingAngle(model), limit = model.dof_effort_limit(kWatchedDof);
  const auto at = [&](double tau, double derate) {
    AuditOptions options;
    options.derate_torque = derate;
    return FoundOf(
        model, 3,
        [&](double) {
          return JointSample{q, 0.0, 0.0, tau};
        },
        options);
  };
  EXPECT_TRUE(at(0.99 * limit, 1.0).empty());
  ExpectOnly(at(-1.2 * limit, 1.0), Law::kJointTorque, 1.2 * limit, limit, "N m");
  ExpectOnly(at(0.9 * limit, 0.8), Law::kJointTorque, 0.9 * limit, 0.8 * limit, "N m");
}

TEST(JointWatch, AnAccelerationHasALimitOnlyWhereItIsKnown) {
  RobotModel model = WithPlainMotors();
  const double q = StandingAngle(model);
  const auto found = [&] { return FoundOf(model, 3, [&](double) { return JointSample{q, 0.0, -80.0, 0.0}; }); };
  EXPECT_TRUE(found().empty());
  WatchedMotor(model).acceleration_limit = 50.0;
  ExpectOnly(found(), Law::kJointAcceleration, 80.0, 50.0, "rad/s^2");
}

TEST(JointWatch, JerkIsTheChangeOfAccelerationOverItsTime) {
  RobotModel model = WithPlainMotors();
  const double q = StandingAngle(model);
  WatchedMotor(model).jerk_limit = 900.0;
  // The acceleration rises by 1000 rad/s^3.
  const auto rising = [&](double t) { return JointSample{q, 0.0, 1000.0 * t, 0.0}; };
  ExpectOnly(FoundOf(model, 40, rising), Law::kJointJerk, 1000.0, 900.0, "rad/s^3");
  WatchedMotor(model).jerk_limit = 1001.0;
  EXPECT_TRUE(FoundOf(model, 40, rising).empty());
  // A jump of 5 rad/s^2 is 500 rad/s^3 over 10 ms and 1000 over 5 ms.
  const auto jump = [&](double t) { return JointSample{q, 0.0, t < 0.02 ? 0.0 : 5.0, 0.0}; };
  WatchedMotor(model).jerk_limit = 600.0;
  EXPECT_TRUE(FoundOf(model, 40, jump).empty());
  AuditOptions shorter;
  shorter.jerk_over_s = 0.005;
  ExpectOnly(FoundOf(model, 40, jump, shorter), Law::kJointJerk, 1000.0, 600.0, "rad/s^3");
}

TEST(JointWatch, ContinuousEffortIsTheRootMeanSquareOverTheThermalTime) {
  RobotModel model = WithPlainMotors();
  const double q = StandingAngle(model);
  Motor& motor = WatchedMotor(model);
  motor.continuous_effort = 7.0;
  motor.thermal_s = 0.02;
  const auto steady = [&](double) { return JointSample{q, 0.0, 0.0, -8.0}; };
  ExpectOnly(FoundOf(model, 50, steady), Law::kContinuousTorque, 8.0, 7.0, "N m");
  // 10 N m for half of the time.
  const auto half = [&](double t) { return JointSample{q, 0.0, 0.0, std::lround(1e3 * t) % 2 == 0 ? 10.0 : 0.0}; };
  ExpectOnly(FoundOf(model, 50, half), Law::kContinuousTorque, 10.0 / std::sqrt(2.0), 7.0, "N m");
  motor.continuous_effort = 7.1;
  EXPECT_TRUE(FoundOf(model, 50, half).empty());
  // A pulse of 10 ms fills half of a window of 20 ms, and a tenth of a window of 100 ms.
  const auto pulse = [&](double t) { return JointSample{q, 0.0, 0.0, t > 0.0195 && t < 0.0295 ? 12.0 : 0.0}; };
  ExpectOnly(FoundOf(model, 100, pulse), Law::kContinuousTorque, 12.0 / std::sqrt(2.0), 7.1, "N m");
  motor.thermal_s = 0.1;
  EXPECT_TRUE(FoundOf(model, 100, pulse).empty());
}

TEST(JointWatch, APlanShorterThanTheThermalTimeIsAveragedAsAWhole) {
  RobotModel model = WithPlainMotors();
  const double q = StandingAngle(model);
  WatchedMotor(model).continuous_effort = 5.0;
  WatchedMotor(model).thermal_s = 10.0;
  ExpectOnly(FoundOf(model, 30,
                     [&](double) {
                       return JointSample{q, 0.0, 0.0, 6.0};
                     }),
             Law::kContinuousTorque, 6.0, 5.0, "N m");
}

TEST(JointWatch, AlongTheMotionTheCurveBoundsTheTorqueAndBrakingDoesNot) {
  RobotModel model = WithPlainMotors();
  const double q = StandingAngle(model), peak = model.dof_effort_limit(kWatchedDof);
  const double fast = 0.8 * model.dof_velocity_limit(kWatchedDof);
  Motor& motor = WatchedMotor(model);
  motor.corner_speed = 0.0;
  motor.no_load_speed = 2.0 * fast;  // leaves half of the peak
  const auto at = [&](double tau) { return FoundOf(model, 3, [&](double) { return JointSample{q, fast, 0.0, tau}; }); };
  EXPECT_TRUE(at(0.4 * peak).empty());
  const std::vector<Violation> found = at(0.7 * peak);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].law, Law::kTorqueSpeed);
  EXPECT_NEAR(found[0].limit, 0.5 * peak, 1e-9 * peak);
  EXPECT_TRUE(at(-0.7 * peak).empty()) << "it brakes";
}

TEST(UnknownOfMotors, HasALineForEachLawThatIsNotApplied) {
  RobotModel model = WithPlainMotors();
  const std::vector<std::string> none = UnknownOfMotors(model);
  ASSERT_EQ(none.size(), 4U);
  for (const Law law : {Law::kJointAcceleration, Law::kJointJerk, Law::kTorqueSpeed, Law::kContinuousTorque}) {
    EXPECT_EQ(std::count_if(none.begin(), none.end(),
                            [&](const std::string& line) { return line.starts_with(LawName(law) + " not applied:"); }),
              1)
        << law;
  }
  WatchedMotor(model).jerk_limit = 100.0;
  const std::vector<std::string> others = UnknownOfMotors(model);
  ASSERT_EQ(others.size(), 4U);
  EXPECT_NE(others[1].find("not applied to"), std::string::npos);
  EXPECT_EQ(others[1].find("'" + model.dof_names[kWatchedDof] + "'"), std::string::npos) << "its limit is known";
  for (Motor& motor : model.motors) {
    motor.acceleration_limit = motor.jerk_limit = motor.continuous_effort = 100.0;
    motor.corner_speed = 10.0;
    motor.no_load_speed = 20.0;
  }
  EXPECT_TRUE(UnknownOfMotors(model).empty());
}

}  // namespace
}  // namespace gaitwright
