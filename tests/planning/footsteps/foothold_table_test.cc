// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/foothold_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "planning/paths/standing_feet.h"
#include "tests/named_robot.h"
#include "tests/planning/footsteps/grounds.h"
#include "tests/planning/footsteps/search_rig.h"

namespace gaitwright {
namespace {

Vector2 PlanOfChoice(const FootholdChoice& choice) { return choice.placed.X_WF.translation().head<2>(); }

class FootholdTableTest : public testing::TestWithParam<const char*> {};

TEST_P(FootholdTableTest, StepsAndAdvancesDivideTheRoute) {
  const Terrain flat = FlatTerrain();
  for (const double length_m : {0.7, 1.0, 2.345}) {
    const SearchRig rig(NamedRobot(GetParam()), flat, "", length_m);
    EXPECT_NEAR(rig.table.num_steps() * rig.table.step_m(), length_m, 1e-9);
    const double advances = length_m / rig.table.advance_m(), parts = rig.table.advance_m() / rig.table.step_m();
    EXPECT_NEAR(advances, std::round(advances), 1e-9);
    EXPECT_NEAR(parts, std::round(parts), 1e-9);
    EXPECT_LE(rig.table.stride_m(), rig.query.stride_m + 1e-9) << "no longer than was asked for";
  }
}

TEST_P(FootholdTableTest, AFootBelongsWhereItStandsUnderTheBase) {
  const RobotModel& model = NamedRobot(GetParam());
  const Terrain flat = FlatTerrain();
  const SearchRig rig(model, flat, "", 1.0);
  const std::vector<Pose> standing = StandingFeet(model);
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    const Vector3 p = standing[static_cast<std::size_t>(foot)].translation();
    for (const double station_m : {0.0, 0.4, 1.0}) {
      const PlanarPose place = rig.table.PlaceAt(foot, station_m);
      EXPECT_NEAR(place.x_m, p.x() + station_m, 1e-9);
      EXPECT_NEAR(place.y_m, p.y(), 1e-9);
    }
    const PlanarPose last = rig.table.PlaceAtStep(foot, rig.table.num_steps());
    EXPECT_NEAR(last.x_m, p.x() + 1.0, 1e-9);
  }
}

TEST_P(FootholdTableTest, OnLevelGroundTheFootsOwnPlaceIsTheFirst) {
  const Terrain flat = FlatTerrain();
  SearchRig rig(NamedRobot(GetParam()), flat, "", 1.0);
  for (const int step : {1, rig.table.num_steps() / 2}) {
    const std::vector<int>& near = rig.table.Near(0, step);
    ASSERT_FALSE(near.empty());
    const FootholdChoice& own = rig.table[near.front()];
    EXPECT_NEAR(own.departure_m, 0.0, 1e-6);
    EXPECT_NEAR(own.station_m, step * rig.table.step_m(), 0.26 * rig.table.step_m());
    EXPECT_FALSE(own.goal);
    EXPECT_EQ(own.placed.foot, 0);
  }
}

TEST_P(FootholdTableTest, ChoicesAreDistinctAndNoFartherThanTheOffset) {
  const Terrain stones = Stones(0.3, 3.0, 0.2, 0.25, 0.02, 1.2, 0.02, 11);
  SearchRig rig(NamedRobot(GetParam()), stones, "", 1.5);
  int found = 0;
  for (int step = 0; step <= rig.table.num_steps(); ++step) {
    const std::vector<int> near = rig.table.Near(1, step);
    const PlanarPose& place = rig.table.PlaceAtStep(1, step);
    for (std::size_t i = 0; i < near.size(); ++i) {
      const Vector2 p = PlanOfChoice(rig.table[near[i]]);
      EXPECT_LE((p - Vector2(place.x_m, place.y_m)).norm(), rig.table.offset_m() + 2e-3);
      for (std::size_t j = 0; j < i; ++j) EXPECT_GT((PlanOfChoice(rig.table[near[j]]) - p).norm(), 1e-4);
    }
    found += static_cast<int>(near.size());
    EXPECT_EQ(rig.table.Near(1, step), near) << "the same when asked again";
  }
  EXPECT_GT(found, 20);
}

TEST_P(FootholdTableTest, AtTheRoutesEndTheFootsPlaceIsAGoal) {
  const Terrain flat = FlatTerrain();
  SearchRig rig(NamedRobot(GetParam()), flat, "", 1.0);
  for (int foot = 0; foot < static_cast<int>(rig.start.size()); ++foot) {
    const std::vector<int>& near = rig.table.Near(foot, rig.table.num_steps());
    ASSERT_FALSE(near.empty());
    EXPECT_TRUE(rig.table[near.front()].goal);
    EXPECT_NEAR(rig.table[near.front()].station_m, 1.0, 1e-12);
    for (const int index : rig.table.Near(foot, 1)) EXPECT_FALSE(rig.table[index].goal);
  }
}

TEST_P(FootholdTableTest, FaultsAreCountedOnceThePlacesAreLookedAt) {
  const Terrain gap = Gap(0.5, 0.6);
  SearchRig rig(NamedRobot(GetParam()), gap, "", 1.5);
  const Vector3 p = StandingFeet(rig.model)[0].translation();
  const int step = static_cast<int>(std::lround((0.8 - p.x()) / rig.table.step_m()));  // over the gap's middle
  const auto count = [&](FootholdFault fault) { return rig.table.FaultsAt(0, step)[static_cast<std::size_t>(fault)]; };
  EXPECT_EQ(count(FootholdFault::kNoGround), 0);
  EXPECT_TRUE(rig.table.Near(0, step).empty());
  EXPECT_GT(count(FootholdFault::kNoGround), 0);
  EXPECT_EQ(count(FootholdFault::kNone), 0);
}

TEST_P(FootholdTableTest, AtTheStartEachFootStandsAtStationZero) {
  const Terrain flat = FlatTerrain();
  SearchRig rig(NamedRobot(GetParam()), flat, "", 1.0);
  for (std::size_t foot = 0; foot < rig.start.size(); ++foot) {
    const FootholdChoice& choice = rig.table[rig.start[foot]];
    EXPECT_EQ(choice.placed.foot, static_cast<int>(foot));
    EXPECT_EQ(choice.station_m, 0.0);
    EXPECT_EQ(choice.departure_m, 0.0);
    EXPECT_FALSE(choice.outline_W.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, FootholdTableTest, testing::Values("a1", "nao"));

TEST(FootholdTable, AFootWithoutGroundAtTheStartHasItsFault) {
  const RobotModel& a1 = NamedRobot("a1");
  const Terrain nothing = Gap(-9.0, 18.0), flat = FlatTerrain();
  const SearchRig on_flat(a1, flat, "", 1.0);
  const GroundIndex ground(nothing, 0.2);
  const FootholdChecker checker(a1, ground, {});
  FootholdTable table(a1, checker, on_flat.query, {});
  int index = -7;
  EXPECT_EQ(table.Start(0, index).fault, FootholdFault::kNoGround);
  EXPECT_EQ(index, -7) << "there is no foothold to be told";
}

}  // namespace
}  // namespace gaitwright
