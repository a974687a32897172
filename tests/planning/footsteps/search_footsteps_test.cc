// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/search_footsteps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <queue>
#include <set>

#include "grounds.h"
#include "kinematics/ik/leg_workspace.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"
#include "planning/footsteps/footstep_graph.h"
#include "planning/gait/find_gait.h"
#include "planning/paths/standing_feet.h"
#include "synthetic_walker.h"

namespace gaitwright {
namespace {

FootstepQuery Forward(const RobotModel& model, const char* gait, double length_m, double speed_m_s) {
  const Gait found = FindGait(model, gait, speed_m_s, {}).value();
  return {found, RouteAlong({length_m, 0.0, 0.0}, 0.2), speed_m_s * found.cycle_s};
}

/// The graph of a search, to be explored by other methods.
struct Graph {
  Graph(const RobotModel& the_model, const Terrain& terrain, const FootstepQuery& the_query,
        const FootstepSearchOptions& the_options)
      : query(the_query),
        options(the_options),
        ground(terrain, 0.5 * the_model.leg_length_m()),
        checker(the_model, ground, {}),
        table(the_model, checker, query, options),
        stances(the_model, ground, query, {}, options),
        graph(the_model, query, table, stances, ground, options),
        start(the_model.feet.size()) {
    for (int foot = 0; foot < static_cast<int>(start.size()); ++foot)
      EXPECT_TRUE(table.Start(foot, start[static_cast<std::size_t>(foot)]).ok());
  }
  Graph(const Graph&) = delete;

  FootstepQuery query;
  FootstepSearchOptions options;
  GroundIndex ground;
  FootholdChecker checker;
  FootholdTable table;
  StanceChecker stances;
  FootstepGraph graph;
  std::vector<int> start;
};

/// The smallest cost, found by exploring all stances in the order of their cost (Dijkstra), without a heuristic.
double LeastCost(Graph& g) {
  std::vector<double> cost;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto offer = [&](int stance, double through) {
    cost.resize(static_cast<std::size_t>(g.graph.size()), std::numeric_limits<double>::infinity());
    if (through >= cost[static_cast<std::size_t>(stance)]) return;
    cost[static_cast<std::size_t>(stance)] = through;
    queue.emplace(through, stance);
  };
  for (int group = 0; group < static_cast<int>(g.graph.groups().size()); ++group)
    offer(g.graph.StanceOf(g.start, group), 0.0);
  std::vector<FootstepGraph::Edge> edges;
  while (!queue.empty()) {
    const auto [through, stance] = queue.top();
    queue.pop();
    if (through > cost[static_cast<std::size_t>(stance)] || !g.graph.Holds(stance)) continue;
    if (g.graph.IsGoal(stance)) return through;
    g.graph.Steps(stance, edges);
    for (const FootstepGraph::Edge& edge : edges) offer(edge.to, through + edge.cost);
  }
  return std::numeric_limits<double>::infinity();
}

TEST(SearchFootsteps, GaitsWithFlightStepFarther) {
  const RobotModel model = LoadNamedRobot("a1").value();
  const Terrain gap = Gap(0.4, 0.3);
  const auto found = SearchFootsteps(model, gap, Forward(model, "bound", 1.4, 0.8), {}, {});
  ASSERT_TRUE(found.ok()) << found.failure().message;
  EXPECT_FALSE(SearchFootsteps(model, gap, Forward(model, "trot", 1.4, 0.8), {}, {}).ok());
  FootstepSearchOptions short_leaps;
  short_leaps.leap_length = short_leaps.step_length;
  EXPECT_FALSE(SearchFootsteps(model, gap, Forward(model, "bound", 1.4, 0.8), {}, short_leaps).ok());
}

TEST(FootGroups, AreTheFeetThatLiftTogetherInTheirOrder) {
  const RobotModel a1 = LoadNamedRobot("a1").value(), nao = LoadNamedRobot("nao").value();
  using Groups = std::vector<std::vector<int>>;
  EXPECT_EQ(FootGroups(FindGait(a1, "trot", 0.3, {}).value()), (Groups{{1, 2}, {0, 3}}));
  EXPECT_EQ(FootGroups(FindGait(a1, "pace", 0.3, {}).value()).size(), 2U);
  EXPECT_EQ(FootGroups(FindGait(a1, "crawl", 0.3, {}).value()).size(), 4U);
  EXPECT_EQ(FootGroups(FindGait(nao, "", 0.05, {}).value()).size(), 2U);
}

TEST(SearchFootsteps, ItsBoundHoldsAgainstAnExhaustiveSearch) {
  struct Case {
    const char* robot;
    const char* gait;
    double length_m, speed_m_s;
    Terrain terrain;
  };
  const Case cases[] = {{"nao", "", 0.2, 0.04, StepUp(0.17, 0.02)},
                        {"nao", "", 0.2, 0.04, Gap(0.15, 0.04)},
                        {"a1", "trot", 0.3, 0.25, Gap(0.3, 0.06)}};
  for (const Case& c : cases) {
    const RobotModel model = LoadNamedRobot(c.robot).value();
    const FootstepQuery query = Forward(model, c.gait, c.length_m, c.speed_m_s);
    FootstepSearchOptions options;
    options.step_length = 0.5;
    options.offset = 0.1;
    Graph graph(model, c.terrain, query, options);
    const double least = LeastCost(graph);
    ASSERT_LT(least, 1e6) << c.robot;
    for (const double first : {1.0, 2.0, 5.0}) {
      options.first_bound = first;
      for (const int improving : {0, 100, 1000000}) {
        options.improving_expansions = improving;
        options.bound = 1.0;
        options.max_expansions = 1000000;
        const auto found = SearchFootsteps(model, c.terrain, query, {}, options);
        ASSERT_TRUE(found.ok()) << found.failure().message;
        const FootstepSearchStats& stats = found->stats;
        EXPECT_GE(stats.cost, least - 1e-9);
        EXPECT_LE(stats.cost, stats.bound * least + 1e-9) << c.robot << " first bound " << first;
        EXPECT_LE(stats.cost, stats.first_cost + 1e-12);
        EXPECT_GE(stats.expanded, stats.expanded_to_first);
        if (improving == 1000000) {
          EXPECT_NEAR(stats.cost, least, 1e-6 * least) << c.robot;
        }
      }
    }
  }
}

TEST(SearchFootsteps, TheHeuristicIsConsistent) {
  const RobotModel model = LoadNamedRobot("a1").value();
  const Terrain stones = Stones(0.4, 1.6, 0.12, 0.16, 0.01, 1.0, 0.02, 4);
  for (const char* gait : {"trot", "crawl"}) {
    const FootstepQuery query = Forward(model, gait, 1.2, 0.3);
    Graph g(model, stones, query, {});
    std::vector<int> fringe = {g.graph.StanceOf(g.start, 0)};
    std::vector<FootstepGraph::Edge> edges;
    int looked = 0;
    for (int round = 0; round < 40 && !fringe.empty(); ++round) {
      // Stances spread over all that were found, valid or not.
      const int stance = fringe[static_cast<std::size_t>(round * 7919) % fringe.size()];
      const double left = g.graph.Heuristic(stance);
      if (g.graph.IsGoal(stance)) {
        EXPECT_EQ(left, 0.0);
      }
      g.graph.Steps(stance, edges);
      for (const FootstepGraph::Edge& edge : edges) {
        EXPECT_LE(left, edge.cost + g.graph.Heuristic(edge.to) + 1e-9);
        fringe.push_back(edge.to);
        ++looked;
      }
    }
    EXPECT_GT(looked, 1000);
  }
}

/// Checks every requirement on a sequence of footfalls with independent code.
void ExpectSound(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query,
                 const FootstepSequence& sequence) {
  const FootstepSearchOptions options;
  const GroundIndex ground(terrain, 0.5 * model.leg_length_m());
  const FootholdChecker checker(model, ground, {});
  StanceChecker stances(model, ground, query, {}, options);
  const auto groups = FootGroups(query.gait);
  std::vector<Pose> feet;
  for (const PlacedFoot& placed : sequence.start) feet.push_back(placed.X_WF);
  std::size_t next = groups.size();
  for (const Footfalls& step : sequence.steps) {
    for (std::size_t g = 0; next == groups.size() && g < groups.size(); ++g)
      if (groups[g].front() == step.front().foot) next = g;
    ASSERT_EQ(step.size(), groups[next].size());
    for (std::size_t m = 0; m < step.size(); ++m) {
      const PlacedFoot& placed = step[m];
      ASSERT_EQ(placed.foot, groups[next][m]);
      const Vector3 p = placed.X_WF.translation();
      const Placing again = checker.Place(placed.foot, {p.x(), p.y(), YawOf(placed.X_WF.linear())});
      ASSERT_TRUE(again.ok()) << Describe(again.fault) << " at " << p.transpose();
      EXPECT_LT((again.placed.X_WF.matrix() - placed.X_WF.matrix()).norm(), 1e-9);
      Pose& foot = feet[static_cast<std::size_t>(placed.foot)];
      EXPECT_LE(std::abs(p.z() - foot.translation().z()), options.step_height * model.leg_length_m() + 1e-9);
      EXPECT_LE((p - foot.translation()).head<2>().norm(), options.step_length * model.leg_length_m() + 1e-9);
      foot = placed.X_WF;
    }
    next = (next + 1) % groups.size();
    std::vector<Polygon> outlines;
    std::vector<const Polygon*> each;
    for (std::size_t f = 0; f < feet.size(); ++f) {
      const Vector3 p = feet[f].translation();
      outlines.push_back(checker.OutlineAt(static_cast<int>(f), {p.x(), p.y(), YawOf(feet[f].linear())}));
    }
    for (const Polygon& outline : outlines) each.push_back(&outline);
    const StanceFault fault = stances.Check(feet, each);
    EXPECT_EQ(fault, StanceFault::kNone) << Describe(fault);
  }
  const std::vector<Pose> standing = StandingFeet(model);
  for (std::size_t f = 0; f < feet.size(); ++f) {
    const Vector3 wanted = Carried(query.route.pose.back(), standing[f]).translation();
    EXPECT_LE((feet[f].translation() - wanted).head<2>().norm(), options.goal_tolerance * model.leg_length_m() + 1e-9);
  }
}

/// Random grounds for a robot of some size, from easy to too hard.
Terrain SeededGround(std::uint64_t seed, double leg_m, double sole_m) {
  const double hard = 0.2 + 0.3 * static_cast<double>(seed % 5U), from = 1.6 * leg_m, to = 5.0 * leg_m;
  const double stone = sole_m + 0.3 * leg_m;
  switch (seed % 6U) {
    case 0:
      return Stones(from, to, stone, stone + 0.1 * hard * leg_m, 0.05 * hard * leg_m, 4.0 * leg_m, 0.04 * hard * leg_m,
                    seed);
    case 1:
      return StairsUpAndDown(from, 0.2 * hard * leg_m, sole_m + 0.6 * leg_m, 3);
    case 2:
      return Gap(from, 0.8 * hard * leg_m);
    case 3:
      return Rough(-2.0, 6.0, 0.05 * hard * leg_m, 1.0 * leg_m, seed);
    case 4:
      return RampUp(from, 3.0 * leg_m, 0.35 * hard);
    default:
      return WallWithOpening(to, (1.0 + 2.0 * hard) * leg_m, 2.0 * leg_m);
  }
}

void WalkSeededGrounds(const char* robot, const char* gait, double speed_m_s, double sole_m) {
  const RobotModel model = LoadNamedRobot(robot).value();
  const double leg = model.leg_length_m();
  const FootstepQuery query = Forward(model, gait, 7.0 * leg, speed_m_s);
  FootstepSearchOptions options;
  options.max_expansions = 1000;
  int found = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(testing::Message() << robot << " seed " << seed);
    const Terrain terrain = SeededGround(seed, leg, sole_m);
    const auto sequence = SearchFootsteps(model, terrain, query, {}, options);
    if (sequence.ok()) {
      ++found;
      ExpectSound(model, terrain, query, *sequence);
      continue;
    }
    EXPECT_EQ(sequence.failure().code, FailureCode::kNoFootholds);
    EXPECT_NE(sequence.failure().message.find("x = "), std::string::npos) << sequence.failure().message;
  }
  EXPECT_GE(found, 18);
  EXPECT_LE(found, 49);
}

TEST(SearchFootsteps, EveryRouteOfAQuadrupedKeepsAllConstraints) { WalkSeededGrounds("a1", "trot", 0.3, 0.04); }
TEST(SearchFootsteps, EveryRouteOfACrawlKeepsAllConstraints) { WalkSeededGrounds("a1", "crawl", 0.15, 0.04); }
TEST(SearchFootsteps, EveryRouteOfABipedKeepsAllConstraints) { WalkSeededGrounds("nao", "", 0.05, 0.16); }

TEST(SearchFootsteps, SixLegsStepOverAGap) {
  const RobotModel model = Walker(3);
  const FootstepQuery query = Forward(model, "tripod", 1.6, 0.3);
  const Terrain terrain = Gap(0.7, 0.1);
  const auto sequence = SearchFootsteps(model, terrain, query, {}, {});
  ASSERT_TRUE(sequence.ok()) << sequence.failure().message;
  ExpectSound(model, terrain, query, *sequence);
}

TEST(SearchFootsteps, KeepsTheGaitsOwnStepsOnLevelGround) {
  const RobotModel model = LoadNamedRobot("a1").value();
  const FootstepQuery query = Forward(model, "trot", 2.0, 0.3);
  Terrain terrain = FlatTerrain();
  terrain.patches.push_back(Rectangle("aside", {0.0, 5.0}, {1.0, 6.0}, 0.1));
  const auto sequence = SearchFootsteps(model, terrain, query, {}, {});
  ASSERT_TRUE(sequence.ok());
  const double stride = 2.0 / std::ceil(2.0 / query.stride_m * 2.0) * 2.0;
  int regular = 0, all = 0;
  std::vector<Pose> feet;
  for (const PlacedFoot& placed : sequence->start) feet.push_back(placed.X_WF);
  for (const Footfalls& step : sequence->steps) {
    for (const PlacedFoot& placed : step) {
      Pose& foot = feet[static_cast<std::size_t>(placed.foot)];
      const double length = placed.X_WF.translation().x() - foot.translation().x();
      regular += std::abs(length - stride) < 1e-9 || std::abs(length - 0.5 * stride) < 1e-9 ? 1 : 0;
      ++all;
      EXPECT_NEAR(placed.X_WF.translation().y(), foot.translation().y(), 1e-12);
      foot = placed.X_WF;
    }
  }
  EXPECT_GE(regular, 0.7 * all);
}

TEST(SearchFootsteps, GivesTheSameFootfallsAgain) {
  const RobotModel model = LoadNamedRobot("a1").value();
  const FootstepQuery query = Forward(model, "crawl", 2.5, 0.2);
  const Terrain terrain = Stones(0.5, 2.0, 0.12, 0.17, 0.015, 1.2, 0.02, 1);
  const auto a = SearchFootsteps(model, terrain, query, {}, {}), b = SearchFootsteps(model, terrain, query, {}, {});
  ASSERT_TRUE(a.ok() && b.ok());
  ASSERT_EQ(a->steps.size(), b->steps.size());
  EXPECT_EQ(a->stats.expanded, b->stats.expanded);
  for (std::size_t k = 0; k < a->steps.size(); ++k)
    for (std::size_t m = 0; m < a->steps[k].size(); ++m)
      EXPECT_EQ(a->steps[k][m].X_WF.matrix(), b->steps[k][m].X_WF.matrix());
}

TEST(SearchFootsteps, KeptWorkspacesOfLegsChangeNothing) {
  const RobotModel model = LoadNamedRobot("nao").value();
  const Terrain terrain = StepUp(0.3, 0.02);
  FootstepSearchOptions keeps;
  keeps.workspaces = std::make_shared<LegWorkspaces>();
  const auto own = SearchFootsteps(model, terrain, Forward(model, "", 0.6, 0.05), {}, {});
  for (const double speed_m_s : {0.06, 0.05}) {
    const auto kept = SearchFootsteps(model, terrain, Forward(model, "", 0.6, speed_m_s), {}, keeps);
    ASSERT_TRUE(own.ok() && kept.ok());
    if (speed_m_s == 0.06) continue;
    EXPECT_EQ(own->stats.expanded, kept->stats.expanded);
    EXPECT_EQ(own->stats.cost, kept->stats.cost);
  }
  EXPECT_GT(keeps.workspaces->Of(model, 0, keeps.reserve).size(), 10);
}

std::string Refusal(const char* robot, const Terrain& terrain, double length_m, double speed_m_s) {
  const RobotModel model = LoadNamedRobot(robot).value();
  FootstepSearchOptions options;
  options.max_expansions = 2000;
  const auto found =
      SearchFootsteps(model, terrain, Forward(model, robot[0] == 'a' ? "trot" : "", length_m, speed_m_s), {}, options);
  return found ? "found a way" : found.failure().message;
}

TEST(SearchFootsteps, RefusalsNameThePlaceAndTheReason) {
  const auto starts = [](const std::string& text, const std::string& start) {
    EXPECT_EQ(text.substr(0, start.size()), start) << text;
  };
  starts(Refusal("nao", Gap(0.4, 0.5), 1.2, 0.05), "the gap at x = 0.40 m is 0.50 m wide; nao reaches 0.08 m");
  starts(Refusal("a1", StepUp(0.7, 0.2), 2.0, 0.3), "step up of 0.20 m at x = 0.70 m; a1 lifts its feet 0.13 m");
  starts(Refusal("a1", StepUp(0.7, -0.2), 2.0, 0.3), "step down of 0.20 m at x = 0.70 m; a1 lifts its feet 0.13 m");
  starts(Refusal("a1", RampUp(0.7, 0.6, 0.7), 2.0, 0.3),
         "slope of 40 degrees at x = 0.70 m; footholds need at most 30 degrees");
  EXPECT_NE(Refusal("a1", WallWithOpening(1.0, 0.2, 1.0), 2.0, 0.3).find("no room between '"), std::string::npos);
  Terrain ledge;
  ledge.patches = {Rectangle("ledge", {-1.0, -1.0}, {0.8, 1.0}, 0.0)};
  starts(Refusal("a1", ledge, 2.0, 0.3), "the ground ends at x = 0.80 m");
  starts(Refusal("a1", Gap(-0.3, 0.5), 2.0, 0.3), "foot 'FL_foot' cannot stand at the start");
}

TEST(SearchFootsteps, WhatIsTooWideToStepOverIsToBeLeaptOverAndNotSearchedForLonger) {
  const auto hints = [](const char* robot, const char* gait, const Terrain& terrain) {
    const RobotModel model = LoadNamedRobot(robot).value();
    FootstepSearchOptions options;
    options.max_expansions = 2000;
    const auto searched = SearchFootsteps(model, terrain, Forward(model, gait, 2.0, 0.1), {}, options);
    std::vector<std::string> options_named;
    for (const Suggestion& suggestion : searched.failure().suggestions) options_named.push_back(suggestion.what);
    return options_named;
  };
  using Hints = std::vector<std::string>;
  EXPECT_EQ(hints("a1", "trot", Gap(0.8, 0.4)), Hints{"gait"});
  EXPECT_EQ(hints("a1", "trot", Gap(0.8, 1.2)), Hints{}) << "no leap is as wide";
  EXPECT_EQ(hints("nao", "", Gap(0.4, 0.3)), Hints{});
  EXPECT_EQ(hints("a1", "trot", StepUp(0.7, 0.2)), Hints{"footsteps.search.step_height"});
}

TEST(SearchFootsteps, ABodyThatMayNotPassIsKeptBack) {
  const RobotModel model = LoadNamedRobot("a1").value();
  FootstepQuery query = Forward(model, "trot", 1.0, 0.3);
  FootstepSearchOptions options;
  options.max_expansions = 1000;
  query.body_free = [](const PlanarPose& base, double) { return base.x_m < 0.5; };
  EXPECT_FALSE(SearchFootsteps(model, FlatTerrain(), query, {}, options).ok());
  query.body_free = [](const PlanarPose&, double ground_m) { return ground_m == 0.0; };
  EXPECT_TRUE(SearchFootsteps(model, FlatTerrain(), query, {}, options).ok());
}

TEST(SearchFootsteps, RefusesQueriesThatMakeNoSense) {
  const RobotModel model = LoadNamedRobot("a1").value();
  FootstepQuery query = Forward(model, "trot", 1.0, 0.3);
  query.stride_m = 0.0;
  EXPECT_EQ(SearchFootsteps(model, FlatTerrain(), query, {}, {}).failure().kind, FailureKind::kBadInput);
  query = Forward(model, "trot", 1.0, 0.3);
  query.gait.phase.pop_back();
  EXPECT_EQ(SearchFootsteps(model, FlatTerrain(), query, {}, {}).failure().kind, FailureKind::kBadInput);
  FootstepSearchOptions options;
  options.bound = 0.5;
  EXPECT_THROW((void)SearchFootsteps(model, FlatTerrain(), Forward(model, "trot", 1.0, 0.3), {}, options),
               InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
