// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/pace_search.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gaitwright {
namespace {

TEST(LargestPace, IsTheLastOfTwoDigitsThatIsPossible) {
  for (const double limit : {0.0314, 0.5, 0.999, 1.04, 2.71}) {
    for (const double asked : {3.0, 4.2, 17.0}) {
      int questions = 0;
      const double largest = LargestPace({asked, 10.0}, [&](double pace) {
        ++questions;
        return pace <= limit;
      });
      EXPECT_LE(largest, limit);
      EXPECT_GT(1.1001 * largest, limit) << "the next number of two digits is too much";
      EXPECT_LE(questions, 20);
    }
  }
  EXPECT_EQ(LargestPace({3.0, 10.0}, [](double) { return false; }), 0.0);
}

TEST(LargestPace, IsNotLookedForBeyondWhatNoLegReaches) {
  double fastest = 0.0;
  LargestPace({1000.0, 4.0}, [&](double pace) {
    fastest = std::max(fastest, pace);
    return pace <= 0.5;
  });
  EXPECT_LE(fastest, 4.0);
}

TEST(LargestPace, HalvesNoMoreOftenThanSaid) {
  double slowest = 10.0;
  const auto possible = [&](double pace) {
    slowest = std::min(slowest, pace);
    return pace <= 0.01;
  };
  EXPECT_EQ(LargestPace({3.2, 10.0, 5}, possible), 0.0);
  EXPECT_NEAR(slowest, 0.05, 1e-9);
  EXPECT_EQ(LargestPace({3.2, 10.0, 9}, possible), 0.01);
}

TEST(LargestPace, AboveAKnownOneIsFoundWithFewQuestions) {
  for (const double limit : {0.5, 0.51, 0.52, 0.56, 0.99, 1.04, 2.71, 3.0}) {
    int questions = 0;
    const double largest = LargestPaceAbove({3.0, 10.0}, 0.5, 1, [&](double pace) {
      ++questions;
      EXPECT_GT(pace, 0.5);
      EXPECT_LT(pace, 3.0);
      return pace <= limit;
    });
    EXPECT_LE(largest, limit);
    EXPECT_GE(1.1001 * largest, std::min(limit, 2.9));
    EXPECT_LE(questions, limit < 0.51 ? 1 : 12);
  }
}

TEST(NextLower, IsTheNextNumberOfTwoDigits) {
  EXPECT_DOUBLE_EQ(NextLower(0.5), 0.49);
  EXPECT_DOUBLE_EQ(NextLower(0.1), 0.099);
  EXPECT_DOUBLE_EQ(NextLower(1.234), 1.2);
}

TEST(PaceSearch, SomePaceIsTheFirstPossibleHalf) {
  int calls = 0;
  const auto possible = [&](double pace) {
    ++calls;
    return pace <= 0.3;
  };
  EXPECT_DOUBLE_EQ(SomePace({2.0, 10.0}, possible), 0.25);
  EXPECT_EQ(calls, 4) << "the slowest, 1, 0.5 and 0.25";
  EXPECT_EQ(SomePace({2.0, 10.0}, [](double) { return false; }), 0.0);
}

}  // namespace
}  // namespace gaitwright
