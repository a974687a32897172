// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "playback/score/gates.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

/// A biped that stands for a second, with the plan as a command of a velocity.
synthetic::Played Commanded(const Vector2& velocity) {
  synthetic::Played played = synthetic::Stood();
  played.plan.schedule.phases.clear();
  for (VectorX& v : played.plan.whole_body.v) v.head<2>() = velocity;
  return played;
}

TEST(CommandScoreTest, TheErrorIsTheDifferenceOfVelocities) {
  synthetic::Played played = Commanded(Vector2(0.3, 0.4));
  EXPECT_NEAR(played.Value("command_velocity_error_m_s"), 0.5, 1e-9);
  for (LogSample& sample : played.log.samples) sample.v.head<2>() = Vector2(0.3, 0.4);
  EXPECT_NEAR(played.Value("command_velocity_error_m_s"), 0.0, 1e-9);
  EXPECT_NEAR(played.Value("command_yaw_rate_error_rad_s"), 0.0, 1e-9);
}

TEST(CommandScoreTest, SwayWithinTheWindowDoesNotCount) {
  synthetic::Played played = Commanded(Vector2::Zero());
  for (std::size_t k = 0; k < played.log.samples.size(); ++k) played.log.samples[k].v[1] = k % 2 == 0 ? 0.5 : -0.5;
  EXPECT_LT(played.Value("command_velocity_error_m_s"), 0.02);
}

TEST(CommandScoreTest, ItIsAGateThatGrowsWithTheCommand) {
  const synthetic::Played slow = Commanded(Vector2(0.3, 0.4)), fast = Commanded(Vector2(2.0, 0.0));
  const StabilityReport report = Score(slow.model, slow.plan, slow.log);
  const Metric& error = report.At("command_velocity_error_m_s");
  EXPECT_TRUE(error.applied);
  EXPECT_FALSE(error.pass);
  EXPECT_DOUBLE_EQ(*error.limit, 0.1);
  EXPECT_EQ(report.cause, "command_velocity_error_m_s");
  EXPECT_DOUBLE_EQ(*Score(fast.model, fast.plan, fast.log).At("command_velocity_error_m_s").limit, 0.4);
}

TEST(CommandScoreTest, WhatNeedsAPlanHasNoValue) {
  const synthetic::Played played = Commanded(Vector2::Zero());
  const StabilityReport report = Score(played.model, played.plan, played.log);
  for (const char* key : {"zmp_margin_p05_m", "zmp_error_rms_m", "dcm_error_max_m", "scuffs", "clearance_min_m",
                          "contact_timing_error_max_s", "tracking_joint_rms_rad", "tracking_com_rms_m"}) {
    EXPECT_FALSE(report.At(key).value) << key;
    EXPECT_NE(report.At(key).not_applied, "") << key;
  }
  for (const char* key : {"slip_max_step_m", "torque_saturated_fraction", "fell", "goal_error_m"})
    EXPECT_TRUE(report.At(key).value) << key;
  EXPECT_FALSE(report.At("goal_error_m").applied);
  EXPECT_TRUE(report.pass) << report.reason;
}

TEST(CommandScoreTest, PlansWithContactsHaveNoSuchValueAndKeepTheirScore) {
  const synthetic::Played played = synthetic::Stood();
  const StabilityReport report = Score(played.model, played.plan, played.log);
  EXPECT_FALSE(report.At("command_velocity_error_m_s").value);
  EXPECT_FALSE(report.At("command_velocity_error_m_s").limit);
  std::vector<Metric> others = report.metrics;
  std::erase_if(others, [](const Metric& m) { return m.key.starts_with("command_"); });
  EXPECT_EQ(ScoreOf(others, ScaleOf(played.model, played.plan), 1.0), report.score);
}

}  // namespace
}  // namespace gaitwright
