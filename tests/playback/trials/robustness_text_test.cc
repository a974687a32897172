// SPDX-License-Identifier: BSD-3-Clause
// A report of trials as JSON and as text.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "playback/trials/robustness_report.h"
#include "tests/playback/trials/made_outcomes.h"

namespace gaitwright {
namespace {

TEST(RobustnessTextTest, TrialsThatRepeatOthersAreSaidTo) {
  std::vector<TrialOutcome> outcomes = made::Outcomes(20, 25.0);
  const RobustnessReport all = ReduceTrials(made::Subject(), outcomes);
  EXPECT_EQ(all.different, 20);
  EXPECT_EQ(RepeatsText(all), "");
  EXPECT_EQ(nlohmann::json::parse(RobustnessJson(all)).at("remarks"), nlohmann::json::array());
  outcomes[7].log_hash = outcomes[3].log_hash;
  EXPECT_EQ(RepeatsText(ReduceTrials(made::Subject(), outcomes)).find("only 19 of 20 trials are different playbacks"),
            0U);
  for (TrialOutcome& outcome : outcomes) outcome.log_hash = "same";
  const RobustnessReport one = ReduceTrials(made::Subject(), outcomes);
  EXPECT_EQ(one.different, 1);
  const std::string remark = "all 20 trials are identical";
  EXPECT_NE(RobustnessText(one).find("note: " + remark), std::string::npos);
  const auto json = nlohmann::json::parse(RobustnessJson(one));
  EXPECT_EQ(json.at("different"), 1);
  EXPECT_EQ(json.at("remarks").at(0).get<std::string>().find(remark), 0U);
}

TEST(RobustnessTextTest, WordsNameWhatMatters) {
  const std::string text = RobustnessText(ReduceTrials(made::Subject(), made::Outcomes(100, 25.0)));
  for (const char* part :
       {"survived  ", "95 % interval", "a foot slid", "push1.left_n", "90 deg", "seed ", "goal_error_m"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(RobustnessTextTest, WhereEveryTrialFellNothingIsRankedAndThatIsSaid) {
  const RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(20, 0.0));
  ASSERT_EQ(report.survived, 0);
  EXPECT_NE(RobustnessText(report).find("correlates of falling: not available, because every trial fell"),
            std::string::npos);
}

TEST(RobustnessTextTest, JsonHasTheStablePart) {
  const RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(60, 25.0));
  const std::string text = RobustnessJson(report);
  EXPECT_EQ(text, RobustnessJson(ReduceTrials(made::Subject(), made::Outcomes(60, 25.0))));
  const auto json = nlohmann::json::parse(text);
  for (const char* key : {"n", "survived", "survival", "survival_low", "survival_high", "metrics", "causes", "worst",
                          "sensitivity", "pushes", "robot_hash", "plan_hash", "disturbances", "options"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json.at("n"), 60);
  EXPECT_EQ(json.at("worst").at(0).at("seed"), report.Outcome(report.worst[0]).seed);
  EXPECT_EQ(json.at("trials").at("rows").size(), 60U);
  for (const auto& row : json.at("trials").at("rows")) EXPECT_EQ(row.size(), json.at("trials").at("columns").size());
  EXPECT_EQ(json.at("causes").at("a foot slid"), 60 - report.survived);
  EXPECT_EQ(json.at("metrics").at("goal_error_m").at("limit"), 0.05);
}

RobustnessReport ReportWithTwoBins() {
  RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(20, 25.0));
  report.push_bins = {{}, {}};
  report.push_bins[0].direction_deg = 0.0;
  report.push_bins[0].n = 4;
  report.push_bins[0].largest_survived_n = 12.5;
  report.push_bins[1].direction_deg = 180.0;
  report.push_bins[1].n = 3;
  report.push_bins[1].fell = 2;
  report.push_bins[1].unknown = 5;
  report.push_bins[1].smallest_fatal_n = 30.0;
  return report;
}

TEST(RobustnessTextTest, ADirectionWithoutAFallHasNoFatalSize) {
  const RobustnessReport report = ReportWithTwoBins();
  const auto pushes = nlohmann::json::parse(RobustnessJson(report)).at("pushes");
  EXPECT_EQ(pushes.at(0).at("largest_survived_n"), 12.5);
  EXPECT_TRUE(pushes.at(0).at("smallest_fatal_n").is_null());
  EXPECT_TRUE(pushes.at(1).at("largest_survived_n").is_null());
  EXPECT_EQ(pushes.at(1).at("unknown"), 5);
  const std::string text = RobustnessText(report);
  EXPECT_NE(text.find("    0 deg     4 pushes,   0 fell; largest survived   12.5 N, smallest fatal        -\n"),
            std::string::npos)
      << text;
  EXPECT_NE(
      text.find(
          "  180 deg     3 pushes,   2 fell; largest survived        -, smallest fatal   30.0 N; 5 more undecided\n"),
      std::string::npos)
      << text;
}

// Each row of the table has one value per column, and the rows are the outcomes.
TEST(RobustnessTextTest, TheTableOfTrialsIsTheOutcomes) {
  const RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(30, 25.0));
  const auto trials = nlohmann::json::parse(RobustnessJson(report)).at("trials");
  const auto columns = trials.at("columns").get<std::vector<std::string>>();
  ASSERT_EQ(trials.at("rows").size(), report.outcomes.size());
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) - columns.begin());
  };
  for (std::size_t i = 0; i < report.outcomes.size(); ++i) {
    const auto& row = trials.at("rows").at(i);
    const TrialOutcome& outcome = report.outcomes[i];
    ASSERT_EQ(row.size(), columns.size());
    EXPECT_EQ(row.at(column("seed")).get<std::uint64_t>(), outcome.seed);
    EXPECT_EQ(row.at(column("survived")).get<bool>(), outcome.survived);
    EXPECT_EQ(row.at(column("score")).get<double>(), outcome.score);
    EXPECT_EQ(row.at(column("mass_scale")).get<double>(), outcome.sampled[0].value);
    EXPECT_EQ(row.at(column("push1.place")).get<std::string>(), outcome.sampled.back().word);
  }
}

TEST(RobustnessTextTest, SharesAreInPercentWithTheirInterval) {
  RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(20, 25.0));
  report.n = 20;
  report.survived = 15;
  report.survival = {0.75, 0.531, 0.888};
  const std::string text = RobustnessText(report);
  EXPECT_EQ(text.find("survived  15 of 20: 75.0 %, 95 % interval 53.1 % to 88.8 %\n"), 0U) << text;
}

TEST(RobustnessTextTest, AtMostEightCorrelatesAreReported) {
  RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(100, 25.0));
  Sensitivity one = report.sensitivity.at(0);
  report.sensitivity.clear();
  for (int i = 0; i < 9; ++i) {
    one.name = "figure" + std::to_string(i);
    report.sensitivity.push_back(one);
  }
  const std::string text = RobustnessText(report);
  EXPECT_NE(text.find("figure7"), std::string::npos);
  EXPECT_EQ(text.find("figure8"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(RobustnessJson(report)).at("sensitivity").size(), 9U) << "JSON has all of them";
}

}  // namespace
}  // namespace gaitwright
