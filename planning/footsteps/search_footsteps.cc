// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/search_footsteps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>

#include "kinematics/base/non_finite.h"
#include "planning/footsteps/explain_blockage.h"
#include "planning/footsteps/foothold_table.h"
#include "planning/footsteps/footstep_graph.h"
#include "planning/footsteps/search_beside_goal.h"
#include "planning/footsteps/stance_check.h"

namespace gaitwright {
namespace {

/// Anytime search over the stances of a graph.
class AnytimeSearch {
 public:
  AnytimeSearch(FootstepGraph& graph, const FootstepSearchOptions& options) : graph_(graph), options_(options) {}

  /// Stances at which the path may start, at no cost.
  void Start(const std::vector<int>& stances) {
    for (const int stance : stances) {
      Reach(stance, 0.0, -1);
      open_.push_back(stance);
    }
  }

  /// Searches with growing weights until a path is found. Then improves it with shrinking weights until its bound is
  /// small enough or the budget is used up.
  void Run() {
    constexpr double kHarder = 2.0, kEase = 0.5;  // factor of the weight; factor of (weight - 1)
    double weight = options_.first_bound;
    stats_.bound = kInfinity;
    while (true) {
      const bool finished = Improve(weight);
      if (goal_ < 0 && (finished || stats_.expanded >= options_.max_expansions)) return;
      if (goal_ < 0) {
        weight *= kHarder;
        continue;
      }
      stats_.cost = nodes_[Index(goal_)].cost;
      stats_.bound = std::max(1.0, std::min(finished ? weight : stats_.bound, stats_.cost / Least()));
      if (!finished || stats_.bound <= options_.bound || weight <= 1.0) return;
      weight = weight < 1.05 ? 1.0 : std::min(stats_.bound, 1.0 + kEase * (weight - 1.0));
    }
  }

  int goal() const { return goal_; }
  /// The expanded stance with the most progress; -1 if none was expanded.
  int farthest() const { return farthest_; }
  const FootstepSearchStats& stats() const { return stats_; }

  /// Stances from the start to the goal.
  std::vector<int> StancesToGoal() const {
    std::vector<int> stances;
    for (int stance = goal_; stance >= 0; stance = nodes_[Index(stance)].parent) stances.push_back(stance);
    std::reverse(stances.begin(), stances.end());
    return stances;
  }

 private:
  struct Node {
    double cost = kInfinity, left = 0.0;
    int parent = -1;
    int closed_in = -1;  // round of the last expansion
  };
  struct Candidate {
    double key, left;
    int stance;
    bool operator>(const Candidate& other) const {
      return std::tie(key, left, stance) > std::tie(other.key, other.left, other.stance);
    }
  };

  static std::size_t Index(int stance) { return static_cast<std::size_t>(stance); }

  void Reach(int stance, double cost, int parent) {
    if (Index(stance) >= nodes_.size()) nodes_.resize(Index(graph_.size()));
    Node& node = nodes_[Index(stance)];
    if (node.cost == kInfinity) node.left = graph_.Heuristic(stance);
    node.cost = cost;
    node.parent = parent;
  }

  /// One round of weighted A*. @return false if the budget ended it.
  bool Improve(double weight) {
    ++round_;
    expanded_before_ = stats_.expanded;
    queue_ = {};
    std::vector<int> fringe;
    fringe.swap(open_);
    for (const int stance : fringe) Queue(stance, weight);
    bool finished = true;
    while (!queue_.empty()) {
      const Candidate top = queue_.top();
      if (goal_ >= 0 && nodes_[Index(goal_)].cost <= top.key + 1e-12) break;
      if (Spent()) {
        finished = false;
        break;
      }
      queue_.pop();
      const Node& node = nodes_[Index(top.stance)];
      if (node.closed_in == round_ || top.key > node.cost + weight * node.left + 1e-12) continue;
      Visit(top.stance, weight);
    }
    // The remaining states are the fringe of the next round.
    for (; !queue_.empty(); queue_.pop()) {
      const Candidate& top = queue_.top();
      const Node& node = nodes_[Index(top.stance)];
      if (node.closed_in != round_ && top.key <= node.cost + weight * node.left + 1e-12) open_.push_back(top.stance);
    }
    return finished;
  }

  bool Spent() const {
    if (goal_ < 0 && stats_.expanded - expanded_before_ >= options_.patience) return true;
    if (stats_.expanded >= options_.max_expansions) return true;
    return goal_ >= 0 && stats_.expanded - stats_.expanded_to_first >= options_.improving_expansions;
  }

  void Queue(int stance, double weight) {
    const Node& node = nodes_[Index(stance)];
    queue_.push({node.cost + weight * node.left, node.left, stance});
  }

  void Visit(int stance, double weight) {
    nodes_[Index(stance)].closed_in = round_;
    if (!graph_.Holds(stance)) return;
    if (graph_.IsGoal(stance)) {
      if (goal_ < 0) {
        stats_.expanded_to_first = stats_.expanded;
        stats_.first_cost = nodes_[Index(stance)].cost;
      }
      if (goal_ < 0 || nodes_[Index(stance)].cost < nodes_[Index(goal_)].cost) goal_ = stance;
      return;
    }
    ++stats_.expanded;
    if (farthest_ < 0 || graph_.Progress(stance) > graph_.Progress(farthest_) + 1e-9) farthest_ = stance;
    const double cost = nodes_[Index(stance)].cost;
    graph_.Steps(stance, edges_);
    for (const FootstepGraph::Edge& edge : edges_) {
      ++stats_.generated;
      const double through = cost + edge.cost;
      if (Index(edge.to) < nodes_.size() && through >= nodes_[Index(edge.to)].cost - 1e-12) continue;
      Reach(edge.to, through, stance);
      if (nodes_[Index(edge.to)].closed_in == round_) {
        open_.push_back(edge.to);  // expanded again in the next round
      } else {
        Queue(edge.to, weight);
      }
    }
  }

  /// Lower bound of the cost of all paths not yet seen.
  double Least() const {
    double least = nodes_[Index(goal_)].cost;
    for (const int stance : open_) least = std::min(least, nodes_[Index(stance)].cost + nodes_[Index(stance)].left);
    return std::max(least, 1e-9);
  }

  FootstepGraph& graph_;
  const FootstepSearchOptions& options_;
  FootstepSearchStats stats_;
  std::vector<Node> nodes_;
  std::vector<int> open_;  // fringe of the next round
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
  std::vector<FootstepGraph::Edge> edges_;
  int round_ = 0, expanded_before_ = 0, goal_ = -1, farthest_ = -1;
};

std::vector<Footfalls> StepsOf(const FootstepGraph& graph, const std::vector<int>& stances) {
  std::vector<Footfalls> steps;
  for (std::size_t k = 0; k + 1 < stances.size(); ++k) {
    Footfalls footfalls;
    for (const int foot : graph.groups()[static_cast<std::size_t>(graph.GroupOf(stances[k]))])
      footfalls.push_back(graph.table()[graph.FootholdsOf(stances[k + 1])[static_cast<std::size_t>(foot)]].placed);
    steps.push_back(std::move(footfalls));
  }
  return steps;
}

std::optional<Failure> CheckQuery(const RobotModel& model, const FootstepQuery& query) {
  const auto bad = [](const std::string& message) {
    return Failure{FailureKind::kBadInput, FailureCode::kFootstepQuery, "SearchFootsteps", message, {}};
  };
  if (query.gait.num_feet() != static_cast<int>(model.feet.size())) {
    return bad(fmt::format("gait '{}' is for {} feet; robot '{}' has {}", query.gait.name, query.gait.num_feet(),
                           model.name, model.feet.size()));
  }
  if (!(query.stride_m > 0.0)) return bad(fmt::format("the stride is {} m; it must be more than 0", query.stride_m));
  if (!(query.route.length_m() > 0.0)) return bad("the route ends where it starts");
  constexpr double kMostStrides = 10000.0;
  if (query.route.length_m() / query.stride_m > kMostStrides) {
    return bad(fmt::format("the route of {:.3g} m takes {:.0f} strides of {:.3g} m; a plan has at most {:.0f}",
                           query.route.length_m(), query.route.length_m() / query.stride_m, query.stride_m,
                           kMostStrides));
  }
  return std::nullopt;
}

/// The options for a gait: in a gait with flight, the body carries the feet along while no foot is on the ground.
FootstepSearchOptions OptionsFor(const Gait& gait, FootstepSearchOptions options) {
  CheckOptions(options.Fields());
  if (!HasFlight(gait)) return options;
  options.step_length = std::max(options.step_length, options.leap_length);
  options.step_height = std::max(options.step_height, options.leap_height);
  return options;
}

/// All data of a search. The members refer to each other, so the object is not movable.
struct Problem {
  Problem(const RobotModel& the_model, const Terrain& terrain, const FootstepQuery& query,
          const FootholdOptions& footholds, const FootstepSearchOptions& the_options, bool beside_goal = false)
      : model(the_model),
        options(OptionsFor(query.gait, the_options)),
        ground(terrain, kCell * model.leg_length_m()),
        checker(model, ground, footholds),
        table(model, checker, query, options, beside_goal),
        stances(model, ground, query, footholds, options),
        graph(model, query, table, stances, ground, options),
        search(graph, options),
        start(model.feet.size()) {}
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  /// Puts the feet down at the start; a failure if they cannot stand there.
  std::optional<Failure> Start() {
    for (int foot = 0; foot < static_cast<int>(start.size()); ++foot) {
      const Placing placing = table.Start(foot, start[static_cast<std::size_t>(foot)]);
      if (placing.ok()) continue;
      const PlanarPose at = table.PlaceAt(foot, 0.0);
      return CannotStart(fmt::format("foot '{}' cannot stand at the start, at x = {:.2f} m, y = {:.2f} m: {}",
                                     model.feet[static_cast<std::size_t>(foot)].name, at.x_m, at.y_m,
                                     Describe(placing.fault)));
    }
    std::vector<int> starts;
    for (int group = 0; group < static_cast<int>(graph.groups().size()); ++group)
      starts.push_back(graph.StanceOf(start, group));
    const StanceFault fault = graph.FaultOf(starts.front());
    if (fault != StanceFault::kNone)
      return CannotStart(fmt::format("robot '{}' cannot stand at the start: {}", model.name, Describe(fault)));
    search.Start(starts);
    return std::nullopt;
  }

  FootstepSequence Found() const {
    FootstepSequence sequence;
    for (const int foothold : start) sequence.start.push_back(table[foothold].placed);
    sequence.steps = StepsOf(graph, search.StancesToGoal());
    sequence.stats = search.stats();
    sequence.stats.stances = graph.checked();
    return sequence;
  }

  static Failure CannotStart(const std::string& message) {
    return {
        FailureKind::kInfeasible, FailureCode::kNoFootholds, "SearchFootsteps", message, {"start at another place"}};
  }

  static constexpr double kCell = 0.5;  // cell size of the ground index, as a share of the leg length
  const RobotModel& model;
  const FootstepSearchOptions options;
  const GroundIndex ground;
  const FootholdChecker checker;
  FootholdTable table;
  StanceChecker stances;
  FootstepGraph graph;
  AnytimeSearch search;
  std::vector<int> start;  // footholds by foot
};

}  // namespace

OptionFields FootstepSearchOptions::Fields() {
  return WithBasics(
      {"step_length", "step_height", "max_expansions"},
      {{"step_length", &step_length, "1", 0.05, 2.0, "Longest step of a foot, as a share of the leg length."},
       {"step_height", &step_height, "1", 0.01, 1.0, "Highest step up or down, as a share of the leg length."},
       {"leap_length", &leap_length, "1", 0.05, 4.0,
        "Longest step of a foot in a gait with flight, as a share of the leg length."},
       {"leap_height", &leap_height, "1", 0.01, 2.0,
        "Highest step up or down in a gait with flight, as a share of the leg length."},
       {"reserve", &reserve, "1", 0.0, 0.2,
        "Margin to joint limits and full leg length, as shares of the joint range and the leg length; 0 in the last "
        "search for robots with soles."},
       {"offset", &offset, "1", 0.02, 1.0,
        "Largest distance of a foothold from its nominal position, as a share of the leg length."},
       {"body_clearance", &body_clearance, "1", 0.0, 0.5,
        "Clearance of the trunk above the ground, as a share of the leg length."},
       {"leg_clearance", &leg_clearance, "1", 0.0, 0.5,
        "Clearance of thighs and shanks above the ground, as a share of the leg length."},
       {"sway", &sway, "1", 0.0, 1.0,
        "Sway of the base towards a sole in single support, as a share of the distance to that sole."},
       {"easy_sway", &easy_sway, "1", 0.0, 1.0,
        "Sway of the base in the first search, which leaves the ankles more room; a second search uses `sway`."},
       {"length_weight", &length_weight, "1", 0.0, 100.0,
        "Cost weight of strides that are longer than the gait's stride."},
       {"phase_weight", &phase_weight, "1", 0.0, 100.0,
        "Cost weight of the deviation of the feet's forward spacing from the gait's spacing."},
       {"departure_weight", &departure_weight, "1", 0.0, 100.0,
        "Cost weight of the distance of footholds from their nominal positions."},
       {"height_weight", &height_weight, "1", 0.0, 100.0, "Cost of a height change of one leg length."},
       {"risk_weight", &risk_weight, "1", 0.0, 100.0, "Cost weight of footholds near edges and on slopes."},
       {"landing_weight", &landing_weight, "1/rad", 0.0, 100.0,
        "Cost weight of the base's tilt after a leap of all feet together."},
       {"goal_tolerance", &goal_tolerance, "1", 0.0, 1.0,
        "Largest distance of the last footholds from their goal positions, as a share of the leg length."},
       {"first_bound", &first_bound, "1", 1.0, 100.0,
        "Heuristic weight of the first search; a larger weight finds a solution sooner, at higher cost."},
       {"patience", &patience, "1", 1.0, 1e8,
        "Expansions without a solution after which the heuristic weight is doubled."},
       {"bound", &bound, "1", 1.0, 100.0,
        "Bound on the ratio of the cost to the optimal cost at which the search ends."},
       {"max_expansions", &max_expansions, "1", 1.0, 1e8,
        "Maximum number of nodes that the whole footstep search expands."},
       {"improving_expansions", &improving_expansions, "1", 0.0, 1e8,
        "Maximum number of expansions spent improving the first solution."}});
}

std::vector<std::vector<int>> FootGroups(const Gait& gait) {
  constexpr double kTogether = 1e-6;  // share of the cycle
  std::vector<double> liftoff;
  for (std::size_t i = 0; i < gait.phase.size(); ++i) {
    const double at = gait.phase[i] + gait.duty_factor[i] + kTogether;
    liftoff.push_back(at - std::floor(at));
  }
  std::vector<int> order(liftoff.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int foot) { return liftoff[static_cast<std::size_t>(foot)]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return at(a) < at(b) - kTogether; });
  std::vector<std::vector<int>> groups;
  for (const int foot : order) {
    if (groups.empty() || at(foot) > at(groups.back().front()) + kTogether) groups.emplace_back();
    groups.back().push_back(foot);
  }
  return groups;
}

Result<FootstepSequence> SearchFootsteps(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query,
                                         const FootholdOptions& footholds, const FootstepSearchOptions& options) {
  if (const auto failure = CheckQuery(model, query)) return *failure;
  Problem problem(model, terrain, query, footholds, options);
  if (auto failure = problem.Start()) return *failure;
  problem.search.Run();
  if (problem.search.goal() < 0) {
    const Blockage blockage{problem.search.farthest(), problem.search.stats().expanded >= options.max_expansions};
    return ExplainBlockage({model, problem.ground, query, problem.checker, problem.options}, problem.graph, blockage);
  }
  return problem.Found();
}

Result<FootstepSequence> SearchBesideGoal(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query,
                                          const FootholdOptions& footholds, const FootstepSearchOptions& options) {
  if (const auto failure = CheckQuery(model, query)) return *failure;
  Problem problem(model, terrain, query, footholds, options, true);
  if (auto failure = problem.Start()) return *failure;
  problem.search.Run();
  if (problem.search.goal() >= 0) return problem.Found();
  return Failure{FailureKind::kInfeasible,
                 FailureCode::kNoFootholds,
                 "SearchFootsteps",
                 "the ground near the goal has no footholds",
                 {}};
}

bool FootstepsExist(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query,
                    const FootholdOptions& footholds, const FootstepSearchOptions& options) {
  if (CheckQuery(model, query)) return false;
  Problem problem(model, terrain, query, footholds, options);
  if (problem.Start()) return false;
  problem.search.Run();
  return problem.search.goal() >= 0;
}

}  // namespace gaitwright
