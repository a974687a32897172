// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "playback/score/measurements.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

using synthetic::kStep;
using synthetic::Played;
using synthetic::Stood;
using synthetic::Walked;

constexpr double kNoJointLimit = std::numeric_limits<double>::infinity();

Metric JointMetric(const Played& c, const std::string& key) { return Score(c.model, c.plan, c.log).At(key); }

/// A robot that stands, while its plan moves one joint from 0 to 0.5 and back.
Played WithOneMovingJoint(int dof) {
  Played c = Stood();
  const double rows = static_cast<double>(c.plan.whole_body.size() - 1);
  for (int k = 0; k < c.plan.whole_body.size(); ++k) {
    c.plan.whole_body.q[static_cast<std::size_t>(k)][7 + dof] = 0.5 * std::sin(std::numbers::pi * k / rows);
  }
  return c;
}

TEST(JointMeasurements, PositiveWorkLeavesOutBrakingAndTheIntervalBeforeTheFirstSample) {
  PlaybackLog log;
  const double times[] = {1.0, 1.5, 1.75};
  for (const double time_s : times) {
    LogSample sample;
    sample.time_s = time_s;
    sample.v = VectorX::Zero(8);
    sample.v.tail(2) << 2.0, -3.0;
    sample.v.head(6).setConstant(1e3);  // the base has no motor
    sample.tau = Vector2(10.0, 4.0);    // 20 W, and 12 W of braking
    log.samples.push_back(sample);
  }
  log.samples[2].tau = Vector2(-10.0, -4.0);  // opposite signs: 12 W
  EXPECT_DOUBLE_EQ(PositiveWork(log, 0), 0.0);
  EXPECT_DOUBLE_EQ(PositiveWork(log, 1), 0.0);
  EXPECT_DOUBLE_EQ(PositiveWork(log, 2), 0.5 * 20.0);
  EXPECT_DOUBLE_EQ(PositiveWork(log, 3), 0.5 * 20.0 + 0.25 * 12.0);
}

TEST(JointMeasurements, CostOfTransportIsWorkOverWeightAndDistance) {
  Played c = Walked();
  for (LogSample& sample : c.log.samples) {
    sample.tau.setZero();
    sample.tau[0] = 50.0;
    sample.v[6] = 2.0;
  }
  const double duration = c.log.samples.back().time_s;
  const double distance = (c.log.samples.back().q - c.log.samples.front().q).head<2>().norm();
  EXPECT_NEAR(distance, 0.25, 1e-3) << "each foot goes half a step, two steps, half a step less";
  EXPECT_NEAR(c.Value("cost_of_transport"), 100.0 * duration / (c.model.weight_n() * distance), 1e-9);
}

TEST(JointMeasurements, ARobotThatStaysHasNoCostOfTransport) {
  const Metric cost = JointMetric(Stood(), "cost_of_transport");
  EXPECT_FALSE(cost.value.has_value());
  EXPECT_FALSE(cost.applied);
  EXPECT_FALSE(cost.not_applied.empty());
}

TEST(JointMeasurements, TheLargestTorqueUseIsFoundInLogAndPlan) {
  Played c = Stood();
  c.log.samples[40].effort_use[3] = 0.83;
  const Metric use = JointMetric(c, "torque_use_max");
  EXPECT_DOUBLE_EQ(use.value.value(), 0.83);
  EXPECT_DOUBLE_EQ(use.at_s.value(), c.log.samples[40].time_s);
  EXPECT_NEAR(use.planned.value(), 0.5 * c.model.weight_n() / 200.0, 1e-9) << "each leg carries half the weight";
}

TEST(JointMeasurements, ATorqueLimitThatIsNotKnownIsNotMeasuredAgainst) {
  Played c = Stood();
  for (Joint& joint : c.model.joints) joint.effort_limit = kNoJointLimit;
  for (LogSample& sample : c.log.samples) sample.effort_use.setZero();
  for (const char* key : {"torque_use_max", "torque_saturated_fraction"}) {
    EXPECT_FALSE(JointMetric(c, key).value.has_value()) << key;
  }
  c.log.samples[7].effort_use[1] = 0.4;  // of a limit that exists only in the playback
  EXPECT_DOUBLE_EQ(JointMetric(c, "torque_use_max").value.value(), 0.4);
  EXPECT_FALSE(JointMetric(c, "torque_use_max").planned.has_value());
}

TEST(JointMeasurements, TheSaturatedShareIsThatOfTheWorstMotor) {
  Played c = Stood();
  c.log.saturated_s[2] = 0.25;
  c.log.saturated_s[4] = 0.1;
  EXPECT_NEAR(c.Value("torque_saturated_fraction"), 0.25, 1e-12) << "of one second";
}

TEST(JointMeasurements, SpeedUseIsTheLargestMagnitudeOverItsOwnLimit) {
  Played c = Walked();
  c.model.joints[4].velocity_limit = 4.0;
  c.log.samples[30].v[6 + 4] = -3.0;  // 0.75
  c.log.samples[50].v[6 + 1] = 6.0;   // 0.6 of 10
  const Metric use = JointMetric(c, "joint_speed_use_max");
  EXPECT_DOUBLE_EQ(use.value.value(), 0.75);
  EXPECT_DOUBLE_EQ(use.at_s.value(), 30.0 * kStep);
  EXPECT_LT(use.planned.value(), 0.2);
  for (Joint& joint : c.model.joints) joint.velocity_limit = kNoJointLimit;
  EXPECT_FALSE(JointMetric(c, "joint_speed_use_max").value.has_value());
}

TEST(JointMeasurements, TheMarginToALimitIsThatOfJointsThatThePlanMoves) {
  EXPECT_FALSE(JointMetric(Stood(), "joint_limit_margin_min_rad").value.has_value());
  for (const double place : {0.97, -0.97}) {
    Played c = WithOneMovingJoint(0);
    c.log.samples[60].q[7 + 0] = place;
    c.log.samples[80].q[7 + 1] = 0.999;  // it rests at its limit
    const Metric margin = JointMetric(c, "joint_limit_margin_min_rad");
    EXPECT_NEAR(margin.value.value(), 0.03, 1e-12);
    EXPECT_NEAR(margin.planned.value(), 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(margin.at_s.value(), 60.0 * kStep);
  }
}

TEST(JointMeasurements, AJointMayReturnToTheLimitAtWhichItStands) {
  Played c = WithOneMovingJoint(0);
  c.model.standing_joints[0] = c.model.dof_lower(0);
  c.log.samples[60].q[7 + 0] = c.model.dof_lower(0);
  EXPECT_GT(c.Value("joint_limit_margin_min_rad"), 0.0);
  c.log.samples[60].q[7 + 0] = c.model.dof_upper(0) + 0.01;
  EXPECT_NEAR(c.Value("joint_limit_margin_min_rad"), -0.01, 1e-12);
}

TEST(JointMeasurements, AJointBeyondItsLimitHasANegativeMargin) {
  Played c = WithOneMovingJoint(3);
  c.log.samples[10].q[7 + 3] = 1.02;
  EXPECT_NEAR(c.Value("joint_limit_margin_min_rad"), -0.02, 1e-12);
}

TEST(JointMeasurements, JerkIsZeroForRampsOfSpeedAndKnownForParabolas) {
  Played c = Stood();
  for (LogSample& sample : c.log.samples) sample.v[6 + 2] = 3.0 - 2.0 * sample.time_s;
  EXPECT_NEAR(c.Value("smoothness_jerk_rms"), 0.0, 1e-8);
  for (LogSample& sample : c.log.samples) sample.v[6 + 2] = 3.0 * sample.time_s * sample.time_s;
  EXPECT_NEAR(c.Value("smoothness_jerk_rms"), 6.0 / std::sqrt(6.0), 1e-6) << "one joint of six";
  EXPECT_NEAR(c.Planned("smoothness_jerk_rms"), 0.0, 1e-8);
}

TEST(JointMeasurements, AMotorMayBeHeldBackByItsPeakItsHeatOrItsCurve) {
  Actuator motor;
  EXPECT_FALSE(HasTorqueLimit(motor));
  EXPECT_FALSE(MayBeAtALimit(motor));
  motor.effort_limit = 0.0;
  EXPECT_FALSE(HasTorqueLimit(motor)) << "a placeholder";
  motor.effort_limit = 20.0;
  EXPECT_TRUE(HasTorqueLimit(motor));
  EXPECT_TRUE(MayBeAtALimit(motor));
  Actuator warm, fast;
  warm.motor.continuous_effort = 5.0;
  fast.motor.corner_speed = 10.0;
  fast.motor.no_load_speed = 20.0;
  for (const Actuator& one : {warm, fast}) {
    EXPECT_FALSE(HasTorqueLimit(one));
    EXPECT_TRUE(MayBeAtALimit(one));
  }
}

}  // namespace
}  // namespace gaitwright
