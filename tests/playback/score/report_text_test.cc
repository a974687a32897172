// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/report_text.h"

#include <gtest/gtest.h>

#include "playback/score/gates.h"
#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

StabilityReport WalkReport(FootType type) {
  const RobotModel model = synthetic::Robot(type == FootType::kSole ? 2 : 4, type);
  const MotionPlan plan = synthetic::SteppingPlan(model);
  return Score(model, plan, synthetic::PerfectLog(model, plan));
}

TEST(ReportText, HasVerdictScoreReasonAndEveryMetric) {
  const StabilityReport report = WalkReport(FootType::kSole);
  const std::string text = ReportText(report);
  EXPECT_EQ(text.rfind("PASS   score ", 0), 0u) << text;
  EXPECT_NE(text.find(report.reason), std::string::npos);
  for (const Metric& metric : report.metrics) {
    const bool optional = metric.key.starts_with("estimate_") || metric.key.starts_with("command_");
    const bool left_out = !metric.value && optional;
    EXPECT_EQ(text.find(metric.key) == std::string::npos, left_out) << metric.key;
  }
  EXPECT_NE(text.find("<= 40 ms"), std::string::npos);
}

TEST(ReportText, NamesGatesThatDoNotApply) {
  const std::string text = ReportText(WalkReport(FootType::kPoint));
  EXPECT_NE(text.find("gates that do not apply:\n  zmp_margin_p05_m: the support is a line"), std::string::npos)
      << text;
}

TEST(ReportText, FiguresAreForPeople) {
  Metric metric;
  metric.unit = "m";
  metric.key = "zmp_margin_min_m";
  EXPECT_EQ(FigureText(metric, 0.0234), "23.4 mm");
  metric.key = "distance_m";
  EXPECT_EQ(FigureText(metric, 1.25), "1.250 m");
  metric.unit = "1";
  metric.key = "torque_saturated_fraction";
  EXPECT_EQ(FigureText(metric, 0.012), "1.2 %");
  metric.key = "fell";
  EXPECT_EQ(FigureText(metric, 1.0), "yes");
}

TEST(ReportText, JsonHasTheStableObject) {
  const std::string json = ReportJson(WalkReport(FootType::kSole));
  for (const char* part : {"\"robot\": \"block_biped\"", "\"verdict\": \"pass\"",
                           "\"score\": ", "\"reason\": ", "\"fell\": {\n      \"value\": false",
                           "\"scuffs\": {\n      \"value\": 0,", "\"time_to_fall_s\": {\n      \"value\": null"}) {
    EXPECT_NE(json.find(part), std::string::npos) << part;
  }
  for (const MetricRule& rule : MetricRules())
    EXPECT_NE(json.find('"' + rule.key + '"'), std::string::npos) << rule.key;
}

}  // namespace
}  // namespace gaitwright
