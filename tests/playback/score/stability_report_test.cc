// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/stability_report.h"

#include <gtest/gtest.h>

#include <numbers>

#include "kinematics/base/result.h"
#include "playback/score/gates.h"
#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

using synthetic::PerfectLog;
using synthetic::Robot;
using synthetic::StandingPlan;
using synthetic::SteppingPlan;

double Value(const StabilityReport& report, const std::string& key) { return report.At(key).value.value(); }

/// Moves the ZMP of every sample by d: adds the moment of the total normal force.
void ShiftZmp(PlaybackLog& log, const Vector2& d) {
  for (LogSample& sample : log.samples) {
    for (ContactWrench& wrench : sample.wrenches) wrench.moment_W += Vector3(d.x(), d.y(), 0.0).cross(wrench.force_W);
  }
}

/// Turns and moves a whole log in plan view, as if the robot's feet had crept.
void Drift(PlaybackLog& log, const Vector2& d, double yaw) {
  const Eigen::AngleAxisd turn(yaw, Vector3::UnitZ());
  for (LogSample& sample : log.samples) {
    sample.q.head<3>() = turn * Vector3(sample.q.head<3>()) + Vector3(d.x(), d.y(), 0.0);
    const Quaternion r(Eigen::Vector4d(sample.q.segment<4>(3)));
    sample.q.segment<4>(3) = (Quaternion(turn) * r).coeffs();
    sample.v.head<3>() = turn * Vector3(sample.v.head<3>());
    for (ContactWrench& wrench : sample.wrenches) {
      wrench.force_W = turn * wrench.force_W;
      wrench.moment_W = turn * wrench.moment_W;
    }
  }
}

TEST(Score, StandingStillHasTheMarginsOfClosedForm) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0, {0.01, 0.02});
  const StabilityReport report = Score(model, plan, PerfectLog(model, plan));
  // The hull of both soles is 0.16 m by 0.28 m; the ZMP is 0.07 m from its front edge and 0.12 m from its left one.
  EXPECT_NEAR(Value(report, "zmp_margin_min_m"), 0.07, 1e-9);
  EXPECT_NEAR(Value(report, "zmp_margin_p05_m"), 0.07, 1e-9);
  EXPECT_NEAR(*report.At("zmp_margin_p05_m").planned, 0.07, 1e-9);
  EXPECT_NEAR(Value(report, "static_margin_min_m"), 0.07, 1e-9);
  EXPECT_NEAR(Value(report, "energy_margin_min_m"), std::hypot(0.07, 0.5) - 0.5, 1e-9);
  EXPECT_EQ(Value(report, "zmp_outside_fraction"), 0.0);
  EXPECT_NEAR(Value(report, "zmp_error_max_m"), 0.0, 1e-9);
  EXPECT_NEAR(Value(report, "dcm_error_max_m"), 0.0, 1e-9);
  EXPECT_EQ(Value(report, "fell"), 0.0);
  EXPECT_TRUE(report.pass) << report.reason;
  EXPECT_FALSE(report.At("cost_of_transport").value.has_value());
  EXPECT_FALSE(report.At("scuffs").applied);
}

TEST(Score, SteppingAsPlannedPassesWithTheErrorsOfTheLogAlone) {
  for (const int legs : {2, 4}) {
    const RobotModel model = Robot(legs, legs == 2 ? FootType::kSole : FootType::kSphere);
    const MotionPlan plan = SteppingPlan(model);
    const StabilityReport report = Score(model, plan, PerfectLog(model, plan));
    EXPECT_TRUE(report.pass) << report.reason;
    EXPECT_LT(Value(report, "zmp_error_max_m"), 1e-3) << "the mean over an interval against its middle";
    EXPECT_LT(Value(report, "tracking_base_rms_m"), 1e-9);
    EXPECT_NEAR(Value(report, "distance_m"), 0.25, 1e-9) << "each foot swings 0.25 m";
    EXPECT_NEAR(Value(report, "goal_error_m"), 0.0, 1e-9);
    EXPECT_NEAR(Value(report, "contact_timing_error_max_s"), 0.0, 1e-9);
    EXPECT_EQ(Value(report, "scuffs"), 0.0);
    EXPECT_GT(Value(report, "clearance_min_m"), 0.01);
    EXPECT_GT(Value(report, "cost_of_transport"), 0.0);
    EXPECT_GT(report.score, 50.0);
  }
}

TEST(Score, TheGateOfALineSupportIsTheCaptureMargin) {
  const RobotModel biped = Robot(2, FootType::kSole), trotter = Robot(4, FootType::kPoint);
  const MotionPlan walk = SteppingPlan(biped), trot = SteppingPlan(trotter);
  const StabilityReport on_soles = Score(biped, walk, PerfectLog(biped, walk));
  const StabilityReport on_lines = Score(trotter, trot, PerfectLog(trotter, trot));
  EXPECT_TRUE(on_soles.At("zmp_margin_p05_m").applied);
  EXPECT_FALSE(on_soles.At("dcm_capture_margin_min_m").applied);
  EXPECT_FALSE(on_lines.At("zmp_margin_p05_m").applied);
  EXPECT_TRUE(on_lines.At("dcm_capture_margin_min_m").applied);
  EXPECT_NE(on_lines.At("zmp_margin_p05_m").not_applied.find("line or a point"), std::string::npos);
  EXPECT_LE(Value(on_lines, "zmp_margin_min_m"), 0.0);
}

TEST(Score, AShiftedZmpShowsInMarginAndErrorInFull) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  PlaybackLog log = PerfectLog(model, plan);
  ShiftZmp(log, {0.03, 0.0});
  const StabilityReport report = Score(model, plan, log);
  EXPECT_NEAR(Value(report, "zmp_margin_min_m"), 0.05, 1e-9);
  EXPECT_NEAR(*report.At("zmp_margin_min_m").planned, 0.08, 1e-9);
  EXPECT_NEAR(Value(report, "zmp_error_mean_m"), 0.03, 1e-9);
  EXPECT_NEAR(Value(report, "zmp_error_rms_m"), 0.03, 1e-9);
}

TEST(Score, AZmpOutsideFailsTheGate) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  PlaybackLog log = PerfectLog(model, plan);
  ShiftZmp(log, {0.1, 0.0});
  const StabilityReport report = Score(model, plan, log);
  EXPECT_NEAR(Value(report, "zmp_margin_p05_m"), -0.02, 1e-9);
  EXPECT_EQ(Value(report, "zmp_outside_fraction"), 1.0);
  EXPECT_FALSE(report.pass);
  EXPECT_LT(report.score, 50.0);
  EXPECT_NE(report.reason.find("zmp_margin_p05_m"), std::string::npos) << report.reason;
}

TEST(Score, DriftOfTheBaseIsNotCountedInZmpAndDcmErrors) {
  for (const int legs : {2, 4}) {
    const RobotModel model = Robot(legs, legs == 2 ? FootType::kSole : FootType::kPoint);
    const MotionPlan plan = SteppingPlan(model);
    PlaybackLog log = PerfectLog(model, plan);
    const StabilityReport straight = Score(model, plan, log);
    Drift(log, {0.3, -0.2}, 0.2);
    const StabilityReport drifted = Score(model, plan, log);
    for (const char* key : {"zmp_error_mean_m", "zmp_error_max_m", "dcm_error_mean_m", "zmp_margin_min_m"}) {
      EXPECT_NEAR(Value(drifted, key), Value(straight, key), 1e-9) << key;
    }
    EXPECT_GT(Value(drifted, "tracking_base_rms_m"), 0.2);
    EXPECT_NEAR(Value(drifted, "heading_error_rad"), 0.2, 1e-9);
    EXPECT_FALSE(drifted.pass) << "the goal is missed";
  }
}

TEST(Score, AFirstOrderLowPassOfTenMillisecondsIsApplied) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  PlaybackLog log = PerfectLog(model, plan);
  PlaybackLog spike = log;
  spike.samples = {log.samples[100]};
  ShiftZmp(spike, {0.04, 0.0});
  log.samples[100] = spike.samples[0];
  const StabilityReport report = Score(model, plan, log);
  EXPECT_NEAR(Value(report, "zmp_error_max_m"), 0.04 * (1.0 - std::exp(-0.5)), 1e-9);
  EXPECT_NEAR(*report.At("zmp_error_max_m").at_s, 0.5, 1e-9);
}

TEST(Score, ATiltedBaseHasFallenWhenItPassesTheBound) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  PlaybackLog log = PerfectLog(model, plan);
  for (LogSample& sample : log.samples) {
    const double tilt = std::max(0.0, sample.time_s - 0.4) * 3.9;  // 0.6 rad at 0.554 s
    sample.q.segment<4>(3) = Quaternion(Eigen::AngleAxisd(tilt, Vector3::UnitX())).coeffs();
  }
  const StabilityReport report = Score(model, plan, log);
  EXPECT_EQ(Value(report, "fell"), 1.0);
  EXPECT_NEAR(Value(report, "time_to_fall_s"), 0.555, 1e-9);
  EXPECT_LT(report.score, 25.0);
  EXPECT_NE(report.reason.find("the robot fell at 0.5"), std::string::npos) << report.reason;
  EXPECT_NE(report.reason.find("tilted"), std::string::npos) << report.reason;
}

TEST(Score, FeetDownAtTheBeginningYieldedWhileTheRobotSettled) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  PlaybackLog log = PerfectLog(model, plan);
  for (LogSample& sample : log.samples)
    sample.q.segment<4>(3) = Quaternion(Eigen::AngleAxisd(1.0, Vector3::UnitX())).coeffs();
  const std::string reason = Score(model, plan, log).reason;
  EXPECT_NE(reason.find("the robot fell while settling, before the plan began: "), std::string::npos) << reason;
}

TEST(Score, AYawedBaseHasNotFallen) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  PlaybackLog log = PerfectLog(model, plan);
  Drift(log, {0.0, 0.0}, std::numbers::pi);
  EXPECT_EQ(Value(Score(model, plan, log), "fell"), 0.0);
}

TEST(Score, ALowBaseABodyOnTheGroundAndAShortLogAreFalls) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = StandingPlan(model, 1.0);
  PlaybackLog low = PerfectLog(model, plan), body = low, cut = low, broken = low;
  synthetic::Sink(low, 80, 0.29);
  body.body_contacts = {{0.7, "left_z"}};
  cut.samples.resize(50);
  broken.samples[60].q[9] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NEAR(Value(Score(model, plan, low), "time_to_fall_s"), 0.4, 1e-9);
  EXPECT_NEAR(Value(Score(model, plan, body), "time_to_fall_s"), 0.7, 1e-9);
  EXPECT_NE(Score(model, plan, body).reason.find("'left_z'"), std::string::npos);
  EXPECT_NEAR(Value(Score(model, plan, cut), "time_to_fall_s"), 0.245, 1e-9);
  EXPECT_NEAR(Value(Score(model, plan, broken), "time_to_fall_s"), 0.3, 1e-9);
}

TEST(Score, SaturationSpeedAndLimitsAreSharesOfLimits) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = SteppingPlan(model);
  PlaybackLog log = PerfectLog(model, plan);
  log.saturated_s[4] = 0.03 * plan.duration_s();
  log.samples[20].effort_use[4] = 1.0;
  log.samples[30].v[6 + 1] = -5.0;
  log.samples[40].q[7] = 0.9;
  const StabilityReport report = Score(model, plan, log);
  EXPECT_NEAR(Value(report, "torque_saturated_fraction"), 0.03, 1e-12);
  EXPECT_FALSE(report.At("torque_saturated_fraction").pass);
  EXPECT_EQ(Value(report, "torque_use_max"), 1.0);
  EXPECT_NEAR(*report.At("torque_use_max").at_s, 0.1, 1e-12);
  EXPECT_NEAR(*report.At("torque_use_max").planned, model.weight_n() / 200.0, 1e-9) << "one leg carries all";
  EXPECT_NEAR(Value(report, "joint_speed_use_max"), 0.5, 1e-12);
  EXPECT_NEAR(Value(report, "joint_limit_margin_min_rad"), 0.1, 1e-12);
  EXPECT_NEAR(*report.At("joint_limit_margin_min_rad").planned, 0.5, 1e-9);
}

TEST(Score, AMotorWithoutAPeakMaySaturateAtItsContinuousEffort) {
  RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = SteppingPlan(model);
  PlaybackLog log = PerfectLog(model, plan);
  for (Joint& joint : model.joints) joint.effort_limit_is_placeholder = true;
  log.saturated_s[4] = 0.5 * plan.duration_s();
  EXPECT_FALSE(Score(model, plan, log).At("torque_saturated_fraction").value) << "nothing can hold a motor back";
  model.motors.resize(model.dof_names.size());
  model.motors[4].continuous_effort = 20.0;
  EXPECT_NEAR(Value(Score(model, plan, log), "torque_saturated_fraction"), 0.5, 1e-12);
  EXPECT_FALSE(Score(model, plan, log).At("torque_saturated_fraction").pass);
  model.motors[4] = Motor();
  model.motors[4].corner_speed = 1.0;
  model.motors[4].no_load_speed = 2.0;
  EXPECT_NEAR(Value(Score(model, plan, log), "torque_saturated_fraction"), 0.5, 1e-12);
}

TEST(Score, AJointParkedAtItsLimitIsNotHeldAgainstThePlayback) {
  RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = SteppingPlan(model);
  model.joints[2].upper = -0.4;
  EXPECT_TRUE(Score(model, plan, PerfectLog(model, plan)).At("joint_limit_margin_min_rad").pass);
  model.joints[2].upper = -0.47;
  EXPECT_FALSE(Score(model, plan, PerfectLog(model, plan)).At("joint_limit_margin_min_rad").pass) << "it moves past";
  const MotionPlan still = StandingPlan(model, 1.0);
  model.joints[2].upper = -synthetic::kHeight;
  EXPECT_TRUE(Score(model, still, PerfectLog(model, still)).At("joint_limit_margin_min_rad").pass) << "parked";
}

TEST(Score, PlaceholderLimitsJudgeNothingAndAreNoted) {
  RobotModel model = Robot(2, FootType::kSole);
  for (Joint& joint : model.joints) joint.effort_limit_is_placeholder = joint.velocity_limit_is_placeholder = true;
  const MotionPlan plan = StandingPlan(model, 1.0);
  const StabilityReport report = Score(model, plan, PerfectLog(model, plan));
  EXPECT_FALSE(report.At("torque_saturated_fraction").applied);
  EXPECT_FALSE(report.At("joint_speed_use_max").value.has_value());
  EXPECT_EQ(report.notes.size(), 2u);
}

TEST(Score, GoalErrorIsAgainstTheCommandAndNotThePlansEnd) {
  const RobotModel model = Robot(2, FootType::kSole);
  MotionPlan plan = SteppingPlan(model);
  plan.goal.x_m += 0.4;
  const StabilityReport report = Score(model, plan, PerfectLog(model, plan));
  EXPECT_NEAR(Value(report, "goal_error_m"), 0.4, 1e-9);
  EXPECT_NEAR(*report.At("goal_error_m").limit, 0.05 * 0.65, 1e-9);
  EXPECT_FALSE(report.pass);
}

TEST(Score, CostOfTransportIsPositiveWorkOverWeightAndDistance) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = SteppingPlan(model);
  PlaybackLog log = PerfectLog(model, plan);
  for (LogSample& sample : log.samples) {
    sample.tau.setZero();
    sample.v.tail(6).setZero();
  }
  log.samples[200].tau[0] = 10.0;
  log.samples[200].v[6] = 2.0;  // 20 W for one interval
  log.samples[300].tau[0] = -10.0;
  log.samples[300].v[6] = 2.0;  // braking costs nothing
  EXPECT_NEAR(Value(Score(model, plan, log), "cost_of_transport"), 20.0 * 0.005 / (model.weight_n() * 0.25), 1e-9);
}

TEST(Score, IsPureAndRefusesWhatDoesNotFit) {
  const RobotModel model = Robot(2, FootType::kSole), other = Robot(4, FootType::kPoint);
  const MotionPlan plan = SteppingPlan(model);
  const PlaybackLog log = PerfectLog(model, plan);
  EXPECT_EQ(Score(model, plan, log), Score(model, plan, log));
  EXPECT_THROW(Score(other, plan, log), InvalidArgument);
  EXPECT_THROW(Score(model, plan, PlaybackLog{}), InvalidArgument);
  EXPECT_THROW(Score(model, MotionPlan{}, log), InvalidArgument);
  PlaybackLog odd = log;
  odd.stances[3].foot = 2;
  EXPECT_THROW(Score(model, plan, odd), InvalidArgument);
  odd = log;
  std::swap(odd.samples[3], odd.samples[4]);
  EXPECT_THROW(Score(model, plan, odd), InvalidArgument);
  odd = log;
  odd.log_rate_hz = std::nan("");
  EXPECT_THROW(Score(model, plan, odd), InvalidArgument);
  odd = log;
  odd.samples[7].wrenches.resize(3);
  EXPECT_THROW(Score(model, plan, odd), InvalidArgument);
  ScoreOptions options;
  options.zmp_filter_s = -1.0;
  EXPECT_THROW(Score(model, plan, log, options), InvalidArgument);
  EXPECT_THROW(Score(model, plan, log).At("zmp_margin"), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
