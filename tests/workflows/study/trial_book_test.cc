// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trial_book.h"

#include <set>

#include "tests/workflows/study/pushed_standing.h"

namespace gaitwright {
namespace {

using BookOfTrials = PushedStanding;

TEST_F(BookOfTrials, TheBookEndsInOrderWhateverArrivesFirst) {
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
  EXPECT_EQ(book.Report().failure().code, FailureCode::kInterrupted);
  book.Add(outcome(0));
  EXPECT_TRUE(book.complete());
  EXPECT_FALSE(book.Next().has_value());
  EXPECT_EQ(book.Report().value().n, 4);
}

TEST_F(BookOfTrials, TheBookCountsWhatItHas) {
  TrialOptions options = Some(10);
  options.until_width = 0.6;
  options.until_least = 4;
  TrialProgress last;
  TrialHooks hooks;
  hooks.progress = [&](const TrialProgress& p) { last = p; };
  TrialBook book = TrialBook::Open(Study(), options, hooks).value();
  const auto add = [&](int number, bool survived) {
    TrialOutcome o;
    o.number = number;
    o.survived = survived;
    book.Add(o);
  };
  for (const int i : {9, 5, 3, 2, 1}) add(i, i != 2);
  EXPECT_EQ(last.done, 5);
  EXPECT_EQ(last.survived, 4);
  EXPECT_EQ(last.wanted, 10);
  add(0, true);
  add(4, true);
  const int end = book.progress().wanted;
  EXPECT_LT(end, 10) << "narrow enough";
  EXPECT_EQ(book.progress().done, end);
  EXPECT_EQ(book.progress().survived, end - 1);
}

/// A synthetic outcome.
TrialOutcome MadeUpOutcome(int number, bool survived = true) {
  TrialOutcome outcome;
  outcome.number = number;
  outcome.survived = survived;
  return outcome;
}

TEST_F(BookOfTrials, EachNumberIsHandedOutOnceAndHasASeedOfItsOwn) {
  TrialBook book = TrialBook::Open(Study(), Some(20), {}).value();
  std::set<std::uint64_t> seeds;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(book.Next(), i);
    EXPECT_TRUE(seeds.insert(book.SeedOf(i)).second) << i;
    EXPECT_EQ(book.SeedOf(i), SeedOfTrial(0, i));
  }
  EXPECT_FALSE(book.Next().has_value());
}

TEST_F(BookOfTrials, ARunThatCannotBePlayedFailsWithItsLowestNumber) {
  TrialBook book = TrialBook::Open(Study(), Some(5), {}).value();
  const auto failure = [](const std::string& message) {
    return Failure{FailureKind::kBadInput, FailureCode::kDisturbances, "PlayTrial", message, {}};
  };
  book.Fail(3, failure("three"));
  EXPECT_FALSE(book.Next().has_value()) << "no more are handed out";
  book.Fail(1, failure("one"));
  book.Add(MadeUpOutcome(0));
  EXPECT_EQ(book.Report().failure().message, "one");
}

TEST_F(BookOfTrials, ARunThatIsStoppedHandsOutNoMoreAndSaysHowFarItIs) {
  bool stopped = false;
  TrialHooks hooks;
  hooks.stop = [&] { return stopped; };
  TrialBook book = TrialBook::Open(Study(), Some(5), hooks).value();
  EXPECT_EQ(book.Next(), 0);
  book.Add(MadeUpOutcome(0));
  stopped = true;
  EXPECT_FALSE(book.Next().has_value());
  const Result<RobustnessReport> report = book.Report();
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.failure().code, FailureCode::kInterrupted);
  EXPECT_NE(report.failure().message.find("1 of 5 trials; nothing is kept"), std::string::npos)
      << report.failure().message;
}

TEST_F(BookOfTrials, AnOutcomeThatComesTwiceCountsOnce) {
  TrialBook book = TrialBook::Open(Study(), Some(3), {}).value();
  book.Add(MadeUpOutcome(1));
  book.Add(MadeUpOutcome(1, false));
  EXPECT_EQ(book.progress().done, 1);
  EXPECT_EQ(book.progress().survived, 1) << "the first one stays";
  EXPECT_EQ(book.beyond(), 0);
}

TEST_F(BookOfTrials, OptionsOutOfRangeAreRefused) {
  TrialOptions wide = Some(3);
  wide.until_width = 1.5;
  EXPECT_THROW((void)TrialBook::Open(Study(), wide, {}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
