// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "workflows/compare/comparison_text.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json ParsedComparison(const MotionComparison& c, const std::vector<MetricPair>& metrics = {}) {
  return Json::parse(ComparisonJson(c, metrics));
}

TEST(ComparisonJsons, EqualMotionsHaveNoFirstDifference) {
  MotionComparison c;
  EXPECT_EQ(ParsedComparison(c).at("same"), true);
  EXPECT_TRUE(ParsedComparison(c).at("first_difference").is_null());
  c.in_order = {{"x of the base", "m", 0.5, 1.0, 2.0, 0.1}, {"y of the base", "m", 0.75, 1.0, 3.0, 0.1}};
  const Json json = ParsedComparison(c);
  EXPECT_EQ(json.at("same"), false);
  EXPECT_EQ(json.at("in_order").size(), 2U);
  EXPECT_EQ(json.at("first_difference"), json.at("in_order")[0]);
  EXPECT_EQ(json.at("first_difference").at("quantity"), "x of the base");
  EXPECT_EQ(json.at("first_difference").at("b"), 2.0);
}

TEST(ComparisonJsons, WhatASideHasNotIsNull) {
  MotionComparison c;
  c.joints = {{"knee", {.quantity = "position", .unit = "rad", .samples = 3, .rms = 0.25}, {}, {}}};
  c.figures = {{"slip_max_m", "m", std::nullopt, 0.5}};
  const Json json = ParsedComparison(c, {{"score", "1", 80.0, std::nullopt, std::nullopt, true, true, true}});
  EXPECT_EQ(json.at("joints").at("knee").at("position").at("rms"), 0.25);
  EXPECT_TRUE(json.at("joints").at("knee").at("position").at("first_beyond_s").is_null());
  EXPECT_TRUE(json.at("joints").at("knee").at("torque").is_null()) << "no samples";
  EXPECT_TRUE(json.at("figures").at("slip_max_m").at("a").is_null());
  EXPECT_EQ(json.at("figures").at("slip_max_m").at("b"), 0.5);
  EXPECT_TRUE(json.at("metrics").at("score").at("change").is_null());
  EXPECT_TRUE(json.at("alignment").at("best_offset_s").is_null());
}

TEST(ComparisonJsons, TheChangeOfAMetricIsBMinusA) {
  const MetricPair metric{"slip_m", "m", 0.5, 0.75, 1.0, true, false, true};
  const Json of_metric = ParsedComparison({}, {metric}).at("metrics").at("slip_m");
  EXPECT_EQ(of_metric.at("change"), 0.25);
  EXPECT_EQ(of_metric.at("pass_a"), true);
  EXPECT_EQ(of_metric.at("pass_b"), false);
  ReportComparison reports;
  reports.metrics = {metric};
  EXPECT_EQ(Json::parse(ComparisonJson(reports)).at("metrics").at("slip_m"), of_metric) << "the same of reports";
}

TEST(ComparisonJsons, AlignmentHasTheOffsetThatWasUsedAndTheBestOne) {
  MotionComparison c;
  c.aligned_by = "start";
  c.offset_s = 1.5;
  c.best_offset = ClockOffset{1.25, 0.5};
  const Json alignment = ParsedComparison(c).at("alignment");
  EXPECT_EQ(alignment.at("by"), "start");
  EXPECT_EQ(alignment.at("offset_s"), 1.5);
  EXPECT_EQ(alignment.at("best_offset_s"), 1.25);
  EXPECT_EQ(alignment.at("agreement"), 0.5);
}

TEST(ComparisonJsons, NamesThatAreNoTextAreReplaced) {
  MotionComparison c;
  c.name_a = "a\xFF.json";
  EXPECT_EQ(ParsedComparison(c).at("a").at("name"), "a\xEF\xBF\xBD.json");
  ReportComparison reports;
  reports.name_b = "b\xFF.json";
  reports.score_b = 12.5;
  const Json json = Json::parse(ComparisonJson(reports));
  EXPECT_EQ(json.at("compared"), "reports");
  EXPECT_EQ(json.at("b").at("name"), "b\xEF\xBF\xBD.json");
  EXPECT_EQ(json.at("b").at("score"), 12.5);
}

}  // namespace
}  // namespace gaitwright
