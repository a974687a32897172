// SPDX-License-Identifier: BSD-3-Clause
// Playbacks with numbers beyond all bounds end as a fall with its reason, and with a log.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kinematics/base/result.h"
#include "playback/control/joint_pd.h"
#include "playback/log/log_json.h"
#include "playback/play/play.h"
#include "playback/report/report_page.h"
#include "playback/score/stability_report.h"
#include "tests/playback/standing_plan.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// A push that makes the simulation diverge.
const Vector3 kBlowUp(0.0, kNoNumber, 0.0);

/// Holds the posture until it gives a torque that is not a number.
class Failing : public JointPd {
 public:
  Failing(const RobotModel& model, const MotionPlan& plan, int after) : JointPd(model, plan), left_(after) {}

  JointCommand Update(const ControlInput& input) override {
    JointCommand command = JointPd::Update(input);
    if (left_-- <= 0) command.tau_ff[0] = kNoNumber;
    return command;
  }

 private:
  int left_;
};

/// Holds the posture, with an estimate that diverges.
class Astray : public JointPd {
 public:
  Astray(const RobotModel& model, const MotionPlan& plan, int after) : JointPd(model, plan), left_(after) {}

  JointCommand Update(const ControlInput& input) override {
    estimate_.p_WB.x() = left_-- <= 0 ? 1e30 : 0.0;
    return JointPd::Update(input);
  }
  const BaseEstimate* Estimate() const override { return &estimate_; }

 private:
  int left_;
  BaseEstimate estimate_;
};

class BrokenOff : public testing::Test {
 protected:
  /// The log is complete, reads back, and scores as a fall at that time for that reason.
  void ExpectFall(const PlaybackLog& log, double at_s, const std::string& why, const std::string& cause) const {
    ASSERT_FALSE(log.samples.empty());
    EXPECT_NEAR(log.samples.back().time_s, at_s, 1e-9);
    const Result<PlaybackLog> again = LogFromJson(LogToJson(log), "log");
    ASSERT_TRUE(again) << again.failure().message;
    EXPECT_EQ(again->broke_off, log.broke_off);
    EXPECT_TRUE(LogToJson(*again) == LogToJson(log));
    const StabilityReport report = Score(model_, plan_, *again, {});
    EXPECT_FALSE(report.pass);
    EXPECT_EQ(report.At("fell").value, 1.0);
    EXPECT_NEAR(report.At("time_to_fall_s").value.value_or(-1.0), at_s, 1e-9);
    EXPECT_NE(report.reason.find(why), std::string::npos) << report.reason;
    EXPECT_EQ(report.cause, cause);
    for (const Metric& metric : report.metrics) EXPECT_TRUE(std::isfinite(metric.value.value_or(0.0))) << metric.key;
    EXPECT_TRUE(std::isfinite(report.score));
    EXPECT_EQ(XmlFault(ReportPage(model_, plan_, *again, report)), "");
  }

  PlaybackLog Played(Controller&& controller, const PlayOptions& options = {}) const {
    return Play(model_, plan_, controller, options).value();
  }

  const RobotModel model_ = standing::Load("a1");
  const MotionPlan plan_ = standing::Plan(model_, 0.5);
};

TEST_F(BrokenOff, WhileItSettles) {
  const PlaybackLog log = Played(Failing(model_, plan_, 30));
  EXPECT_EQ(log.samples.size(), 1U);
  ExpectFall(log, 0.0, "the controller gave a command that is not finite", "the controller's output was not finite");
}

TEST_F(BrokenOff, BeforeTheFirstSample) {
  PlayOptions options;
  options.more_pushes = {{kBlowUp, 0.002, 0.1, "base"}};
  const PlaybackLog log = Played(JointPd(model_, plan_), options);
  EXPECT_EQ(log.samples.size(), 1U);
  ExpectFall(log, 0.002, "the physics gave a state that is not finite", "the simulation diverged");
}

TEST_F(BrokenOff, DuringAndAfterThePlan) {
  for (const double at_s : {0.2, 0.6}) {
    PlayOptions options;
    options.more_pushes = {{kBlowUp, at_s, 0.1, "base"}};
    const PlaybackLog log = Played(JointPd(model_, plan_), options);
    ExpectFall(log, at_s, "the physics gave a state that is not finite", "the simulation diverged");
  }
}

TEST_F(BrokenOff, WithAnEstimateThatGoesAstray) {
  const std::string why = "the controller's estimate of the base is not finite",
                    cause = "the controller's output was not finite";
  ExpectFall(Played(Astray(model_, plan_, 30)), 0.0, why, cause);
  const PlaybackLog log = Played(Astray(model_, plan_, 400));
  ExpectFall(log, 0.195, why, cause);
  for (const LogSample& sample : log.samples) EXPECT_TRUE(sample.estimate.has_value());
}

TEST_F(BrokenOff, WhatIsWrongButANumberStillThrows) {
  class Short : public JointPd {
   public:
    using JointPd::JointPd;
    JointCommand Update(const ControlInput&) override { return {}; }
  };
  Short controller(model_, plan_);
  EXPECT_THROW((void)Play(model_, plan_, controller), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
