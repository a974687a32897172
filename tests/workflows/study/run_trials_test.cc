// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/run_trials.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "kinematics/base/file.h"
#include "playback/log/log_json.h"
#include "playback/score/reason.h"
#include "tests/workflows/study/pushed_standing.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

using RunTrialsTest = PushedStanding;

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
  for (const TrialOutcome& outcome : report.outcomes) {
    EXPECT_EQ(outcome.cause.empty(), outcome.passed) << outcome.reason;
    EXPECT_EQ(IsCauseOfFall(outcome.cause), !outcome.survived) << outcome.cause;
  }
  ASSERT_FALSE(report.worst.empty());
  const TrialOutcome& worst = report.Outcome(report.worst[0]);
  const PlayedTrial again = PlayTrial(Study(), worst.number, worst.seed).value();
  EXPECT_EQ(again.outcome, worst);
  EXPECT_TRUE(LogToJson(again.played.log) == LogToJson(PlayTrial(Study(), 99, worst.seed).value().played.log));
  EXPECT_EQ(SamplesHash(again.played.log), worst.log_hash);
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

TEST_F(RunTrialsTest, WhatIsDoneBeyondTheEndOfAResumedRunIsKept) {
  const std::string whole = JsonOf(Some(6));
  Interrupt(Some(6), 4);
  EXPECT_EQ(JsonOf(Some(2), {.journal = Journal(), .resume = true}), JsonOf(Some(2)));
  ASSERT_TRUE(fs::exists(Journal()));
  TrialOptions narrow = Some(6);
  narrow.until_width = 0.99;
  narrow.until_least = 1;
  TrialBook book = TrialBook::Open(Study(), narrow, {.journal = Journal(), .resume = true}).value();
  EXPECT_EQ(book.Report().value().n, 1) << "narrow enough";
  EXPECT_EQ(book.beyond(), 3);
  book.Close();
  { const TrialBook let_go = std::move(book); }
  int played = 0;
  TrialHooks hooks{.journal = Journal(), .resume = true};
  hooks.progress = [&](const TrialProgress&) { ++played; };
  EXPECT_EQ(JsonOf(Some(6), hooks), whole);
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
    EXPECT_EQ(report.failure().code, FailureCode::kSoFar);
    EXPECT_NE(report.failure().message.find(part), std::string::npos) << report.failure().message;
  };
  refused(Some(4), false, "an unfinished run");
  TrialOptions seeded = Some(4);
  seeded.seed = 5;
  refused(seeded, true, "another run");
  request_.play.hold_s = 0.1;
  refused(Some(4), true, "another run");
  request_.play.hold_s = PlayOptions().hold_s;
  disturbances_.figures[0].distribution = Distribution::Fixed(1.0);
  refused(Some(4), true, "another run");
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
    EXPECT_EQ(report.failure().code, FailureCode::kJournalLine);
    EXPECT_NE(report.failure().message.find("is damaged at trial"), std::string::npos) << report.failure().message;
  };
  expect_broken("\"survived\"", "\"surived\"");
  expect_broken("\"number\":", "\"number\":1");
}

TEST_F(RunTrialsTest, StopsEarlyWhereTheIntervalIsNarrowWhicheverThreadIsFast) {
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

TEST_F(RunTrialsTest, PhysicsThatBlowsUpIsAFallAndNotTheEndOfTheRun) {
  disturbances_.pushes.clear();  // the pushes made it fall before
  for (const double at_s : {0.0, 0.3}) {
    request_.play.more_pushes = {{Vector3(0.0, std::nan(""), 0.0), at_s, 0.1, "base"}};
    const auto report = RunTrials(Study(), Some(3, 2));
    ASSERT_TRUE(report.ok()) << report.failure().message;
    EXPECT_EQ(report->survived, 0);
    ASSERT_EQ(report->causes.size(), 1U);
    EXPECT_EQ(report->causes[0].what, "the simulation diverged");
    for (const TrialOutcome& outcome : report->outcomes) {
      EXPECT_NEAR(outcome.ended_s, at_s, 0.01);
      EXPECT_NE(outcome.reason.find("the physics gave a state that is not finite"), std::string::npos)
          << outcome.reason;
      EXPECT_EQ(OutcomeFromLine(OutcomeToLine(outcome)), outcome);
    }
  }
}

}  // namespace
}  // namespace gaitwright
