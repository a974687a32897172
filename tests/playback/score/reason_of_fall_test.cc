// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/reason_of_fall.h"

#include <gtest/gtest.h>

#include "playback/score/reason.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

using synthetic::PerfectLog;
using synthetic::Robot;
using synthetic::Says;
using synthetic::StandingPlan;
using synthetic::SteppingPlan;

/// Tips the robot about its left edge from 0.4 s on, with increasing speed.
void TipToTheLeft(PlaybackLog& log) {
  for (LogSample& sample : log.samples) {
    const double t = std::max(0.0, sample.time_s - 0.4);
    sample.q[1] += 2.0 * t * t;
    sample.v[1] += 4.0 * t;
    sample.q.segment<4>(3) = Quaternion(Eigen::AngleAxisd(-4.0 * t * t, Vector3::UnitX())).coeffs();
    for (const int slider : {1, 4}) sample.q[7 + slider] -= 2.0 * t * t;
  }
}

TEST(ReasonOfFall, ADcmThatLeavesTheSupportIsNamedWithPlaceAndDirection) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  PlaybackLog log = PerfectLog(model, plan);
  TipToTheLeft(log);
  const StabilityReport report = Score(model, plan, log);
  EXPECT_TRUE(Says(report.reason, "the robot fell at")) << report.reason;
  EXPECT_TRUE(Says(report.reason, "the DCM had left the support of 'left', 'right'")) << report.reason;
  EXPECT_TRUE(Says(report.reason, "mm to the left")) << report.reason;
}

/// Tips to the left. From 0.3 s on, one motor has a torque that is a share of its limit.
PlaybackLog TippingLog(const RobotModel& model, const MotionPlan& plan, double torque, double share = 1.0) {
  PlaybackLog log = PerfectLog(model, plan);
  TipToTheLeft(log);
  for (LogSample& sample : log.samples) {
    if (sample.time_s < 0.299) continue;
    sample.tau_peak[4] = torque;
    sample.effort_use[4] = share;
  }
  return log;
}

TEST(ReasonOfFall, ATorqueLimitThatCameFirstIsNamedFirst) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  const PlaybackLog log = TippingLog(model, plan, 200.0);
  const std::string reason = Score(model, plan, log).reason;
  EXPECT_TRUE(Says(reason, "first, the torque of 'right_y' was at its limit 200.00 N from 0.30 s; then at")) << reason;
}

TEST(ReasonOfFall, TheTorqueLimitIsThatOfTheMotorsAsTheyWerePlayed) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  PlaybackLog log = TippingLog(model, plan, 60.0, 0.3);
  EXPECT_FALSE(Says(Score(model, plan, log).reason, "at its limit"));
  log = TippingLog(model, plan, 60.0);
  log.options = {{"play.motor_strength", "0.3"}};
  EXPECT_TRUE(Says(Score(model, plan, log).reason,
                   "'right_y' was at its limit 60.00 N of 200.00 N (reduced by the motor's strength) from 0.30 s"));
  log = TippingLog(model, plan, 200.0, 1.0 / 3.0);
  log.options = {{"play.motor_strength", "3"}};
  EXPECT_FALSE(Says(Score(model, plan, log).reason, "at its limit"));
}

TEST(ReasonOfFall, TheTorqueLostToSpeedAndWarmthIsReported) {
  RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  model.motors.resize(model.dof_names.size());
  model.motors[4].corner_speed = 1.0;
  model.motors[4].no_load_speed = 2.0;
  const auto reason = [&](double speed, double torque) {
    PlaybackLog log = TippingLog(model, plan, torque);
    for (LogSample& sample : log.samples) {
      sample.tau[4] = torque;
      sample.v[6 + 4] = speed;
    }
    return Score(model, plan, log).reason;
  };
  EXPECT_TRUE(Says(reason(1.7, 60.0), "limit 60.00 N of 200.00 N (reduced by the motor's speed) from"));
  EXPECT_TRUE(Says(reason(0.5, 60.0), "limit 60.00 N of 200.00 N from")) << "nothing that is known";
  model.motors[4].continuous_effort = 50.0;
  EXPECT_TRUE(Says(reason(1.7, 60.0), "(reduced by the motor's speed) from"));
  EXPECT_TRUE(Says(reason(1.7, 50.0), "(reduced by the motor's speed and warmth) from"));
  EXPECT_TRUE(Says(reason(0.5, 60.0), "(reduced by the motor's warmth) from"));
  EXPECT_TRUE(Says(reason(-1.7, 60.0), "(reduced by the motor's warmth) from")) << "it brakes";
  PlaybackLog log = TippingLog(model, plan, 60.0);
  for (Joint& joint : model.joints) joint.effort_limit_is_placeholder = true;
  EXPECT_TRUE(Says(Score(model, plan, log).reason, "'right_y' was at its limit 60.00 N from")) << "no other is known";
}

TEST(ReasonOfFall, AFootThatLiftsIsALostContact) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  PlaybackLog log = PerfectLog(model, plan);
  for (LogSample& sample : log.samples) {
    if (sample.time_s > 0.349) sample.contact = 1;
  }
  log.body_contacts = {{0.8, "trunk"}};
  const std::string reason = Score(model, plan, log).reason;
  EXPECT_TRUE(Says(reason, "'right' was off the ground")) << reason;
  EXPECT_TRUE(Says(reason, "at 0.35 s")) << reason;
  EXPECT_TRUE(Says(reason, "'trunk'")) << reason;
}

TEST(ReasonOfFall, SlipScuffAndMissedFootholdAreReported) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = SteppingPlan(model);
  const PlaybackLog good = PerfectLog(model, plan);
  const double step_at = plan.schedule.phases[2].start_s;  // the left foot lands

  PlaybackLog slip = good;
  slip.stances[0].slip_m = 0.05;
  EXPECT_TRUE(Says(Score(model, plan, slip).reason, "had slid more than 14.3 mm (in all 50.0 mm"))
      << Score(model, plan, slip).reason;

  PlaybackLog scuff = good;
  StanceRecord touch;
  touch.touchdown_s = step_at - 0.2;
  touch.liftoff_s = step_at - 0.18;
  scuff.stances.push_back(touch);
  EXPECT_EQ(*Score(model, plan, scuff).At("scuffs").value, 1.0);
  EXPECT_TRUE(Says(Score(model, plan, scuff).reason, "'left' touched the ground in mid swing"));

  PlaybackLog missed = good;
  for (StanceRecord& stance : missed.stances) {
    if (stance.touchdown_s == step_at) stance.p_touchdown_W.y() -= 0.06;
  }
  missed.body_contacts = {{step_at + 0.5, "trunk"}};
  const std::string reason = Score(model, plan, missed).reason;
  EXPECT_TRUE(Says(reason, "'left' came down 60 mm off its foothold, to the right")) << reason;
}

TEST(ReasonOfFall, APlanThatCannotStandIsBlamedItself) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0, {0.1, 0.0});  // 20 mm in front of the toes
  PlaybackLog log = PerfectLog(model, plan);
  log.body_contacts = {{0.5, "trunk"}};
  const std::string reason = Score(model, plan, log).reason;
  EXPECT_TRUE(Says(reason, "the plan itself has its ZMP outside the support")) << reason;
  EXPECT_TRUE(Says(reason, "by up to 20 mm")) << reason;
}

TEST(ReasonOfFall, APassNamesTheTightestGate) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = SteppingPlan(model);
  PlaybackLog log = PerfectLog(model, plan);
  log.stances[0].penetration_m = 0.0019;
  const StabilityReport report = Score(model, plan, log);
  EXPECT_TRUE(report.pass);
  EXPECT_EQ(report.reason, "every gate passes; closest to its limit is penetration_max_m with 1.9 mm of 2.0 mm");
}

TEST(ReasonOfFall, APlanPastItsOwnLimitsIsBlamedItself) {
  RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = SteppingPlan(model);
  const PlaybackLog log = PerfectLog(model, plan);
  model.joints[2].upper = -0.47;
  EXPECT_TRUE(Says(Score(model, plan, log).reason, "the plan itself moves 'left_z'")) << Score(model, plan, log).reason;
  model.joints[2].upper = 1.0;
  MotionPlan doubled = plan;
  for (VectorX& tau : doubled.whole_body.tau) tau *= 3.0;
  PlaybackLog fallen = log;
  fallen.body_contacts = {{3.0, "trunk"}};
  const std::string reason = Score(model, doubled, fallen).reason;
  EXPECT_TRUE(Says(reason, "the plan itself needs")) << reason;
  EXPECT_TRUE(Says(reason, "whose limit is 200.00 N")) << reason;
}

TEST(ReasonOfFall, WhatThePlanDidNotKnowIsNamed) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = SteppingPlan(model);
  PlaybackLog log = PerfectLog(model, plan);
  EXPECT_TRUE(DisturbancesOf(plan, log).empty());
  log.options = {{"play.ground_slope_deg", "2"}, {"play.ground_bumps_m", "0.01"}, {"play.friction", "0.3"},
                 {"play.mass_scale", "1.2"},     {"play.com_shift_y_m", "0.08"},  {"command_delay_s", "0.03"},
                 {"play.motor_strength", "0.3"}, {"state", "estimated"},          {"play.start_roll_rad", "-0.1"}};
  log.pushes = {{Vector3(0.0, -60.0, 0.0), 3.0, 0.1, "base"}};
  const std::vector<std::string> expected = {"a push of 60 N to the right from 3.00 s for 0.10 s",
                                             "a slope of 2 degrees",
                                             "bumps of 10 mm",
                                             "a friction of 0.3",
                                             "1.2 times the mass",
                                             "the base's centre of mass shifted by 80 mm",
                                             "a command delay of 30 ms",
                                             "0.3 times the motors' strength",
                                             "the state source estimated",
                                             "a start rotated by 0.1 rad"};
  EXPECT_EQ(DisturbancesOf(plan, log), expected);
  log.body_contacts = {{3.5, "trunk"}};
  const std::string reason = Score(model, plan, log).reason;
  EXPECT_TRUE(Says(reason, "under a push of 60 N to the right from 3.00 s for 0.10 s, ")) << reason;
  EXPECT_TRUE(Says(
      reason, "a command delay of 30 ms, 0.3 times the motors' strength and 5 smaller disturbances: the robot fell"))
      << reason;
  log.options = {{"play.friction", "0.8"}, {"play.step_s", "0.001"}, {"command_delay_s", "0.0004"}};
  EXPECT_EQ(DisturbancesOf(plan, log).size(), 1U) << "the plan's own friction, and less than half a step";
}

TEST(ReasonOfFall, APushThatCameAfterTheFallIsNotItsCause) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = SteppingPlan(model);
  PlaybackLog log = PerfectLog(model, plan);
  log.pushes = {{Vector3(1.0, 0.0, 0.0), 0.1, 0.1, "base"},
                {Vector3(2.0, 0.0, 0.0), 0.5, 0.1, "base"},
                {Vector3(260.0, 0.0, 0.0), 1.0, 0.1, "base"},
                {Vector3(4.0, 0.0, 0.0), 1.6, 0.1, "base"}};
  log.body_contacts = {{1.5, "trunk"}};
  const std::string reason = Score(model, plan, log).reason;
  EXPECT_TRUE(Says(reason, "under a push of 2 N forward from 0.50 s for 0.10 s, a push of 260 N forward from 1.00 s"))
      << reason;
  EXPECT_FALSE(Says(reason, "4 N")) << reason;
}

}  // namespace
}  // namespace gaitwright
