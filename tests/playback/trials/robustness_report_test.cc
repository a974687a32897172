// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/robustness_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"
#include "tests/playback/trials/made_outcomes.h"

namespace gaitwright {
namespace {

TEST(RobustnessReportTest, CountsAndRanks) {
  const RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(100, 25.0));
  int survived = 0, passed = 0;
  for (const TrialOutcome& outcome : report.outcomes) {
    survived += outcome.survived ? 1 : 0;
    passed += outcome.passed ? 1 : 0;
  }
  EXPECT_EQ(report.n, 100);
  EXPECT_EQ(report.survived, survived);
  EXPECT_EQ(report.passed, passed);
  EXPECT_LT(passed, survived);
  EXPECT_EQ(report.survival, WilsonInterval(survived, 100));
  ASSERT_EQ(report.causes.size(), 1U);
  EXPECT_EQ(report.causes[0], (Tally{"a foot slid", 100 - survived}));
  ASSERT_EQ(report.broken_gates.size(), 1U);
  EXPECT_EQ(report.broken_gates[0], (Tally{"goal_error_m", survived - passed}));
  ASSERT_FALSE(report.sensitivity.empty());
  EXPECT_EQ(report.sensitivity[0].name, "push1.left_n");
  EXPECT_EQ(report.sensitivity[0].how, "far off");
  ASSERT_EQ(report.worst.size(), 10U);
  for (const int number : report.worst) EXPECT_FALSE(report.Outcome(number).survived);
  EXPECT_LE(report.Outcome(report.worst[0]).score, report.Outcome(report.worst[9]).score);
}

TEST(RobustnessReportTest, TheWorstAreReportedEvenIfNoneFell) {
  const RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(20, 1e3));
  ASSERT_EQ(report.survived, 20);
  ASSERT_EQ(report.worst.size(), 10U);
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(report.Outcome(report.worst[static_cast<std::size_t>(i)]).passed, i >= 3) << "3 of 20 break a gate";
  EXPECT_LE(report.Outcome(report.worst[3]).score, report.Outcome(report.worst[9]).score);
  EXPECT_NE(RobustnessText(report).find("passed   5.00 s"), std::string::npos) << RobustnessText(report);
}

TEST(RobustnessReportTest, SpreadsAreThoseOfTheValues) {
  const RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(101, 25.0));
  ASSERT_EQ(report.metrics.size(), 2U);  // a metric that no trial has is omitted
  const MetricSpread& goal = report.metrics[1];
  EXPECT_EQ(goal.key, "goal_error_m");
  EXPECT_EQ(goal.n, 101);
  EXPECT_NEAR(goal.lowest, 0.0, 1e-12);
  EXPECT_NEAR(goal.p05, 0.005, 1e-12);
  EXPECT_NEAR(goal.median, 0.05, 1e-12);
  EXPECT_NEAR(goal.p95, 0.095, 1e-12);
  EXPECT_NEAR(goal.highest, 0.1, 1e-12);
  EXPECT_EQ(goal.limit, 0.05);
  EXPECT_EQ(goal.broken, report.broken_gates[0].count);
}

TEST(RobustnessReportTest, AGateThatNoTrialHadHasNoLimit) {
  std::vector<TrialOutcome> outcomes = made::Outcomes(21, 25.0);
  for (TrialOutcome& outcome : outcomes) std::erase(outcome.gates, "goal_error_m");
  EXPECT_EQ(ReduceTrials(made::Subject(), outcomes).metrics[1].limit, std::nullopt);
  outcomes[4].gates.push_back("goal_error_m");
  EXPECT_EQ(ReduceTrials(made::Subject(), outcomes).metrics[1].limit, 0.05);
}

TEST(RobustnessReportTest, PushesByDirection) {
  std::vector<TrialOutcome> outcomes = made::Outcomes(200, 25.0);
  const RobustnessReport report = ReduceTrials(made::Subject(), outcomes);
  ASSERT_EQ(report.push_bins.size(), 8U);
  EXPECT_EQ(report.push_bins[2].direction_deg, 90.0);  // to the left
  EXPECT_EQ(report.push_bins[0].fell, 0);              // forward, where the lateral part is small
  EXPECT_GT(report.push_bins[2].fell, 0);
  EXPECT_GT(*report.push_bins[2].smallest_fatal_n, 25.0);
  EXPECT_LT(*report.push_bins[2].largest_survived_n, 25.0 / std::cos(22.5 * 0.0174533) + 0.1);
  EXPECT_FALSE(report.push_bins[0].smallest_fatal_n.has_value());
  int pushes = 0;
  for (const PushBin& bin : report.push_bins) pushes += bin.n;
  EXPECT_EQ(pushes, 200);
  for (TrialOutcome& outcome : outcomes) outcome.ended_s = outcome.survived ? 5.0 : 1.0;  // before its push
  for (const PushBin& bin : ReduceTrials(made::Subject(), outcomes).push_bins) EXPECT_EQ(bin.fell, 0);
}

TEST(RobustnessReportTest, ASlopeThatFellsOnlyDownhillShows) {
  std::vector<TrialOutcome> outcomes;
  const Disturbances slopes = ReadDisturbances(
                                  "ground_slope_deg: {uniform: [0, 6]}\n"
                                  "ground_slope_direction_deg: {uniform: [0, 360]}\n",
                                  {}, "test")
                                  .value();
  for (int i = 0; i < 200; ++i) {
    const SampledTrial trial = SampleTrial(slopes, RobotModel(), MotionPlan(), SeedOfTrial(0, i));
    double slope_x_deg = 0.0;
    for (const SampledValue& one : trial.values)
      slope_x_deg = one.name == "ground_slope_x_deg" ? one.value : slope_x_deg;
    TrialOutcome o;
    o.number = i;
    o.sampled = trial.values;
    o.survived = slope_x_deg > -2.0;
    outcomes.push_back(o);
  }
  const RobustnessReport report = ReduceTrials(made::Subject(), outcomes);
  ASSERT_FALSE(report.sensitivity.empty());
  EXPECT_EQ(report.sensitivity[0].name, "ground_slope_x_deg");
  EXPECT_EQ(report.sensitivity[0].how, "less");
  EXPECT_EQ(report.sensitivity[0].effect, 1.0);
}

TEST(RobustnessReportTest, OutcomesMustBeInOrder) {
  std::vector<TrialOutcome> outcomes = made::Outcomes(3, 25.0);
  std::swap(outcomes[0], outcomes[1]);
  EXPECT_THROW(ReduceTrials(made::Subject(), outcomes), InvalidArgument);
  EXPECT_EQ(ReduceTrials(made::Subject(), {}).survival, (ShareInterval{0.0, 0.0, 1.0}));
}

/// Each step lands late by twice the push to the left, scaled.
std::vector<TrialOutcome> Stepping(int trials, const GaitScale& scale) {
  std::vector<TrialOutcome> outcomes = made::Outcomes(trials, 25.0);
  const double impulse = scale.mass_kg * std::sqrt(kGravity * scale.leg_length_m);
  for (TrialOutcome& outcome : outcomes) {
    NamedRandom random(outcome.seed, "steps");
    for (int n = 0; n < 20 && outcome.survived; ++n) {
      const double push = random.Normal();
      outcome.steps.push_back({0.0, 0.0, push, true, 2.0 * push / impulse * scale.step_s, 0.0, 0.0});
    }
  }
  return outcomes;
}

TEST(RobustnessReportTest, TheGaitSensitivityNormIsOfTheTrialsThatSurvived) {
  TrialSubject subject = made::Subject();
  subject.gait_scale = {.leg_length_m = 0.4, .mass_kg = 10.0, .step_s = 0.3};
  const RobustnessReport report = ReduceTrials(subject, Stepping(60, subject.gait_scale));
  ASSERT_TRUE(report.gait_sensitivity.norm) << report.gait_sensitivity.missing;
  EXPECT_NEAR(*report.gait_sensitivity.norm, 2.0, 1e-9);
  EXPECT_EQ(report.gait_sensitivity.trials, report.survived);
  const auto json = nlohmann::json::parse(RobustnessJson(report));
  EXPECT_NEAR(json.at("gait_sensitivity_norm").get<double>(), 2.0, 1e-9);
  const auto& details = json.at("gait_sensitivity");
  EXPECT_EQ(details.at("varied"), (nlohmann::json{false, false, true}));
  EXPECT_EQ(details.at("disturbances").at(2), "push_left");
  EXPECT_NEAR(details.at("response").at(0).at(0).at(2).get<double>(), 2.0, 1e-9) << details.at("indicators").at(0);
  EXPECT_NE(RobustnessText(report).find("gait sensitivity norm 2, standard error"), std::string::npos);
  const RobustnessReport none = ReduceTrials(subject, made::Outcomes(60, 25.0));
  EXPECT_TRUE(nlohmann::json::parse(RobustnessJson(none)).at("gait_sensitivity_norm").is_null());
  EXPECT_NE(RobustnessText(none).find("gait sensitivity norm: not available, the plan has no consecutive steps"),
            std::string::npos);
}

TEST(TrialOutcomeTest, ALineReadsBackTheSame) {
  for (TrialOutcome outcome : made::Outcomes(20, 25.0)) {
    outcome.steps = {{0.001, 2.5, -1.0, true, 0.012, 1.0 / 3.0, -0.002}, {0.0, 0.1, 0.0, false, 0.0, 0.0, 0.0}};
    const std::string line = OutcomeToLine(outcome);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(OutcomeFromLine(line), outcome);
  }
  EXPECT_THROW(OutcomeFromLine("{}"), InvalidArgument);
  EXPECT_THROW(OutcomeFromLine("{\"number\":"), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
