// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/model/load_robot.h"
#include "planning/gait/find_gait.h"
#include "planning/gait/schedule_contacts.h"

namespace gaitwright {
namespace {

constexpr int kFeet = 4;
constexpr double kGrid = 0.005;

Gait GaitOf(const std::string& name, double speed_m_s) {
  return FindGait(LoadNamedRobot("a1").value(), name, speed_m_s, {}).value();
}

GaitStint Standing(double time_s) { return {StandingGait(kFeet), time_s}; }

/// The phase of a schedule at a time.
const ContactPhase& At(const ContactSchedule& schedule, double time_s) {
  return schedule.phases[static_cast<std::size_t>(PhaseAt(schedule, time_s))];
}

TEST(JoinSchedules, OfOneGaitIsItsOwn) {
  const Gait trot = GaitOf("trot", 0.5);
  ScheduleRequest request;
  request.stepping_s = 1.3;
  const JoinedSchedule joined = JoinSchedules({{trot, 1.3}}, {}).value();
  EXPECT_EQ(joined.schedule, ScheduleContacts(trot, request).value());
  EXPECT_EQ(joined.start_s, std::vector<double>{0.0});
}

TEST(JoinSchedules, StandsBetweenForAsLongAsAsked) {
  const JoinedSchedule joined =
      JoinSchedules({{GaitOf("trot", 1.0), 1.0}, Standing(0.7), {GaitOf("bound", 0.8), 1.0}}, {}).value();
  CheckSchedule(joined.schedule, kFeet);
  ASSERT_EQ(joined.start_s.size(), 3U);
  const ContactPhase& rest = At(joined.schedule, joined.start_s[1] + 0.1);
  EXPECT_EQ(rest.stance, AllFeet(kFeet));
  EXPECT_NEAR(rest.start_s, joined.start_s[1], 1e-9);
  EXPECT_NEAR(rest.end_s, joined.start_s[2], 1e-9);
  EXPECT_NEAR(rest.end_s - rest.start_s, 0.7, 1e-9);
  EXPECT_NEAR(joined.schedule.phases.front().end_s, 0.8, 1e-9);
}

TEST(JoinSchedules, StandingAtTheEndsIsAllThatStandsThere) {
  const JoinedSchedule joined = JoinSchedules({Standing(0.3), {GaitOf("trot", 0.5), 1.0}, Standing(0.4)}, {}).value();
  const ContactPhase &first = joined.schedule.phases.front(), &last = joined.schedule.phases.back();
  EXPECT_EQ(first.stance, AllFeet(kFeet));
  EXPECT_EQ(last.stance, AllFeet(kFeet));
  EXPECT_NEAR(first.end_s, 0.3, 1e-9);
  EXPECT_NEAR(last.end_s - last.start_s, 0.4, 1e-9);
  EXPECT_NEAR(joined.start_s[1], 0.3, 1e-9);
  EXPECT_NEAR(joined.start_s[2], last.start_s, 1e-9);
}

/// Each gait after each other gait.
class JoinedGaits : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(JoinedGaits, GoOnWithAllFeetDownForAMomentOnly) {
  const Gait first = GaitOf(GetParam().first, 0.4), second = GaitOf(GetParam().second, 0.8);
  const JoinedSchedule joined = JoinSchedules({{first, 2.0}, {second, 2.0}}, {}).value();
  const ContactSchedule& schedule = joined.schedule;
  CheckSchedule(schedule, kFeet);
  const double change = joined.start_s[1];
  double longest_stance = 0.0;
  for (std::size_t i = 0; i < first.phase.size(); ++i) {
    longest_stance = std::max(longest_stance,
                              std::min(first.duty_factor[i] * first.cycle_s, second.duty_factor[i] * second.cycle_s));
  }
  double all_down = 0.0;
  for (const ContactPhase& phase : schedule.phases) {
    if (phase.stance == AllFeet(kFeet) && phase.end_s > change - 1e-9 && phase.start_s < change + 1e-9)
      all_down = std::max(all_down, phase.end_s - phase.start_s);
  }
  EXPECT_LE(all_down, longest_stance + kGrid);
  for (int foot = 0; foot < kFeet; ++foot) {
    const auto i = static_cast<std::size_t>(foot);
    const double least =
        std::min(first.duty_factor[i] * first.cycle_s, second.duty_factor[i] * second.cycle_s) - 1.5 * kGrid;
    const auto stances = IntervalsOf(schedule, foot);
    for (const ContactInterval& stance : stances) EXPECT_GE(stance.end_s - stance.start_s, least) << foot;
    // It lifts off in both gaits.
    EXPECT_TRUE(std::any_of(stances.begin(), stances.end(), [&](const auto& s) { return s.end_s < change; }));
    EXPECT_TRUE(std::any_of(stances.begin(), stances.end(),
                            [&](const auto& s) { return s.end_s >= change - 1e-9 && s.end_s < schedule.end_s(); }));
  }
}

INSTANTIATE_TEST_SUITE_P(OfFourFeet, JoinedGaits,
                         testing::Values(std::pair{"crawl", "trot"}, std::pair{"trot", "crawl"},
                                         std::pair{"trot", "bound"}, std::pair{"bound", "trot"},
                                         std::pair{"trot", "pace"}, std::pair{"crawl", "pronk"}));

TEST(JoinSchedules, StepsOnlyOnTheGrid) {
  const JoinedSchedule joined =
      JoinSchedules({{GaitOf("crawl", 0.2), 1.0}, {GaitOf("trot", 0.7), 0.9}, Standing(0.333)}, {}).value();
  for (const ContactPhase& phase : joined.schedule.phases)
    EXPECT_NEAR(std::round(phase.end_s / kGrid) * kGrid, phase.end_s, 1e-9);
}

TEST(JoinSchedules, StandingAloneIsOnePhaseAndNothingIsNone) {
  const JoinedSchedule joined = JoinSchedules({Standing(1.0), Standing(0.5)}, {}).value();
  ASSERT_EQ(joined.schedule.phases.size(), 1U);
  EXPECT_NEAR(joined.schedule.end_s(), 1.5, 1e-9);
  EXPECT_EQ(joined.start_s, (std::vector<double>{0.0, 1.0}));
  EXPECT_FALSE(JoinSchedules({}, {}).ok());
}

}  // namespace
}  // namespace gaitwright
