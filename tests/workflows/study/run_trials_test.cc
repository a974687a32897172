// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/run_trials.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "kinematics/base/file.h"
#include "playback/log/log_json.h"
#include "tests/playback/standing_plan.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

/// A robot that stands and is pushed, sometimes over.
class RunTrialsTest : public testing::Test {
 protected:
  RunTrialsTest() {
    request_.play.world.solver_iterations = 20;
    request_.controller = "joint-pd";
    disturbances_ = ReadDisturbances(
                        "mass_scale: {uniform: [0.8, 1.2]}\nground_bumps_m: {uniform: [0, 0.005]}\n"
                        "start: {roll_rad: {uniform: [-0.05, 0.05]}}\n"
                        "pushes:\n  - {size_n: {uniform: [0, 900]}, at_s: 0.1, duration_s: 0.1}\n",
                        {}, "test")
                        .value();
    folder_ = ScratchFolder() / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_);
  }
  ~RunTrialsTest() override { fs::remove_all(folder_); }

  TrialStudy Study() const { return {model_, plan_, request_, disturbances_}; }
  TrialOptions Some(int n, int threads = 1) const {
    TrialOptions options;
    options.trials = n;
    options.threads = threads;
    return options;
  }
  std::string Journal() const { return (folder_ / "run.so-far").string(); }
  std::string JsonOf(const TrialOptions& options, const TrialHooks& hooks = {}) const {
    const auto report = RunTrials(Study(), options, hooks);
    EXPECT_TRUE(report.ok()) << report.failure().message;
    return report.ok() ? RobustnessJson(*report) : "";
  }
  /// Runs until `count` more trials are in the journal.
  void Interrupt(const TrialOptions& options, int count, bool resume = false) const {
    int left = count;
    TrialHooks hooks{.journal = Journal(), .resume = resume};
    hooks.progress = [&](const TrialProgress&) { --left; };
    hooks.stop = [&] { return left <= 0; };
    const auto report = RunTrials(Study(), options, hooks);
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.failure().code, "interrupted");
    EXPECT_NE(report.failure().hints.at(0).find("--resume"), std::string::npos);
  }

  const RobotModel model_ = standing::Load("a1");
  const MotionPlan plan_ = standing::Plan(model_, 0.6);
  PlayRequest request_;
  Disturbances disturbances_;
  fs::path folder_;
};

TEST_F(RunTrialsTest, ThreadsChangeNothing) {
  const std::string one = JsonOf(Some(8, 1));
  EXPECT_EQ(JsonOf(Some(8, 3)), one);
  TrialOptions other = Some(8, 1);
  other.seed = 1;
  EXPECT_NE(JsonOf(other), one);
}

TEST_F(RunTrialsTest, SomeFallAndSomeStand) {
  const RobustnessReport report = RunTrials(Study(), Some(12)).value();
  EXPECT_GT(report.survived, 0);
  EXPECT_LT(report.survived, 12);
  EXPECT_FALSE(report.causes.empty());
  EXPECT_EQ(report.subject.plan_hash, MotionHash(plan_));
  for (const TrialOutcome& outcome : report.outcomes)
    EXPECT_EQ(outcome.cause.empty(), outcome.passed) << outcome.reason;
  ASSERT_FALSE(report.worst.empty());
  const TrialOutcome& worst = report.Outcome(report.worst[0]);
  const PlayedTrial again = PlayTrial(Study(), worst.number, worst.seed).value();
  EXPECT_EQ(again.outcome, worst);
  EXPECT_TRUE(LogToJson(again.played.log) == LogToJson(PlayTrial(Study(), 99, worst.seed).value().played.log));
  EXPECT_EQ(SamplesHash(again.played.log), worst.log_hash);
}

TEST_F(RunTrialsTest, WhatIsSampledReachesThePlayback) {
  const PlayedTrial trial = PlayTrial(Study(), 0, 7).value();
  for (const SampledValue& one : trial.outcome.sampled) {
    const auto said = std::find_if(trial.played.log.options.begin(), trial.played.log.options.end(),
                                   [&](const auto& option) { return option.first == "trial." + one.name; });
    ASSERT_NE(said, trial.played.log.options.end()) << one.name;
    if (one.name == "mass_scale") {
      EXPECT_NEAR(trial.played.log.total_mass_kg, one.value * model_.total_mass_kg, 1e-9);
    }
  }
}

TEST_F(RunTrialsTest, AnInterruptedRunIsResumedToTheSameBytes) {
  const std::string whole = JsonOf(Some(7));
  Interrupt(Some(7), 2);
  Interrupt(Some(7), 3, true);
  ASSERT_TRUE(fs::exists(Journal()));
  int played = 0;
  TrialHooks hooks{.journal = Journal(), .resume = true};
  hooks.progress = [&](const TrialProgress&) { ++played; };
  EXPECT_EQ(JsonOf(Some(7, 2), hooks), whole);
  EXPECT_EQ(played, 2);
  EXPECT_FALSE(fs::exists(Journal()));
}

TEST_F(RunTrialsTest, ATornLastLineIsDropped) {
  const std::string whole = JsonOf(Some(4));
  Interrupt(Some(4), 3);
  const std::string text = ReadFile(Journal()).value();
  for (const std::size_t cut : {std::size_t{1}, std::size_t{40}, text.size() - 5}) {
    std::ofstream(Journal(), std::ios::binary | std::ios::trunc) << text.substr(0, text.size() - cut);
    EXPECT_EQ(JsonOf(Some(4), {.journal = Journal(), .resume = true}), whole) << cut;
  }
}

TEST_F(RunTrialsTest, AJournalOfAnotherRunIsRefused) {
  Interrupt(Some(4), 2);
  const auto refused = [&](const TrialOptions& options, bool resume, const std::string& part) {
    const auto report = RunTrials(Study(), options, {.journal = Journal(), .resume = resume});
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.failure().code, "so_far");
    EXPECT_NE(report.failure().message.find(part), std::string::npos) << report.failure().message;
  };
  refused(Some(4), false, "not finished");
  TrialOptions seeded = Some(4);
  seeded.seed = 5;
  refused(seeded, true, "other work");
  request_.play.hold_s = 0.1;
  refused(Some(4), true, "other work");
  request_.play.hold_s = PlayOptions().hold_s;
  disturbances_.figures[0].distribution = Distribution::Fixed(1.0);
  refused(Some(4), true, "other work");
}

TEST_F(RunTrialsTest, ABrokenOutcomeInTheJournalIsRefused) {
  Interrupt(Some(4), 2);
  const std::string text = ReadFile(Journal()).value();
  const auto expect_broken = [&](const std::string& part, const std::string& by) {
    std::string broken = text;
    broken.replace(broken.find(part), part.size(), by);
    std::ofstream(Journal(), std::ios::binary | std::ios::trunc) << broken;
    const auto report = RunTrials(Study(), Some(4), {.journal = Journal(), .resume = true});
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.failure().code, "journal_line");
    EXPECT_NE(report.failure().message.find("is broken at trial"), std::string::npos) << report.failure().message;
  };
  expect_broken("\"survived\"", "\"surived\"");
  expect_broken("\"number\":", "\"number\":1");
}

TEST_F(RunTrialsTest, StopsEarlyWhereTheIntervalIsNarrowWhoeverIsQuick) {
  disturbances_.pushes.clear();  // nobody falls
  TrialOptions options = Some(40, 1);
  options.until_width = 0.5;
  options.until_least = 3;
  const RobustnessReport report = RunTrials(Study(), options).value();
  EXPECT_EQ(report.survived, report.n);
  EXPECT_LT(report.survival.width(), 0.5);
  EXPECT_GE(WilsonInterval(report.n - 1, report.n - 1).width(), 0.5);
  options.threads = 3;
  EXPECT_EQ(RobustnessJson(RunTrials(Study(), options).value()), RobustnessJson(report));
  options.until_least = report.n + 2;
  EXPECT_EQ(RunTrials(Study(), options).value().n, report.n + 2);
}

TEST_F(RunTrialsTest, TheBookEndsInOrderWhateverArrivesFirst) {
  TrialOptions options = Some(10);
  options.until_width = 0.6;
  options.until_least = 4;
  TrialBook book = TrialBook::Open(Study(), options, {}).value();
  const auto outcome = [](int number) {
    TrialOutcome o;
    o.number = number;
    o.survived = true;
    return o;
  };
  for (int i = 0; i < 8; ++i) EXPECT_EQ(book.Next(), i);
  for (const int i : {7, 6, 5, 3, 2, 1}) book.Add(outcome(i));
  EXPECT_FALSE(book.complete());
  EXPECT_EQ(book.Report().failure().code, "interrupted");
  book.Add(outcome(0));
  EXPECT_TRUE(book.complete());
  EXPECT_FALSE(book.Next().has_value());
  EXPECT_EQ(book.Report().value().n, 4);
}

TEST_F(RunTrialsTest, ATrialThatCannotBePlayedFailsTheRun) {
  disturbances_.pushes[0][1].distribution = Distribution::Fixed(5.0);  // after the end
  const auto report = RunTrials(Study(), Some(4, 2));
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.failure().code, "late_push");
  disturbances_.pushes[0] = {{"size_n", Distribution::Fixed(1.0)},
                             {"place", Distribution::OneOf(std::vector<std::string>{"nowhere"})}};
  EXPECT_THROW((void)RunTrials(Study(), Some(4, 2)), InvalidArgument);
  TrialOptions none = Some(0);
  EXPECT_THROW((void)RunTrials(Study(), none), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
