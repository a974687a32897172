// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/gates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "playback/score/stability_report.h"
#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

const MetricRule& Rule(const std::string& key) {
  for (const MetricRule& rule : MetricRules()) {
    if (rule.key == key) return rule;
  }
  throw std::runtime_error("no rule " + key);
}

/// The metrics with Score's gates after one value has changed.
std::vector<Metric> WithValue(std::vector<Metric> metrics, std::size_t i, double value) {
  metrics[i].value = value;
  if (metrics[i].applied) metrics[i].pass = Holds(metrics[i].bound, value, *metrics[i].limit);
  return metrics;
}

TEST(Gates, EveryKeyIsThereOnce) {
  std::set<std::string> keys;
  for (const MetricRule& rule : MetricRules()) EXPECT_TRUE(keys.insert(rule.key).second) << rule.key;
  for (const char* key : {"fell",
                          "time_to_fall_s",
                          "distance_m",
                          "goal_error_m",
                          "heading_error_rad",
                          "zmp_margin_min_m",
                          "zmp_margin_p05_m",
                          "zmp_outside_fraction",
                          "zmp_error_mean_m",
                          "zmp_error_rms_m",
                          "zmp_error_max_m",
                          "dcm_error_mean_m",
                          "dcm_error_max_m",
                          "dcm_capture_margin_min_m",
                          "static_margin_min_m",
                          "energy_margin_min_m",
                          "tracking_joint_rms_rad",
                          "tracking_base_rms_m",
                          "tracking_com_rms_m",
                          "slip_total_m",
                          "slip_max_step_m",
                          "penetration_max_m",
                          "clearance_min_m",
                          "scuffs",
                          "impact_max_n_per_mg",
                          "touchdown_speed_max_m_s",
                          "friction_use_max",
                          "torque_use_max",
                          "torque_saturated_fraction",
                          "joint_speed_use_max",
                          "joint_limit_margin_min_rad",
                          "contact_timing_error_max_s",
                          "cost_of_transport",
                          "smoothness_jerk_rms"}) {
    EXPECT_TRUE(keys.count(key)) << key;
  }
}

TEST(Gates, LimitsAreThoseOfTheTableAndScaleWithTheLegOnlyWhereMarked) {
  const GateScale reference{kReferenceLegLength, 2.0}, half{0.5 * kReferenceLegLength, 0.1};
  EXPECT_DOUBLE_EQ(*LimitOf(Rule("slip_max_step_m"), reference), 0.010);
  EXPECT_DOUBLE_EQ(*LimitOf(Rule("slip_max_step_m"), half), 0.005);
  EXPECT_DOUBLE_EQ(*LimitOf(Rule("penetration_max_m"), half), 0.002);
  EXPECT_DOUBLE_EQ(*LimitOf(Rule("goal_error_m"), reference), 0.1);
  EXPECT_DOUBLE_EQ(*LimitOf(Rule("goal_error_m"), half), 0.02);
  EXPECT_DOUBLE_EQ(*LimitOf(Rule("contact_timing_error_max_s"), half), 0.040);
  EXPECT_DOUBLE_EQ(*LimitOf(Rule("torque_saturated_fraction"), half), 0.01);
  EXPECT_FALSE(LimitOf(Rule("cost_of_transport"), reference).has_value());
}

TEST(Gates, BoundsHoldAsWritten) {
  EXPECT_TRUE(Holds(Bound::kAtMost, 1.0, 1.0));
  EXPECT_FALSE(Holds(Bound::kAtMost, 1.1, 1.0));
  EXPECT_TRUE(Holds(Bound::kAbove, 1e-9, 0.0));
  EXPECT_FALSE(Holds(Bound::kAbove, -1e-6, 0.0));
  EXPECT_FALSE(Holds(Bound::kAbove, 0.0, 0.0)) << "a joint at its stop";
  EXPECT_TRUE(Holds(Bound::kAtMost, 1.0 + 3e-17, 1.0)) << "rounding";
  EXPECT_TRUE(Holds(Bound::kAtLeast, 0.0, 0.0));
  EXPECT_TRUE(Holds(Bound::kNone, 9.0, 0.0));
}

TEST(Gates, TheScoreNeverRisesWhenAnyMetricGetsWorse) {
  const GateScale scale{0.4, 1.0};
  for (const int legs : {2, 4}) {
    const RobotModel model = synthetic::Robot(legs, legs == 2 ? FootType::kSole : FootType::kPoint);
    const MotionPlan plan = synthetic::SteppingPlan(model);
    const auto metrics = Score(model, plan, synthetic::PerfectLog(model, plan)).metrics;
    ASSERT_EQ(metrics.size(), MetricRules().size());
    for (std::size_t i = 0; i < metrics.size(); ++i) {
      const MetricRule& rule = MetricRules()[i];
      if (!metrics[i].value || rule.better == Better::kNeither) continue;
      double before = ScoreOf(metrics, scale, 0.5);
      for (const double step : {1e-3, 1e-2, 0.1, 1.0, 10.0}) {
        const double worse = *metrics[i].value + (rule.better == Better::kLower ? step : -step);
        const double after = ScoreOf(WithValue(metrics, i, worse), scale, 0.5);
        EXPECT_LE(after, before) << rule.key;
        if (rule.weight > 0.0 && before > 1e-9 && step <= 0.1) {
          EXPECT_LT(after, before) << rule.key << " has no effect";
        }
        before = after;
      }
    }
  }
}

TEST(Gates, AFallIsWorseThanStandingAndAnEarlierOneWorseThanALaterOne) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  const MotionPlan plan = synthetic::SteppingPlan(model);
  auto metrics = Score(model, plan, synthetic::PerfectLog(model, plan)).metrics;
  const GateScale scale{0.4, 1.0};
  const double standing = ScoreOf(metrics, scale, 1.0);
  EXPECT_GT(standing, 50.0);
  EXPECT_LE(standing, 100.0);
  metrics = WithValue(metrics, 0, 1.0);
  EXPECT_LT(ScoreOf(metrics, scale, 0.9), 25.0);
  EXPECT_LT(ScoreOf(metrics, scale, 0.2), ScoreOf(metrics, scale, 0.9));
  EXPECT_GE(ScoreOf(metrics, scale, 0.0), 0.0);
}

TEST(Gates, AFallStaysBelowAFailureWithoutAFall) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  const MotionPlan plan = synthetic::StandingPlan(model, 1.0);
  auto metrics = Score(model, plan, synthetic::PerfectLog(model, plan)).metrics;
  const GateScale scale{0.4, 1.0};
  for (std::size_t i = 1; i < metrics.size(); ++i) {
    if (!metrics[i].applied) continue;
    auto failing = WithValue(metrics, i, metrics[i].bound == Bound::kAtMost ? 1e3 : -1e3);
    const double failed = ScoreOf(failing, scale, 1.0);
    EXPECT_LT(failed, 50.0) << metrics[i].key;
    EXPECT_LE(ScoreOf(WithValue(failing, 0, 1.0), scale, 1.0), failed) << metrics[i].key;
  }
}

}  // namespace
}  // namespace gaitwright
