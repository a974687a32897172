// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/push_record.h"

#include <gtest/gtest.h>

#include <string>

namespace gaitwright {
namespace {

using Outcome = PushRecord::Outcome;

struct MadePush {
  double forward_n = 0.0, left_n = 0.0, at_s = 0.0;
  double up_n = 0.0;
};

/// A trial with pushes of 0.1 s that ended at a time.
TrialOutcome Trial(const std::vector<MadePush>& pushes, double ended_s, bool survived) {
  TrialOutcome trial;
  trial.survived = survived;
  trial.ended_s = ended_s;
  int number = 0;
  for (const MadePush& push : pushes) {
    const std::string name = "push" + std::to_string(++number) + ".";
    trial.sampled.push_back({name + "ahead_n", "N", push.forward_n, ""});
    trial.sampled.push_back({name + "left_n", "N", push.left_n, ""});
    if (push.up_n != 0.0) trial.sampled.push_back({name + "up_n", "N", push.up_n, ""});
    trial.sampled.push_back({name + "at_s", "s", push.at_s, ""});
    trial.sampled.push_back({name + "duration_s", "s", 0.1, ""});
  }
  return trial;
}

std::vector<Outcome> OutcomesOf(const TrialOutcome& trial) {
  std::vector<Outcome> outcomes;
  for (const PushRecord& push : PushesOf(trial)) outcomes.push_back(push.outcome);
  return outcomes;
}

using Outcomes = std::vector<Outcome>;

TEST(PushRecordTest, AFallSoonAfterIsFatalAndALateOneIsNot) {
  const std::vector<MadePush> one = {{50.0, 0.0, 1.0}};
  EXPECT_EQ(OutcomesOf(Trial(one, 1.05, false)), (Outcomes{Outcome::kFatal})) << "while it lasts";
  EXPECT_EQ(OutcomesOf(Trial(one, 3.09, false)), (Outcomes{Outcome::kFatal}));
  EXPECT_EQ(OutcomesOf(Trial(one, 3.2, false)), (Outcomes{Outcome::kRecovered})) << "it stood for over two seconds";
  EXPECT_TRUE(PushesOf(Trial(one, 0.9, false)).empty()) << "it fell before";
}

TEST(PushRecordTest, WhatWasNotWatchedIsNotRecovered) {
  const std::vector<MadePush> one = {{50.0, 0.0, 1.0}};
  EXPECT_EQ(OutcomesOf(Trial(one, 2.0, true)), (Outcomes{Outcome::kUnknown}));
  EXPECT_EQ(OutcomesOf(Trial(one, 2.11, true)), (Outcomes{Outcome::kRecovered}));
}

TEST(PushRecordTest, AFallIsLaidAtTheDoorOfTheLastPushAlone) {
  const std::vector<MadePush> far = {{10.0, 0.0, 1.0}, {50.0, 0.0, 4.0}}, near = {{10.0, 0.0, 3.5}, {50.0, 0.0, 4.0}};
  EXPECT_EQ(OutcomesOf(Trial(far, 4.5, false)), (Outcomes{Outcome::kRecovered, Outcome::kFatal}));
  EXPECT_EQ(OutcomesOf(Trial(near, 4.5, false)), (Outcomes{Outcome::kUnknown, Outcome::kFatal}));
  EXPECT_EQ(OutcomesOf(Trial({far[1], far[0]}, 4.5, false)), (Outcomes{Outcome::kRecovered, Outcome::kFatal}))
      << "by time, not by name";
  EXPECT_EQ(OutcomesOf(Trial({{10.0, 0.0, 1.0}, {0.0, 0.0, 1.5}}, 2.0, false)), (Outcomes{Outcome::kFatal}))
      << "one without force is none";
}

TEST(PushRecordTest, WhatComesAfterAPushThatWasNotSampledIsNotTheirs) {
  const TrialOutcome fell = Trial({{10.0, 0.0, 1.0}, {10.0, 0.0, 4.0}}, 4.9, false);
  const auto with = [&](double other_s) { return PushesOf(fell, other_s); };
  EXPECT_EQ(with(4.5)[1].outcome, Outcome::kUnknown) << "the other one came in between";
  EXPECT_EQ(with(0.5)[1].outcome, Outcome::kFatal);
  EXPECT_EQ(with(1.5)[0].outcome, Outcome::kUnknown);
  EXPECT_EQ(with(3.0)[0].outcome, Outcome::kRecovered);
  EXPECT_EQ(with(3.0)[1].outcome, Outcome::kFatal);
  EXPECT_EQ(with(6.0)[1].outcome, Outcome::kFatal) << "it never came";
}

TEST(PushRecordTest, ThePartUpwardCounts) {
  const std::vector<PushRecord> pushes = PushesOf(Trial({{30.0, 0.0, 1.0, 40.0}, {0.0, 0.0, 3.0, 20.0}}, 9.0, true));
  ASSERT_EQ(pushes.size(), 2U);
  EXPECT_DOUBLE_EQ(pushes[0].size_n(), 50.0);
  EXPECT_EQ(pushes[0].direction_deg(), 0.0);
  EXPECT_DOUBLE_EQ(pushes[1].size_n(), 20.0);
  EXPECT_FALSE(pushes[1].direction_deg().has_value());
  const std::vector<PushBin> bins = PushBins(pushes);
  ASSERT_EQ(bins.size(), 8U);
  EXPECT_EQ(bins[0].n, 1) << "one straight up has no direction";
  EXPECT_EQ(bins[0].largest_survived_n, 50.0);
}

TEST(PushRecordTest, BinsTellLargestAndSmallestOfWhatIsKnown) {
  std::vector<PushRecord> pushes;
  const auto add = [&](double left_n, Outcome outcome) {
    PushRecord push;
    push.left_n = left_n;
    push.outcome = outcome;
    pushes.push_back(push);
  };
  add(10.0, Outcome::kRecovered);
  add(20.0, Outcome::kRecovered);
  add(90.0, Outcome::kUnknown);
  add(40.0, Outcome::kFatal);
  add(30.0, Outcome::kFatal);
  add(-5.0, Outcome::kUnknown);
  const std::vector<PushBin> bins = PushBins(pushes);
  EXPECT_EQ(bins[2], (PushBin{90.0, 4, 2, 1, 20.0, 30.0}));
  EXPECT_EQ(bins[6], (PushBin{270.0, 0, 0, 1, {}, {}}));
  EXPECT_TRUE(PushBins({}).empty());
}

}  // namespace
}  // namespace gaitwright
