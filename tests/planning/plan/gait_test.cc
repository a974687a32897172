// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/gait.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

Gait GaitOfTimes(const std::vector<double>& phase, const std::vector<double>& duty_factor) {
  return {"made up", "", 1.0, phase, duty_factor};
}

using Intervals = std::vector<ContactInterval>;

TEST(FootSets, HoldWhatIsPutInUpTo64Feet) {
  for (const int foot : {0, 1, 31, 32, 63}) {
    EXPECT_TRUE(Contains(FootBit(foot), foot));
    EXPECT_FALSE(Contains(FootBit(foot), (foot + 1) % 64));
  }
  EXPECT_EQ(AllFeet(0), 0U);
  EXPECT_EQ(AllFeet(4), 0b1111U);
  EXPECT_EQ(AllFeet(63) ^ AllFeet(64), FootBit(63));
  EXPECT_EQ(AllFeet(70), AllFeet(64));
}

TEST(StanceAt, AFootStandsFromItsPhaseForItsDutyFactorAndOverTheCyclesEnd) {
  const Gait gait = GaitOfTimes({0.0, 0.75}, {0.25, 0.5});
  EXPECT_EQ(StanceAt(gait, 0.0), FootBit(0) | FootBit(1));
  EXPECT_EQ(StanceAt(gait, 0.249), FootBit(0) | FootBit(1));
  EXPECT_EQ(StanceAt(gait, 0.25), 0U) << "both have lifted off";
  EXPECT_EQ(StanceAt(gait, 0.7499), 0U);
  EXPECT_EQ(StanceAt(gait, 0.75), FootBit(1));
}

TEST(StanceAt, AFootIsDownForItsShareOfTheCycle) {
  const Gait gait = GaitOfTimes({0.1, 0.4, 0.9, 0.65}, {0.6, 0.3, 0.75, 0.5});
  constexpr int kLooks = 2000;
  for (int foot = 0; foot < 4; ++foot) {
    int down = 0;
    for (int k = 0; k < kLooks; ++k) down += Contains(StanceAt(gait, (k + 0.5) / kLooks), foot) ? 1 : 0;
    EXPECT_NEAR(static_cast<double>(down) / kLooks, gait.duty_factor[static_cast<std::size_t>(foot)], 1.0 / kLooks);
  }
}

TEST(GaitKinds, StandingHangingAndFlightAreDistinguished) {
  const Gait stand = StandingGait(4), hang = HangingGait(4), none;
  EXPECT_TRUE(StandsStill(stand) && !Hangs(stand) && !HasFlight(stand));
  EXPECT_TRUE(Hangs(hang) && !StandsStill(hang) && HasFlight(hang));
  EXPECT_FALSE(StandsStill(none) || Hangs(none)) << "without feet it is neither";
  EXPECT_EQ(stand.num_feet(), 4);
  EXPECT_FALSE(StandsStill(GaitOfTimes({0.0, 0.0}, {1.0, 0.9})));
  EXPECT_FALSE(Hangs(GaitOfTimes({0.0, 0.0}, {0.0, 0.1})));
}

TEST(GaitKinds, FlightIsFoundWhereverInTheCycleItIs) {
  EXPECT_FALSE(HasFlight(GaitOfTimes({0.0, 0.5}, {0.5, 0.5}))) << "one lands as the other lifts";
  EXPECT_TRUE(HasFlight(GaitOfTimes({0.0, 0.5}, {0.49, 0.5})));
  EXPECT_TRUE(HasFlight(GaitOfTimes({0.0, 0.5}, {0.5, 0.49})));
  EXPECT_FALSE(HasFlight(GaitOfTimes({0.0, 0.3}, {0.31, 0.71})));
  EXPECT_TRUE(HasFlight(GaitOfTimes({0.2, 0.2}, {0.95, 0.9})));
}

TEST(PhaseAt, ABoundaryBelongsToTheLaterPhaseAndTimesBeyondToTheEnds) {
  const ContactSchedule schedule{{{0.0, 0.4, 3}, {0.4, 0.6, 1}, {0.6, 1.0, 3}}};
  const std::vector<std::pair<double, int>> expected = {{-1.0, 0}, {0.0, 0}, {0.39, 0}, {0.4, 1},        {0.5, 1},
                                                        {0.6, 2},  {1.0, 2}, {9.0, 2},  {0.4 - 1e-12, 1}};
  for (const auto& [time_s, phase] : expected) EXPECT_EQ(PhaseAt(schedule, time_s), phase) << time_s;
}

TEST(LongestFlight, IsTheLongestPhaseOnNoFoot) {
  EXPECT_EQ(LongestFlight({}), 0.0);
  EXPECT_EQ(LongestFlight({{{0.0, 1.0, 1}}}), 0.0);
  EXPECT_DOUBLE_EQ(LongestFlight({{{0.0, 0.5, 0}, {0.5, 0.6, 1}, {0.6, 1.35, 0}}}), 0.75);
}

/// Disjoint intervals of a foot in [0, 10], with gaps between.
Intervals DrawnIntervals(std::mt19937& random) {
  std::uniform_real_distribution<double> length(0.1, 1.2);
  Intervals intervals;
  double t = length(random);
  while (t < 8.0) {
    const double end = t + length(random);
    intervals.push_back({t, end});
    t = end + length(random);
  }
  return intervals;
}

TEST(ContactSchedules, OfIntervalsGiveTheseIntervalsBack) {
  std::mt19937 random(12);
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<Intervals> by_foot = {DrawnIntervals(random), DrawnIntervals(random), {}, DrawnIntervals(random)};
    const ContactSchedule schedule = ScheduleFromIntervals(by_foot, 0.0, 10.0);
    EXPECT_NO_THROW(CheckSchedule(schedule, 4));
    EXPECT_EQ(schedule.start_s(), 0.0);
    EXPECT_EQ(schedule.end_s(), 10.0);
    for (int foot = 0; foot < 4; ++foot)
      EXPECT_EQ(IntervalsOf(schedule, foot), by_foot[static_cast<std::size_t>(foot)]);
    for (std::size_t i = 1; i < schedule.phases.size(); ++i)
      EXPECT_NE(schedule.phases[i].stance, schedule.phases[i - 1].stance) << "neighbours differ";
  }
}

TEST(ContactSchedules, FeetThatSwapAtOneTimeMakeOneBoundary) {
  const ContactSchedule schedule = ScheduleFromIntervals({{{0.0, 0.5}}, {{0.5, 1.0}}}, 0.0, 1.0);
  ASSERT_EQ(schedule.phases.size(), 2U);
  EXPECT_EQ(schedule.phases[0], (ContactPhase{0.0, 0.5, FootBit(0)}));
  EXPECT_EQ(schedule.phases[1], (ContactPhase{0.5, 1.0, FootBit(1)}));
}

TEST(ContactSchedules, IntervalsThatMeetAreOneAndEmptyOnesAreNone) {
  const ContactSchedule schedule = ScheduleFromIntervals({{{0.0, 0.4}, {0.4, 1.0}}, {{0.3, 0.3}}}, 0.0, 1.0);
  ASSERT_EQ(schedule.phases.size(), 1U);
  EXPECT_EQ(schedule.phases[0], (ContactPhase{0.0, 1.0, FootBit(0)}));
}

TEST(ContactSchedules, WithoutAnyContactIsOneFlight) {
  const ContactSchedule schedule = ScheduleFromIntervals({{}, {}}, 1.0, 3.0);
  ASSERT_EQ(schedule.phases.size(), 1U);
  EXPECT_EQ(schedule.phases[0], (ContactPhase{1.0, 3.0, 0}));
  EXPECT_DOUBLE_EQ(LongestFlight(schedule), 2.0);
}

TEST(CheckSchedule, RefusesGapsEmptyPhasesAndFeetThatAreNot) {
  EXPECT_NO_THROW(CheckSchedule({{{0.0, 1.0, 3}, {1.0, 2.0, 1}}}, 2));
  EXPECT_THROW(CheckSchedule({}, 2), InvalidArgument);
  EXPECT_THROW(CheckSchedule({{{0.0, 0.0, 1}}}, 2), InvalidArgument);
  EXPECT_THROW(CheckSchedule({{{1.0, 0.5, 1}}}, 2), InvalidArgument);
  EXPECT_THROW(CheckSchedule({{{0.0, 1.0, 3}, {1.0 + 1e-9, 2.0, 1}}}, 2), InvalidArgument) << "a gap";
  EXPECT_THROW(CheckSchedule({{{0.0, 1.0, FootBit(2)}}}, 2), InvalidArgument);
  EXPECT_NO_THROW(CheckSchedule({{{0.0, 1.0, FootBit(63)}}}, 64));
}

}  // namespace
}  // namespace gaitwright
