// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/place_feet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "planning/gait/schedule_contacts.h"
#include "planning/paths/standing_feet.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

Gait StepsInTurn(const RobotModel& model) {
  const auto feet = model.feet.size();
  Gait gait{"in turn", "", 0.8, {}, std::vector<double>(feet, 0.8)};
  for (std::size_t f = 0; f < feet; ++f) gait.phase.push_back(static_cast<double>(f) / static_cast<double>(feet));
  return gait;
}

/// A walk along a twist, from standing to standing.
struct PlacedWalk {
  PlacedWalk(const RobotModel& model, const PlanarTwist& twist) : gait(StepsInTurn(model)) {
    ScheduleRequest request;
    request.stepping_s = 3.2;
    schedule = ScheduleContacts(gait, request).value();
    path = MakeBasePath(twist, 0.8, 3.2, 0.4, schedule.end_s());
    footsteps = PlaceAlongPath(model, gait, schedule, path, twist);
  }
  std::vector<Foothold> Of(int foot) const {
    std::vector<Foothold> own;
    for (const Foothold& foothold : footsteps.footholds) {
      if (foothold.foot == foot) own.push_back(foothold);
    }
    return own;
  }
  Gait gait;
  ContactSchedule schedule;
  BasePath path;
  FootstepPlan footsteps;
};

/// A schedule with this number of footfalls.
ContactSchedule CountedSchedule(const RobotModel& model, int footfalls, int first_foot = -1) {
  ScheduleRequest request;
  request.footfalls = footfalls;
  request.first_foot = first_foot;
  return ScheduleContacts(StepsInTurn(model), request).value();
}

class PlaceFeetTest : public testing::TestWithParam<const char*> {};

TEST_P(PlaceFeetTest, TheFirstFootholdsAreThoseOfStandingAndTheLastThoseAtTheEnd) {
  const RobotModel& model = NamedRobot(GetParam());
  const std::vector<Pose> standing = StandingFeet(model);
  for (const PlanarTwist& twist : {PlanarTwist{0.5, 0.0, 0.0}, PlanarTwist{0.3, 0.1, 0.4}}) {
    const PlacedWalk walk(model, twist);
    for (std::size_t f = 0; f < standing.size(); ++f) {
      const std::vector<Foothold> own = walk.Of(static_cast<int>(f));
      ASSERT_GE(own.size(), 3U);
      EXPECT_LT((own.front().X_WF.translation() - standing[f].translation()).norm(), 1e-12);
      const Pose end = Carried(PoseAlong(twist, 1.0), standing[f]);
      EXPECT_LT((own.back().X_WF.translation() - end.translation()).norm(), 1e-9);
      EXPECT_LT((own.back().X_WF.linear() - end.linear()).norm(), 1e-9);
    }
  }
}

TEST_P(PlaceFeetTest, InMidStanceAFootIsWhereItStandsUnderTheBase) {
  const RobotModel& model = NamedRobot(GetParam());
  const std::vector<Pose> standing = StandingFeet(model);
  const PlacedWalk walk(model, {0.6, 0.0, 0.0});
  for (std::size_t f = 0; f < standing.size(); ++f) {
    const std::vector<Foothold> own = walk.Of(static_cast<int>(f));
    for (std::size_t i = 1; i + 1 < own.size(); ++i) {
      const PlanarPose base = PoseAt(walk.path, 0.5 * (own[i].touchdown_s + own[i].liftoff_s));
      EXPECT_NEAR(own[i].X_WF.translation().x(), standing[f].translation().x() + base.x_m, 1e-9);
      EXPECT_NEAR(own[i].X_WF.translation().y(), standing[f].translation().y(), 1e-9);
    }
  }
}

TEST_P(PlaceFeetTest, FootholdsAreSortedAndHaveTheTimesOfTheSchedule) {
  const RobotModel& model = NamedRobot(GetParam());
  const PlacedWalk walk(model, {0.4, 0.0, 0.2});
  EXPECT_TRUE(std::is_sorted(walk.footsteps.footholds.begin(), walk.footsteps.footholds.end(),
                             [](const Foothold& a, const Foothold& b) { return a.touchdown_s < b.touchdown_s; }));
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    const std::vector<ContactInterval> intervals = IntervalsOf(walk.schedule, foot);
    const std::vector<Foothold> own = walk.Of(foot);
    ASSERT_EQ(own.size(), intervals.size());
    for (std::size_t i = 0; i < own.size(); ++i)
      EXPECT_EQ((ContactInterval{own[i].touchdown_s, own[i].liftoff_s}), intervals[i]);
  }
}

TEST_P(PlaceFeetTest, AStanceThatSpansAStandHasTheFootholdsOfStandingThere) {
  const RobotModel& model = NamedRobot(GetParam());
  const Gait gait = StepsInTurn(model);
  GaitStint walk{gait}, stand{StandingGait(gait.num_feet())};
  walk.time_s = 1.6;
  const JoinedSchedule joined = JoinSchedules({walk, stand, walk}, {}).value();
  const double end_s = joined.schedule.end_s(), rest_s = joined.start_s[1] + 0.5 * stand.time_s;
  const PlanarTwist twist{0.3, 0.0, 0.0};
  const BasePath path = MakeBasePath({{twist, 0.8, joined.start_s[1] - 0.8, 0.4, 0.4},
                                      {twist, joined.start_s[2], end_s - 0.8 - joined.start_s[2], 0.4, 0.4}},
                                     end_s);
  const FootstepPlan plan = PlaceAlongPath(model, joined.schedule, path,
                                           {{0.0, joined.start_s[1], false, gait.cycle_s, twist},
                                            {joined.start_s[1], joined.start_s[2], true, gait.cycle_s, {}},
                                            {joined.start_s[2], end_s, false, gait.cycle_s, twist}});
  const std::vector<Pose> standing = StandingFeet(model);
  for (int foot = 0; foot < gait.num_feet(); ++foot) {
    const Foothold& at_rest = plan.footholds[static_cast<std::size_t>(FootholdAt(plan, foot, rest_s))];
    EXPECT_NEAR(at_rest.X_WF.translation().x(), standing[static_cast<std::size_t>(foot)].translation().x() + 0.3, 1e-6);
  }
}

TEST_P(PlaceFeetTest, CountedFootfallsLandAsManyStepsForwardAndCloseTheStance) {
  const RobotModel& model = NamedRobot(GetParam());
  const int feet = static_cast<int>(model.feet.size()), count = 2 * feet + 1;
  const std::vector<Pose> standing = StandingFeet(model);
  const CountedFootsteps counted = PlaceCounted(model, CountedSchedule(model, count), {0.02, 0.0, 0.0});
  EXPECT_EQ(counted.steps_to_goal, count - feet + 1);
  std::vector<Foothold> falls;
  for (const Foothold& foothold : counted.footsteps.footholds) {
    if (foothold.touchdown_s > 0.0) falls.push_back(foothold);
  }
  ASSERT_EQ(falls.size(), static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < falls.size(); ++k) {
    const double forward =
        falls[k].X_WF.translation().x() - standing[static_cast<std::size_t>(falls[k].foot)].translation().x();
    EXPECT_NEAR(forward, 0.02 * std::min(static_cast<int>(k) + 1, counted.steps_to_goal), 1e-9) << k;
  }
}

TEST_P(PlaceFeetTest, FewerFootfallsThanFeetLeadNowhere) {
  const RobotModel& model = NamedRobot(GetParam());
  const CountedFootsteps counted = PlaceCounted(model, CountedSchedule(model, 1), {0.05, 0.0, 0.0});
  EXPECT_EQ(counted.steps_to_goal, 0);
  const std::vector<Pose> standing = StandingFeet(model);
  for (const Foothold& foothold : counted.footsteps.footholds) {
    const Vector3 p = standing[static_cast<std::size_t>(foothold.foot)].translation();
    EXPECT_LT((foothold.X_WF.translation() - p).norm(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, PlaceFeetTest, testing::Values("a1", "nao"));

TEST(LeadingFoot, IsTheOneOnTheSideOfASideStepOrTurnOfABiped) {
  const RobotModel& nao = NamedRobot("nao");
  ASSERT_GT(StandingFeet(nao)[0].translation().y(), 0.0) << "foot 0 is the left one";
  EXPECT_EQ(LeadingFoot(nao, {0.0, 0.1, 0.0}), 0);
  EXPECT_EQ(LeadingFoot(nao, {0.0, -0.1, 0.0}), 1);
  EXPECT_EQ(LeadingFoot(nao, {0.0, 0.0, 0.3}), 0);
  EXPECT_EQ(LeadingFoot(nao, {0.0, 0.0, -0.3}), 1);
  EXPECT_EQ(LeadingFoot(nao, {0.0, 0.1, -0.3}), 0) << "the side-step decides";
  EXPECT_EQ(LeadingFoot(nao, {0.2, 0.0, 0.0}), -1);
  EXPECT_EQ(LeadingFoot(NamedRobot("a1"), {0.0, 0.1, 0.3}), -1) << "four feet need none";
}

TEST(PlaceCounted, SideStepsOfABipedNeverBringItsFeetNearer) {
  const RobotModel& nao = NamedRobot("nao");
  const std::vector<Pose> standing = StandingFeet(nao);
  const double apart = standing[0].translation().y() - standing[1].translation().y();
  for (const double step_m : {0.03, -0.03}) {
    const int first = LeadingFoot(nao, {0.0, step_m, 0.0});
    const CountedFootsteps counted = PlaceCounted(nao, CountedSchedule(nao, 8, first), {0.0, step_m, 0.0});
    EXPECT_GT(counted.steps_to_goal, 5);
    for (const Foothold& fall : counted.footsteps.footholds) {
      const auto y = [&](int foot) {
        const int at = FootholdAt(counted.footsteps, foot, fall.touchdown_s);
        return counted.footsteps.footholds[static_cast<std::size_t>(at)].X_WF.translation().y();
      };
      EXPECT_GE(y(0) - y(1), apart - 1e-9) << step_m << " at " << fall.touchdown_s;
    }
  }
}

}  // namespace
}  // namespace gaitwright
