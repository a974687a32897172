// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "playback/score/contact_timing.h"
#include "workflows/compare/compare_parts_internal.h"

namespace gaitwright {
namespace {

using Stances = std::vector<ContactInterval>;

ComparedMotion WithStances(Stances stances) {
  ComparedMotion motion;
  motion.stances = {std::move(stances)};
  return motion;
}

/// One foot over ten seconds, with cycles of one second.
SharedTime TenSeconds() {
  SharedTime shared;
  shared.end_s = 10.0;
  shared.feet = {{"paw", 0, 0}};
  return shared;
}

struct ComparedFeet {
  std::vector<FootDifference> feet;
  std::vector<FirstDifference> beyond;
};

ComparedFeet FeetWith(const Stances& a, const Stances& b, const SharedTime& shared, double tolerance = 0.05) {
  ComparedFeet compared;
  compared.feet = FeetDifferences(WithStances(a), WithStances(b), shared, tolerance, compared.beyond);
  return compared;
}

TEST(CompareFeet, TimesAreLateByBMinusA) {
  const ComparedFeet c = FeetWith({{0.0, 2.0}, {3.0, 5.0}}, {{0.0, 2.02}, {2.7, 5.0}}, TenSeconds());
  ASSERT_EQ(c.feet.size(), 1U);
  const SeriesDifference& timing = c.feet[0].timing;
  EXPECT_EQ(c.feet[0].foot, "paw");
  EXPECT_EQ(c.feet[0].stances_a, 2);
  EXPECT_EQ(timing.samples, 3) << "what begins with the motion is no touch-down";
  EXPECT_NEAR(timing.largest, -0.3, 1e-12);
  EXPECT_NEAR(timing.at_s, 3.0, 1e-12);
  EXPECT_NEAR(timing.rms, std::sqrt((0.02 * 0.02 + 0.3 * 0.3) / 3.0), 1e-12);
  ASSERT_EQ(c.beyond.size(), 1U) << "0.02 s is within the tolerance";
  EXPECT_EQ(c.beyond[0].quantity, "touch-down of paw");
  EXPECT_NEAR(c.beyond[0].time_s, 2.7, 1e-12) << "from the earlier one on they differ";
  EXPECT_NEAR(timing.first_s.value(), 2.7, 1e-12);
}

TEST(CompareFeet, TheToleranceIsAShareOfTheCycle) {
  SharedTime shared = TenSeconds();
  const Stances a = {{0.0, 2.0}}, b = {{0.0, 2.08}};
  EXPECT_EQ(FeetWith(a, b, shared).beyond.size(), 1U);
  shared.cycle_s = 2.0;
  EXPECT_TRUE(FeetWith(a, b, shared).beyond.empty());
}

TEST(CompareFeet, TheOffsetOfTheClocksIsTakenOut) {
  SharedTime shared = TenSeconds();
  shared.offset_s = 100.0;
  const ComparedFeet c = FeetWith({{1.0, 2.0}}, {{101.0, 102.0}}, shared);
  EXPECT_TRUE(c.beyond.empty());
  EXPECT_EQ(c.feet[0].timing.samples, 2);
  EXPECT_NEAR(c.feet[0].timing.largest, 0.0, 1e-12);
}

TEST(CompareFeet, AStanceThatTheOtherSideHasNotIsUnmatched) {
  const Stances both = {{0.0, 2.0}, {5.0, 6.0}}, one = {{0.0, 2.0}};
  const ComparedFeet lost = FeetWith(both, one, TenSeconds()), added = FeetWith(one, both, TenSeconds());
  EXPECT_EQ(lost.feet[0].unmatched, 1);
  EXPECT_EQ(added.feet[0].unmatched, 1);
  ASSERT_EQ(lost.beyond.size(), 1U);
  EXPECT_EQ(lost.beyond[0].quantity, "contact of paw");
  EXPECT_EQ(lost.beyond[0].a, 1.0);
  EXPECT_EQ(lost.beyond[0].b, 0.0);
  EXPECT_EQ(added.beyond.at(0).a, 0.0);
  EXPECT_EQ(added.beyond.at(0).b, 1.0);
  EXPECT_NEAR(lost.beyond[0].time_s, 5.0, 1e-12);
}

TEST(CompareFeet, ATouchOfNextToNoTimeIsNone) {
  const double brief_s = 0.5 * TimingGate();
  EXPECT_TRUE(FeetWith({{0.0, 2.0}, {5.0, 5.0 + brief_s}}, {{0.0, 2.0}}, TenSeconds(), 0.0).beyond.empty());
}

TEST(CompareFeet, WhatIsOutsideOfTheSharedTimeDoesNotCount) {
  SharedTime shared = TenSeconds();
  shared.start_s = 4.0;
  const ComparedFeet c = FeetWith({{0.0, 2.0}, {3.0, 6.0}}, {{2.0, 6.0}}, shared);
  EXPECT_EQ(c.feet[0].stances_a, 1);
  EXPECT_EQ(c.feet[0].timing.samples, 1) << "lift-offs alone: both stood when the shared time began";
  EXPECT_TRUE(c.beyond.empty());
}

TEST(CompareFeet, NothingIsSaidOfEventsInAGap) {
  SharedTime shared = TenSeconds();
  shared.gaps = {{1.5, 2.5}};
  const ComparedFeet c = FeetWith({{0.0, 2.0}}, {{0.0, 2.4}}, shared);
  EXPECT_EQ(c.feet[0].timing.samples, 0);
  EXPECT_TRUE(c.beyond.empty());
  EXPECT_TRUE(FeetWith({{0.0, 1.0}, {1.6, 2.4}}, {{0.0, 1.0}}, shared).beyond.empty()) << "a stance that nobody saw";
}

TEST(CompareFeet, WhereContactsAreUnknownNoFootIsCompared) {
  std::vector<FirstDifference> beyond;
  EXPECT_TRUE(FeetDifferences({}, WithStances({{0.0, 1.0}}), TenSeconds(), 0.05, beyond).empty());
  EXPECT_TRUE(beyond.empty());
}

TEST(CompareFeet, TheCycleIsTheMeanTimeBetweenTouchDowns) {
  ComparedMotion motion = WithStances({{0.0, 0.5}, {1.0, 1.5}, {1.8, 2.0}, {3.0, 3.5}});
  EXPECT_NEAR(CycleOf(motion), 1.0, 1e-12) << "0.8 s and 1.2 s; the first stance began before";
  motion.stances.push_back({{0.0, 1.0}, {2.0, 3.0}, {5.0, 6.0}});
  EXPECT_NEAR(CycleOf(motion), (0.8 + 1.2 + 3.0) / 3.0, 1e-12);
  EXPECT_EQ(CycleOf(WithStances({{0.0, 1.0}, {2.0, 3.0}})), 1.0);
  EXPECT_EQ(CycleOf({}), 1.0);
}

}  // namespace
}  // namespace gaitwright
