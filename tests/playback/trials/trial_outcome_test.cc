// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/trial_outcome.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "kinematics/base/result.h"
#include "tests/playback/played.h"
#include "tests/playback/trials/made_outcomes.h"

namespace gaitwright {
namespace {

Metric MadeMetric(const std::string& key, std::optional<double> value, bool applied, bool pass) {
  Metric metric;
  metric.key = key;
  metric.value = value;
  metric.applied = applied;
  metric.pass = pass;
  return metric;
}

/// The report of a playback that fell, or did not, `after_s` its start.
StabilityReport MadeReport(std::optional<double> fell, std::optional<double> after_s) {
  StabilityReport report;
  report.pass = fell == 0.0;
  report.score = 71.5;
  report.cause = "a foot slid";
  report.reason = "it slid";
  report.metrics = {MadeMetric("fell", fell, true, fell == 0.0), MadeMetric("time_to_fall_s", after_s, false, true),
                    MadeMetric("goal_error_m", 0.25, true, true), MadeMetric("slip_max_step_m", {}, false, true)};
  return report;
}

PlaybackLog LogFrom(double start_s) {
  PlaybackLog log = synthetic::Stood().log;
  log.start_s = start_s;
  for (LogSample& sample : log.samples) sample.time_s += start_s;
  return log;
}

TEST(TrialOutcome, TakesOverWhatTheReportSays) {
  SampledTrial trial;
  trial.seed = 77;
  trial.values = {{"mass_scale", "1", 1.1, ""}};
  const TrialOutcome o = OutcomeOf(3, trial, LogFrom(0.0), MadeReport(1.0, 0.7));
  EXPECT_EQ(o.number, 3);
  EXPECT_EQ(o.seed, 77U);
  EXPECT_EQ(o.score, 71.5);
  EXPECT_EQ(o.cause, "a foot slid");
  EXPECT_EQ(o.reason, "it slid");
  EXPECT_EQ(o.sampled, trial.values);
  ASSERT_EQ(o.metrics.size(), 4U);
  EXPECT_EQ(o.metrics[2].first, "goal_error_m");
  EXPECT_EQ(o.metrics[2].second, 0.25);
  EXPECT_FALSE(o.metrics[3].second.has_value());
  EXPECT_EQ(o.gates, (std::vector<std::string>{"fell", "goal_error_m"}));
  EXPECT_EQ(o.broken_gates, std::vector<std::string>{"fell"});
  EXPECT_TRUE(o.steps.empty());
}

TEST(TrialOutcome, EndsWithTheFallOnThePlansClockOrWithTheLog) {
  const PlaybackLog log = LogFrom(2.0);  // it lasts a second
  const TrialOutcome fell = OutcomeOf(0, {}, log, MadeReport(1.0, 0.7));
  EXPECT_FALSE(fell.survived);
  EXPECT_DOUBLE_EQ(fell.ended_s, 2.7);
  const TrialOutcome stood = OutcomeOf(0, {}, log, MadeReport(0.0, {}));
  EXPECT_TRUE(stood.survived);
  EXPECT_DOUBLE_EQ(stood.ended_s, 3.0);
  PlaybackLog empty = log;
  empty.samples.clear();
  EXPECT_DOUBLE_EQ(OutcomeOf(0, {}, empty, MadeReport(0.0, {})).ended_s, 2.0);
}

TEST(TrialOutcome, WithoutAnAnswerWhetherItFellItDidNotSurvive) {
  EXPECT_FALSE(OutcomeOf(0, {}, LogFrom(0.0), MadeReport({}, {})).survived);
}

TEST(TrialOutcome, TheHashIsOfAllThatTheSamplesMeasuredAndOfNothingElse) {
  const PlaybackLog log = LogFrom(0.0);
  const std::vector<std::function<void(PlaybackLog&)>> changes = {
      [](PlaybackLog&) {},
      [](PlaybackLog& l) { l.samples[3].time_s += 1e-12; },
      [](PlaybackLog& l) { l.samples[3].q[12] += 1e-12; },
      [](PlaybackLog& l) { l.samples[3].v[0] += 1e-12; },
      [](PlaybackLog& l) { l.samples[3].tau[5] += 1e-12; },
      [](PlaybackLog& l) { l.samples[3].wrenches[1].force_W.z() += 1e-9; },
      [](PlaybackLog& l) { l.samples[3].wrenches[1].moment_W.x() += 1e-12; },
      [](PlaybackLog& l) { l.samples.pop_back(); },
      [](PlaybackLog& l) { std::swap(l.samples[3].wrenches, l.samples[0].wrenches), l.samples[0].q[0] += 1e-12; }};
  std::set<std::string> hashes;
  for (const auto& change : changes) {
    PlaybackLog changed = log;
    change(changed);
    hashes.insert(SamplesHash(changed));
  }
  EXPECT_EQ(hashes.size(), changes.size());
  PlaybackLog other = log;
  other.controller = other.program_version = "another";
  other.stances.clear();
  other.options = {{"play.step_s", "1"}};
  EXPECT_EQ(SamplesHash(other), SamplesHash(log));
}

TEST(TrialOutcome, ALineKeepsTheLargestSeedAndAnyText) {
  TrialOutcome outcome = made::Outcomes(1, 25.0).front();
  outcome.seed = std::numeric_limits<std::uint64_t>::max();
  outcome.score = 1.0 / 3.0 * 100.0;
  outcome.reason = "two\nlines, \"quotes\" and \\";
  const std::string line = OutcomeToLine(outcome);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(OutcomeFromLine(line), outcome);
  outcome.reason = "bad \xff byte";  // for example in a link's name
  EXPECT_EQ(OutcomeFromLine(OutcomeToLine(outcome)).reason, "bad \xef\xbf\xbd byte");
}

struct BadPart {
  const char *key, *value;
};

void PrintTo(const BadPart& bad, std::ostream* out) { *out << bad.key << ": " << bad.value; }

class TrialOutcomeLine : public testing::TestWithParam<BadPart> {};

TEST_P(TrialOutcomeLine, IsRefusedWithAPartThatNoTrialHas) {
  auto line = nlohmann::ordered_json::parse(OutcomeToLine(made::Outcomes(1, 25.0).front()));
  ASSERT_NO_THROW(OutcomeFromLine(line.dump()));
  line[GetParam().key] = nlohmann::ordered_json::parse(GetParam().value);
  EXPECT_THROW(OutcomeFromLine(line.dump()), InvalidArgument) << line.dump();
  line.erase(GetParam().key);
  EXPECT_THROW(OutcomeFromLine(line.dump()), InvalidArgument) << "without " << GetParam().key;
}

INSTANTIATE_TEST_SUITE_P(
    Parts, TrialOutcomeLine,
    testing::Values(BadPart{"number", "-1"}, BadPart{"number", "1e9"}, BadPart{"number", "1.5"},
                    BadPart{"number", "\"1\""}, BadPart{"seed", "-1"}, BadPart{"seed", "0.5"}, BadPart{"survived", "1"},
                    BadPart{"passed", "null"}, BadPart{"score", "100.5"}, BadPart{"score", "-0.5"},
                    BadPart{"ended_s", "1e8"}, BadPart{"cause", "3"}, BadPart{"reason", "null"},
                    BadPart{"log_hash", "[]"}, BadPart{"sampled", "[[\"mass\", \"1\"]]"},
                    BadPart{"sampled", "[[\"mass\", \"1\", 1e31]]"}, BadPart{"sampled", "[[\"mass\", \"1\", null]]"},
                    BadPart{"metrics", "[[\"fell\"]]"}, BadPart{"metrics", "[[\"fell\", -1e31]]"},
                    BadPart{"gates", "[1]"}, BadPart{"broken_gates", "\"fell\""}, BadPart{"steps", "[[0, 0]]"},
                    BadPart{"steps", "[[0, 0, 0, 0]]"}, BadPart{"steps", "[[0, 0, 1e31]]"}));

TEST(TrialOutcome, APassThatDidNotSurviveIsRefused) {
  TrialOutcome outcome = made::Outcomes(2, 25.0).back();
  outcome.survived = false;
  for (const bool passed : {false, true}) {
    outcome.passed = passed;
    const std::string line = OutcomeToLine(outcome);
    if (passed) {
      EXPECT_THROW(OutcomeFromLine(line), InvalidArgument);
    } else {
      EXPECT_EQ(OutcomeFromLine(line), outcome);
    }
  }
}

}  // namespace
}  // namespace gaitwright
