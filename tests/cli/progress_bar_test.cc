// SPDX-License-Identifier: BSD-3-Clause
#include "cli/progress_bar.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gaitwright::cli {
namespace {

TEST(ProgressBar, TimesAreThoseOfAClock) {
  EXPECT_EQ(ClockText(0.0), "0:00");
  EXPECT_EQ(ClockText(127.4), "2:07");
  EXPECT_EQ(ClockText(59.6), "1:00");
  EXPECT_EQ(ClockText(3909.0), "1:05:09");
}

TEST(ProgressBar, WhatWasThereBeforeTellsNothingOfTheTimeLeft) {
  EXPECT_EQ(TimeLeft({.done = 1, .all = 4}, 2.0), 6.0);
  EXPECT_EQ(TimeLeft({.done = 101, .all = 104, .before = 100}, 2.0), 6.0);
  EXPECT_EQ(TimeLeft({.done = 4, .all = 4}, 2.0), 0.0);
  EXPECT_TRUE(std::isnan(TimeLeft({.done = 100, .all = 104, .before = 100}, 2.0)));
}

TEST(ProgressBar, TheUnitStandsWithItsNumbers) {
  EXPECT_EQ(ProgressText({.done = 1, .all = 4}, "points", 2.0, ""), "1 of 4 points, 0:02 left");
  EXPECT_EQ(ProgressText({.done = 7, .all = 14}, "trials", 63.0, "2 fell"), "7 of 14 trials, 1:03 left, 2 fell");
  EXPECT_EQ(ProgressText({.done = 0, .all = 14}, "trials", std::nan(""), "ending"), "0 of 14 trials, ending");
}

TEST(ProgressBar, TheBarIsAsFullAsItsShare) {
  EXPECT_EQ(BarText({.done = 1, .all = 2}), "[############............]  50 %  ");
  EXPECT_EQ(BarText({.done = 2, .all = 2}), "[########################] 100 %  ");
  EXPECT_EQ(BarText({.done = 0, .all = 0}), "[........................]   0 %  ");
}

TEST(ProgressBar, LinesComeAfterAMinuteAndOneAMinute) {
  MinuteByMinute lines;
  int due = 0;
  for (int tenth = 0; tenth < 600; ++tenth) due += lines.Due(0.1 * tenth) ? 1 : 0;
  EXPECT_EQ(due, 0) << "short work says nothing";
  for (int tenth = 600; tenth < 3600; ++tenth) due += lines.Due(0.1 * tenth) ? 1 : 0;
  EXPECT_EQ(due, 5) << "in the five minutes after";
  EXPECT_TRUE(lines.Due(1000.0)) << "what came rarely";
  EXPECT_FALSE(lines.Due(1059.0));
}

}  // namespace
}  // namespace gaitwright::cli
