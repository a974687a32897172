// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/schedule_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace gaitwright {
namespace {

/// Two feet in turn, each down for `duty` of a cycle.
Gait InTurn(double cycle_s, double duty) { return {"in turn", "", cycle_s, {0.0, 0.5}, {duty, duty}}; }

/// Four feet one after the other.
Gait OneByOne(double cycle_s) { return {"one by one", "", cycle_s, {0.0, 0.5, 0.25, 0.75}, {0.8, 0.8, 0.8, 0.8}}; }

/// Swings of a foot: the gaps between its intervals of contact.
std::vector<ContactInterval> SwingsOf(const ContactSchedule& schedule, int foot) {
  const std::vector<ContactInterval> stances = IntervalsOf(schedule, foot);
  std::vector<ContactInterval> swings;
  for (std::size_t i = 1; i < stances.size(); ++i) swings.push_back({stances[i - 1].end_s, stances[i].start_s});
  return swings;
}

int FootfallsIn(const ContactSchedule& schedule, int num_feet) {
  int count = 0;
  for (int foot = 0; foot < num_feet; ++foot) count += static_cast<int>(SwingsOf(schedule, foot).size());
  return count;
}

ContactSchedule Scheduled(const Gait& gait, const ScheduleRequest& request) {
  const Result<ContactSchedule> schedule = ScheduleContacts(gait, request);
  EXPECT_TRUE(schedule.ok()) << schedule.failure().message;
  return schedule.ok() ? *schedule : ContactSchedule{};
}

TEST(ScheduleContacts, BeginsAndEndsWithAllFeetForAsLongAsAsked) {
  for (const Gait& gait : {InTurn(0.8, 0.6), OneByOne(1.0)}) {
    ScheduleRequest request;
    request.initial_stand_s = 0.35;
    request.final_stand_s = 0.6;
    request.stepping_s = 2.0;
    const ContactSchedule schedule = Scheduled(gait, request);
    const ContactPhase &first = schedule.phases.front(), &last = schedule.phases.back();
    EXPECT_EQ(first.stance, AllFeet(gait.num_feet()));
    EXPECT_EQ(last.stance, AllFeet(gait.num_feet()));
    EXPECT_NEAR(first.end_s - first.start_s, 0.35, 1e-9);
    EXPECT_NEAR(last.end_s - last.start_s, 0.6, 1e-9);
  }
}

TEST(ScheduleContacts, SwingsLastWhatTheGaitSaysAndStartWithinTheTime) {
  const Gait gait = InTurn(0.8, 0.65);
  ScheduleRequest request;
  request.stepping_s = 3.0;
  const ContactSchedule schedule = Scheduled(gait, request);
  for (int foot = 0; foot < 2; ++foot) {
    const std::vector<ContactInterval> swings = SwingsOf(schedule, foot);
    EXPECT_GE(swings.size(), 3U);
    for (std::size_t i = 0; i < swings.size(); ++i) {
      EXPECT_NEAR(swings[i].end_s - swings[i].start_s, 0.35 * 0.8, 1e-9);
      EXPECT_LT(swings[i].start_s, request.initial_stand_s + request.stepping_s);
      if (i == 0) continue;
      EXPECT_NEAR(swings[i].start_s - swings[i - 1].start_s, 0.8, 1e-9) << "once in a cycle";
    }
  }
}

TEST(ScheduleContacts, ACountOfFootfallsIsExactAndInTheGaitsOrder) {
  const Gait gait = OneByOne(1.0);
  for (const int count : {1, 3, 4, 9}) {
    ScheduleRequest request;
    request.footfalls = count;
    const ContactSchedule schedule = Scheduled(gait, request);
    EXPECT_EQ(FootfallsIn(schedule, 4), count);
    std::map<double, int> order;  // foot by lift-off
    for (int foot = 0; foot < 4; ++foot) {
      for (const ContactInterval& swing : SwingsOf(schedule, foot)) order[swing.start_s] = foot;
    }
    // Lift-offs at 0.8, 0.3, 0.05 and 0.55 of the cycle: feet 2, 1, 3, 0.
    const std::vector<int> expected = {2, 1, 3, 0};
    std::size_t k = 0;
    for (const auto& [time_s, foot] : order) EXPECT_EQ(foot, expected[k++ % 4]) << time_s;
  }
}

TEST(ScheduleContacts, TheFirstFootCanBeAnyOfThem) {
  for (int first = 0; first < 4; ++first) {
    ScheduleRequest request;
    request.footfalls = 4;
    request.first_foot = first;
    const ContactSchedule schedule = Scheduled(OneByOne(1.0), request);
    const FootSet without = AllFeet(4) & ~FootBit(first);
    EXPECT_EQ(schedule.phases[1].stance, without);
  }
}

TEST(ScheduleContacts, EachBoundaryIsOnTheGridWhateverTheCycle) {
  for (const double cycle_s : {0.613, 0.777, 0.9001}) {
    ScheduleRequest request;
    request.grid_s = 0.01;
    request.stepping_s = 3.0;
    for (const ContactPhase& phase : Scheduled(InTurn(cycle_s, 0.58), request).phases) {
      EXPECT_NEAR(phase.start_s / 0.01, std::round(phase.start_s / 0.01), 1e-6);
      EXPECT_NEAR(phase.end_s / 0.01, std::round(phase.end_s / 0.01), 1e-6);
    }
  }
}

TEST(ScheduleContacts, RoundingKeepsEachDoubleSupportAndFlightAsLongAsTheOthers) {
  for (const double duty : {0.43, 0.61}) {
    ScheduleRequest request;
    request.grid_s = 0.01;
    request.stepping_s = 4.0;
    const ContactSchedule schedule = Scheduled(InTurn(0.737, duty), request);
    std::vector<double> lengths;
    for (std::size_t i = 1; i + 1 < schedule.phases.size(); ++i) {
      const ContactPhase& phase = schedule.phases[i];
      if (phase.stance == 0 || phase.stance == AllFeet(2)) lengths.push_back(phase.end_s - phase.start_s);
    }
    ASSERT_GT(lengths.size(), 4U);
    for (const double length : lengths) EXPECT_NEAR(length, lengths.front(), 1e-9) << duty;
  }
}

TEST(ScheduleContacts, ASwingOrStanceShorterThanTwoStepsOfTheGridIsRefused) {
  ScheduleRequest request;
  request.grid_s = 0.01;
  EXPECT_TRUE(ScheduleContacts(InTurn(0.2, 0.9), request).ok()) << "a swing of 20 ms";
  for (const Gait& gait : {InTurn(0.19, 0.9), InTurn(0.19, 0.1)}) {
    const Result<ContactSchedule> schedule = ScheduleContacts(gait, request);
    ASSERT_FALSE(schedule.ok());
    EXPECT_EQ(schedule.failure().kind, FailureKind::kBadInput);
    EXPECT_EQ(schedule.failure().code, FailureCode::kGait);
    EXPECT_EQ(schedule.failure().suggestions.size(), 2U);
    const bool swing = gait.duty_factor[0] > 0.5;
    EXPECT_NE(schedule.failure().message.find(swing ? "the swing of foot 0" : "the stance of foot 0"),
              std::string::npos);
  }
}

TEST(JoinedStints, FollowEachOtherWithoutLosingFootfalls) {
  GaitStint first{InTurn(0.8, 0.6)}, second{InTurn(0.6, 0.7)};
  first.footfalls = 4;
  second.footfalls = 6;
  const Result<JoinedSchedule> joined = JoinSchedules({first, second}, {});
  ASSERT_TRUE(joined.ok()) << joined.failure().message;
  EXPECT_EQ(FootfallsIn(joined->schedule, 2), 10);
  ASSERT_EQ(joined->start_s.size(), 2U);
  EXPECT_EQ(joined->start_s[0], 0.0);
  EXPECT_GT(joined->start_s[1], 0.8);
  EXPECT_NO_THROW(CheckSchedule(joined->schedule, 2));
}

TEST(JoinedStints, AStandBetweenLastsItsTimeOnAllFeet) {
  GaitStint walk{InTurn(0.8, 0.6)}, stand{StandingGait(2)};
  walk.footfalls = 4;
  stand.time_s = 1.5;
  const Result<JoinedSchedule> joined = JoinSchedules({walk, stand, walk}, {});
  ASSERT_TRUE(joined.ok()) << joined.failure().message;
  const ContactPhase& rest =
      joined->schedule.phases[static_cast<std::size_t>(PhaseAt(joined->schedule, joined->start_s[1] + 0.75))];
  EXPECT_EQ(rest.stance, AllFeet(2));
  EXPECT_NEAR(rest.start_s, joined->start_s[1], 1e-9);
  EXPECT_GE(rest.end_s - rest.start_s, 1.5 - 1e-9);
}

TEST(JoinedStints, TheFailureOfOneIsThatOfAll) {
  EXPECT_FALSE(JoinSchedules({}, {}).ok());
  const Result<JoinedSchedule> joined = JoinSchedules({{InTurn(0.8, 0.6)}, {InTurn(0.01, 0.6)}}, {});
  ASSERT_FALSE(joined.ok());
  EXPECT_EQ(joined.failure().code, FailureCode::kGait);
}

}  // namespace
}  // namespace gaitwright
