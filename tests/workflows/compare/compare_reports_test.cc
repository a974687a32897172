// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/compare/compare_reports.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "playback/score/report_text.h"
#include "tests/playback/played.h"
#include "tests/playback/xml_check.h"
#include "workflows/compare/comparison_text.h"
#include "workflows/exchange/motion_file.h"

namespace gaitwright {
namespace {

ReadReport ReportOf(const synthetic::Played& played) {
  const std::string text = ReportJson(Score(played.model, played.plan, played.log));
  EXPECT_EQ(KindOfText(text), MotionFileKind::kReport);
  return ReportFromJson(text, "report.json").value();
}

const MetricPair& At(const ReportComparison& c, const std::string& key) {
  for (const MetricPair& metric : c.metrics) {
    if (metric.key == key) return metric;
  }
  throw InvalidArgument("no metric " + key);
}

TEST(CompareReports, AReportIsTheSameAsItself) {
  const ReadReport report = ReportOf(synthetic::Walked(2));
  const ReportComparison c = CompareReports(report, report, 0.0);
  EXPECT_TRUE(c.same());
  EXPECT_GT(c.metrics.size(), 20U);
  EXPECT_EQ(c.score_a, c.score_b);
}

TEST(CompareReports, MetricsBeyondTheToleranceAndVerdictsAreReported) {
  const synthetic::Played good = synthetic::Walked(2);
  synthetic::Played bad = good;
  synthetic::Sink(bad.log, 400, 0.1);
  const ReportComparison c = CompareReports(ReportOf(good), ReportOf(bad), 0.05);
  EXPECT_FALSE(c.same());
  EXPECT_EQ(c.words.at(0).key, "verdict");
  EXPECT_EQ(c.words.at(0).b, "fail");
  EXPECT_EQ(At(c, "fell").a, 0.0);
  EXPECT_EQ(At(c, "fell").b, 1.0);
  EXPECT_TRUE(At(c, "fell").differs);
  EXPECT_TRUE(At(c, "fell").pass_a);
  EXPECT_FALSE(At(c, "fell").pass_b);
  EXPECT_TRUE(synthetic::Says(ComparisonText(c), "B fails"));
  EXPECT_EQ(XmlFault(ComparisonPage(c)), "");
  EXPECT_EQ(nlohmann::json::parse(ComparisonJson(c)).at("metrics").at("fell").at("change"), 1.0);
}

TEST(CompareReports, ToleranceIsAShareOfTheLargerAndOfTheLimit) {
  ReadReport a, b;
  a.metrics = {
      {"x_m", "m", 1.0, std::nullopt, true}, {"y_m", "m", 0.001, 0.1, true}, {"z_m", "m", 1.0, std::nullopt, true}};
  b.metrics = {{"x_m", "m", 1.04, std::nullopt, true}, {"y_m", "m", 0.004, 0.1, true}};
  const ReportComparison c = CompareReports(a, b, 0.05);
  EXPECT_FALSE(At(c, "x_m").differs);
  EXPECT_FALSE(At(c, "y_m").differs) << "little beside its limit";
  EXPECT_TRUE(At(c, "z_m").differs) << "one has none";
  EXPECT_TRUE(At(CompareReports(a, b, 0.03), "x_m").differs);
}

TEST(CompareReports, WhatIsNoReportIsRefused) {
  const Result<ReadReport> cut = ReportFromJson("{\"verdict\": \"pass\"", "a.json");
  ASSERT_FALSE(cut);
  EXPECT_TRUE(synthetic::Says(cut.failure().message, "'a.json' is refused: its JSON is cut short"));
  const Result<ReadReport> wrong = ReportFromJson("{\"verdict\": 3, \"metrics\": {}}", "a.json");
  ASSERT_FALSE(wrong);
  EXPECT_TRUE(synthetic::Says(wrong.failure().message, "a part is missing or of the wrong kind"));
  const Result<ReadReport> deep = ReportFromJson(std::string(100, '[') + std::string(100, ']'), "a.json");
  ASSERT_FALSE(deep);
  EXPECT_TRUE(synthetic::Says(deep.failure().message, "nested more than"));
  const Result<ReadReport> nameless = ReportFromJson(
      R"({"robot": "a1", "verdict": "pass", "reason": "", "score": 1,
          "metrics": {"": {"value": 1, "unit": "", "limit": null, "pass": true}}})",
      "a.json");
  ASSERT_FALSE(nameless);
  EXPECT_TRUE(synthetic::Says(nameless.failure().message, "a metric has no name"));
}

TEST(MotionFileKinds, AreRecognisedByContentAlone) {
  EXPECT_EQ(KindOfText("{\"x\": {\"format\": \"no\"}, \"format\": \"gaitwright-motion-plan\", \"schema\": 99"),
            MotionFileKind::kPlan)
      << "what comes after is for its reader to judge";
  EXPECT_EQ(KindOfText(" {\"format\": \"gaitwright-playback-log\"}"), MotionFileKind::kLog);
  EXPECT_EQ(KindOfText("{\"verdict\": \"pass\", \"metrics\": {}}"), MotionFileKind::kReport);
  EXPECT_EQ(KindOfText("{\"verdict\": \"pass\", \"violations\": []}"), MotionFileKind::kJson);
  EXPECT_EQ(KindOfText("{\"format\": 3}"), MotionFileKind::kJson);
  EXPECT_EQ(KindOfText("time_s,q_hip_rad\n0,1\n"), MotionFileKind::kTable);
  EXPECT_EQ(KindOfText(""), MotionFileKind::kTable);
  EXPECT_EQ(KindOfText("{\"n\": 20, \"survived\": 19, \"survival\": 0.95, \"metrics\": {}}"), MotionFileKind::kTrials);
}

TEST(MotionFileKinds, AJointTrajectoryIsRecognisedInYamlAndJson) {
  for (const char* text : {"joint_names: [a]\npoints: []\n", "# a comment\nheader: {}\njoint_names:\n- a\n",
                           "trajectory:\n  joint_names: [a]\n", "{\"joint_names\": [\"a\"], \"poin",
                           "{\"trajectory\": {\"header\": null, \"joint_names\": []}}"})
    EXPECT_EQ(KindOfText(text), MotionFileKind::kTrajectory) << text;
  for (const char* text : {"time_s,joint_names:\n0,1\n", "my_joint_names: [a]\n"})
    EXPECT_EQ(KindOfText(text), MotionFileKind::kTable) << text;
  EXPECT_EQ(KindOfText("{\"other\": {\"joint_names\": []}}"), MotionFileKind::kJson);
  EXPECT_EQ(KindOfText("{\"robot\": {\"joint_names\": []}, \"format\": \"gaitwright-motion-plan\"}"),
            MotionFileKind::kPlan);
}

}  // namespace
}  // namespace gaitwright
