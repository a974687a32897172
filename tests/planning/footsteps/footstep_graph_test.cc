// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/footstep_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/named_robot.h"
#include "tests/planning/footsteps/grounds.h"
#include "tests/planning/footsteps/search_rig.h"
#include "tests/planning/paths/walled_grounds.h"

namespace gaitwright {
namespace {

std::vector<FootstepGraph::Edge> StepsFrom(SearchRig& rig, int stance) {
  std::vector<FootstepGraph::Edge> edges;
  rig.graph.Steps(stance, edges);
  return edges;
}

class FootstepGraphTest : public testing::TestWithParam<const char*> {};

TEST_P(FootstepGraphTest, EqualFootholdsAndGroupAreOneStance) {
  const Terrain flat = FlatTerrain();
  SearchRig rig(NamedRobot(GetParam()), flat, "", 1.0);
  const int start = rig.graph.StanceOf(rig.start, 0);
  EXPECT_EQ(rig.graph.StanceOf(rig.start, 0), start);
  EXPECT_NE(rig.graph.StanceOf(rig.start, 1), start);
  EXPECT_EQ(rig.graph.size(), 2);
  EXPECT_EQ(rig.graph.GroupOf(start), 0);
  const std::span<const int> footholds = rig.graph.FootholdsOf(start);
  EXPECT_TRUE(std::equal(footholds.begin(), footholds.end(), rig.start.begin(), rig.start.end()));
}

TEST_P(FootstepGraphTest, StancesAreFoundAgainHoweverManyThereAre) {
  const Terrain rough = Stones(0.3, 3.0, 0.25, 0.27, 0.01, 1.4, 0.01, 2);
  SearchRig rig(NamedRobot(GetParam()), rough, "", 2.0);
  rig.graph.StanceOf(rig.start, 0);
  for (int stance = 0; stance < rig.graph.size() && rig.graph.size() < 5000; ++stance) StepsFrom(rig, stance);
  const int count = rig.graph.size();
  ASSERT_GT(count, 1000);
  for (int stance = 0; stance < count; stance += 7) {
    const std::span<const int> footholds = rig.graph.FootholdsOf(stance);
    const std::vector<int> copy(footholds.begin(), footholds.end());
    EXPECT_EQ(rig.graph.StanceOf(copy, rig.graph.GroupOf(stance)), stance);
  }
  EXPECT_EQ(rig.graph.size(), count) << "none is made twice";
}

TEST_P(FootstepGraphTest, AStepMovesTheFeetOfItsGroupAndNoOthers) {
  const Terrain flat = FlatTerrain();
  SearchRig rig(NamedRobot(GetParam()), flat, "", 1.0);
  const int groups = static_cast<int>(rig.graph.groups().size());
  ASSERT_GT(groups, 1);
  for (int group = 0; group < groups; ++group) {
    const int stance = rig.graph.StanceOf(rig.start, group);
    const std::vector<FootstepGraph::Edge> edges = StepsFrom(rig, stance);
    ASSERT_FALSE(edges.empty());
    const std::vector<int>& moving = rig.graph.groups()[static_cast<std::size_t>(group)];
    for (const FootstepGraph::Edge& edge : edges) {
      EXPECT_EQ(rig.graph.GroupOf(edge.to), (group + 1) % groups);
      EXPECT_GE(edge.cost, 1.0) << "each step costs one or more";
      for (int foot = 0; foot < static_cast<int>(rig.start.size()); ++foot) {
        if (std::find(moving.begin(), moving.end(), foot) != moving.end()) continue;
        EXPECT_EQ(rig.graph.FootholdsOf(edge.to)[static_cast<std::size_t>(foot)],
                  rig.start[static_cast<std::size_t>(foot)]);
      }
    }
  }
}

TEST_P(FootstepGraphTest, NoStepIsLongerThanTheLegsAllow) {
  const Terrain flat = FlatTerrain();
  FootstepSearchOptions options;
  options.step_length = 0.3;
  SearchRig rig(NamedRobot(GetParam()), flat, "", 2.0, options);
  const int stance = rig.graph.StanceOf(rig.start, 0);
  double longest = 0.0;
  for (const FootstepGraph::Edge& edge : StepsFrom(rig, stance)) {
    for (std::size_t foot = 0; foot < rig.start.size(); ++foot) {
      const Vector3 moved = rig.table[rig.graph.FootholdsOf(edge.to)[foot]].placed.X_WF.translation() -
                            rig.table[rig.start[foot]].placed.X_WF.translation();
      longest = std::max(longest, moved.head<2>().norm());
    }
  }
  EXPECT_LE(longest, 0.3 * rig.model.leg_length_m() + 1e-9);
  EXPECT_GT(longest, 0.2 * rig.model.leg_length_m());
}

TEST_P(FootstepGraphTest, AtTheStartAllOfTheRouteIsLeftForEachGroup) {
  const Terrain flat = FlatTerrain();
  SearchRig rig(NamedRobot(GetParam()), flat, "", 1.2);
  const int start = rig.graph.StanceOf(rig.start, 0);
  EXPECT_EQ(rig.graph.Progress(start), 0.0);
  EXPECT_FALSE(rig.graph.IsGoal(start));
  const double groups = static_cast<double>(rig.graph.groups().size());
  EXPECT_NEAR(rig.graph.Heuristic(start), groups * 1.2 / rig.table.stride_m(), 1e-9);
}

TEST_P(FootstepGraphTest, StandingAtTheEndIsTheGoalAndNothingIsLeft) {
  const Terrain flat = FlatTerrain();
  SearchRig rig(NamedRobot(GetParam()), flat, "", 1.0);
  std::vector<int> end;
  for (int foot = 0; foot < static_cast<int>(rig.start.size()); ++foot)
    end.push_back(rig.table.Near(foot, rig.table.num_steps()).front());
  const int stance = rig.graph.StanceOf(end, 0);
  EXPECT_TRUE(rig.graph.IsGoal(stance));
  EXPECT_EQ(rig.graph.Heuristic(stance), 0.0);
  EXPECT_NEAR(rig.graph.Progress(stance), 1.0, 1e-9);
  EXPECT_TRUE(rig.graph.Holds(stance));
}

TEST_P(FootstepGraphTest, AStanceIsCheckedOnce) {
  const Terrain flat = FlatTerrain();
  SearchRig rig(NamedRobot(GetParam()), flat, "", 1.0);
  const int start = rig.graph.StanceOf(rig.start, 0);
  EXPECT_EQ(rig.graph.checked(), 0);
  EXPECT_EQ(rig.graph.FaultOf(start), StanceFault::kNone);
  EXPECT_TRUE(rig.graph.Holds(start));
  EXPECT_EQ(rig.graph.checked(), 1);
}

INSTANTIATE_TEST_SUITE_P(Robots, FootstepGraphTest, testing::Values("a1", "nao"));

/// The foothold of the first foot nearest to a distance in front of its start.
const FootholdChoice& ChoiceInFront(SearchRig& rig, double forward_m) {
  const int step = static_cast<int>(std::lround(forward_m / rig.table.step_m()));
  return rig.table[rig.table.Near(0, step).front()];
}

TEST(FootstepGraph, TheRiseBetweenFootholdsIsThatOfTheGroundBetweenThem) {
  const RobotModel& a1 = NamedRobot("a1");
  const Terrain flat = FlatTerrain();
  SearchRig level(a1, flat, "trot", 1.0);
  const FootholdChoice from = level.table[level.start[0]];
  EXPECT_EQ(level.graph.RiseBetween(from, ChoiceInFront(level, 0.3)), 0.0);
  const double x = from.placed.X_WF.translation().x();
  Terrain ridged = flat;
  ridged.patches.push_back(Rectangle("ridge", {x + 0.13, -1.0}, {x + 0.17, 1.0}, 0.2));
  SearchRig rig(a1, ridged, "trot", 1.0);
  const FootholdChoice to = ChoiceInFront(rig, 0.3);
  EXPECT_NEAR(to.placed.X_WF.translation().z(), 0.0, 1e-9);
  EXPECT_NEAR(rig.graph.RiseBetween(rig.table[rig.start[0]], to), 0.2, 1e-9);
  EXPECT_NEAR(rig.graph.RiseBetween(to, rig.table[rig.start[0]]), 0.2, 1e-9) << "there and back";
}

TEST(FootstepGraph, RefusalsNameWhatBlocksTheStep) {
  const RobotModel& a1 = NamedRobot("a1");
  const auto refusals = [&](const Terrain& terrain) {
    SearchRig rig(a1, terrain, "trot", 2.0);
    std::vector<FootstepGraph::Edge> edges;
    FootstepGraph::Refusals refused;
    rig.graph.Steps(rig.graph.StanceOf(rig.start, 0), edges, &refused);
    return refused;
  };
  const FootstepGraph::Refusals on_flat = refusals(FlatTerrain());
  EXPECT_EQ(on_flat.no_foothold + on_flat.too_high + on_flat.riser + on_flat.obstacle, 0);
  EXPECT_GT(on_flat.too_long, 0) << "steps are looked at until they are too long";
  EXPECT_GT(refusals(Gap(0.35, 1.0)).no_foothold, 0);
  EXPECT_GT(refusals(StepUp(0.35, 0.25)).too_high, 0);
  EXPECT_GT(refusals(Walled({Wall("wall", {0.35, -1.0}, {0.35, 1.0}, 0.02)})).obstacle, 0);
}

}  // namespace
}  // namespace gaitwright
