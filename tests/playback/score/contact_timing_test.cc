// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/contact_timing.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gaitwright {
namespace {

/// One foot: stands until 1 s, swings until 1.4 s, stands until 2 s.
ContactSchedule OneSwing() {
  ContactSchedule schedule;
  schedule.phases = {{0.0, 1.0, 3}, {1.0, 1.4, 2}, {1.4, 2.0, 3}};
  return schedule;
}

StanceRecord Stance(double touchdown_s, double liftoff_s) {
  StanceRecord stance;
  stance.touchdown_s = touchdown_s;
  stance.liftoff_s = liftoff_s;
  return stance;
}

PlaybackLog LogOf(std::vector<StanceRecord> stances) {
  PlaybackLog log;
  log.stances = std::move(stances);
  log.stances.push_back(Stance(0.0, 2.0));
  log.stances.back().foot = 1;
  return log;
}

double Largest(const std::vector<TimingError>& errors) {
  double largest = 0.0;
  for (const TimingError& error : errors) largest = std::max(largest, std::abs(error.error_s));
  return largest;
}

TEST(ContactTiming, AsScheduledIsZeroAndLateIsPositive) {
  EXPECT_EQ(Largest(TimingErrors(OneSwing(), LogOf({Stance(0.0, 1.0), Stance(1.4, 2.0)}), 2, 2.0)), 0.0);
  const auto errors = TimingErrors(OneSwing(), LogOf({Stance(0.0, 1.01), Stance(1.37, 2.0)}), 2, 2.0);
  ASSERT_EQ(errors.size(), 2u) << "the start and the end of the motion do not count";
  EXPECT_NEAR(errors[0].error_s, 0.01, 1e-12);
  EXPECT_FALSE(errors[0].touchdown);
  EXPECT_NEAR(errors[1].error_s, -0.03, 1e-12);
  EXPECT_TRUE(errors[1].touchdown);
}

TEST(ContactTiming, ABounceIsOneStance) {
  const PlaybackLog log = LogOf({Stance(0.0, 1.0), Stance(1.4, 1.41), Stance(1.43, 2.0)});
  EXPECT_EQ(MeasuredIntervals(log, 0, TimingGate()).size(), 2u);
  EXPECT_EQ(Largest(TimingErrors(OneSwing(), log, 2, 2.0)), 0.0);
}

TEST(ContactTiming, AStanceThatNeverCameIsMissed) {
  const auto errors = TimingErrors(OneSwing(), LogOf({Stance(0.0, 1.0)}), 2, 2.0);
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_TRUE(errors[1].missed);
  EXPECT_NEAR(errors[1].error_s, 0.6, 1e-12);
}

TEST(ContactTiming, WhatComesAfterTheFallDoesNotCount) {
  EXPECT_TRUE(TimingErrors(OneSwing(), LogOf({Stance(0.0, 0.9)}), 2, 0.9).empty());
}

TEST(ContactTiming, OnlyContactAwayFromTheEndsOfASwingIsAScuff) {
  const auto scuffs = [](std::vector<StanceRecord> stances) {
    return ScuffedSwings(OneSwing(), LogOf(std::move(stances)), 2, TimingGate(), 2.0).size();
  };
  EXPECT_EQ(scuffs({Stance(0.0, 1.0), Stance(1.4, 2.0)}), 0u);
  EXPECT_EQ(scuffs({Stance(0.0, 1.039), Stance(1.361, 2.0)}), 0u);
  EXPECT_EQ(scuffs({Stance(0.0, 1.0), Stance(1.2, 1.21), Stance(1.4, 2.0)}), 1u);
  EXPECT_EQ(scuffs({Stance(0.0, 2.0)}), 1u) << "never lifted";
}

}  // namespace
}  // namespace gaitwright
