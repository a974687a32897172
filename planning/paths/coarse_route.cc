// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/coarse_route.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "kinematics/base/non_finite.h"
#include "planning/paths/travel_cost.h"

namespace gaitwright {
namespace {

constexpr double kStepOfLeg = 0.25;        // edge of a cell in leg lengths
constexpr double kFineStepOfLeg = 0.1;     // used to look for a shorter path
constexpr int kMostFineStates = 50000;     // limit of states visited on the fine grid
constexpr double kMostCells = 2e5;         // of the grid; with more, cells become larger
constexpr double kThroughHindrance = 1e4;  // cost of a metre through an obstacle
constexpr int kHeadings = 8;
constexpr double kTurn = 0.25 * std::numbers::pi;  // angle between two headings

/// Limits of a search.
struct Limits {
  bool through = false;                                   // may pass through obstacles
  double cost = std::numeric_limits<double>::infinity();  // largest cost of a path
  int states = std::numeric_limits<int>::max();           // largest number of visited states
};

/// A search over cells. In each cell the body has one of eight headings. A state is cell * kHeadings + heading.
class Grid {
 public:
  Grid(PoseCheck& check, const CoarseProblem& problem, double step_of_leg) : check_(check), problem_(problem) {
    const PlaneExtent& extent = problem.extent;
    const PlanarPose& start = problem.start;
    step_m_ = std::max(step_of_leg * check.space().leg_length_m, std::sqrt(extent.sizes().prod() / kMostCells));
    // The start is at the middle of a cell.
    const Vector2 low = (Vector2(start.x_m, start.y_m) - extent.min()) / step_m_;
    before_ = {static_cast<int>(low.x()), static_cast<int>(low.y())};
    columns_ = before_[0] + 1 + static_cast<int>((extent.max().x() - start.x_m) / step_m_);
    rows_ = before_[1] + 1 + static_cast<int>((extent.max().y() - start.y_m) / step_m_);
    const auto states = static_cast<std::size_t>(columns_ * rows_ * kHeadings);
    holds_.assign(states, kUnknown);
    turns_.assign(states, kUnknown);
  }

  /// The poses of the cheapest path; empty if no path exists.
  std::vector<PlanarPose> Search(const Limits& limits);

 private:
  enum Known : std::uint8_t { kUnknown, kFree, kBlocked };
  struct Move {
    int state = -1;
    double cost = 0.0;
    bool free = false;
  };
  struct Entry {
    double estimate;
    int state;
    bool operator>(const Entry& other) const {
      return estimate != other.estimate ? estimate > other.estimate : state > other.state;
    }
  };
  /// Search data of a state.
  struct Visit {
    double cost = std::numeric_limits<double>::infinity();
    int parent = -1;
    bool done = false;
  };

  PlanarPose PoseOf(int state) const {
    const int cell = state / kHeadings, row = cell / columns_;
    return {problem_.start.x_m + step_m_ * (cell % columns_ - before_[0]),
            problem_.start.y_m + step_m_ * (row - before_[1]), kTurn * (state % kHeadings)};
  }
  double ToGoal(int state) const {
    const PlanarPose at = PoseOf(state);
    return std::hypot(problem_.goal.x_m - at.x_m, problem_.goal.y_m - at.y_m);
  }
  bool Holds(int state) {
    Known& known = holds_[static_cast<std::size_t>(state)];
    if (known == kUnknown) known = check_.IsFree(PoseOf(state)) ? kFree : kBlocked;
    return known == kFree;
  }
  /// Whether the body can turn left from a state to the next heading; both states are known to be free.
  bool TurnsLeft(int state) {
    Known& known = turns_[static_cast<std::size_t>(state)];
    for (const double share : {0.5, 0.25, 0.75}) {
      if (known == kFree || known == kBlocked) break;
      PlanarPose between = PoseOf(state);
      between.yaw_rad += share * kTurn;
      if (!check_.IsFree(between)) known = kBlocked;
    }
    if (known == kUnknown) known = kFree;
    return known == kFree;
  }
  Move Turned(int state, int side);
  Move Moved(int state, int direction);
  std::vector<PlanarPose> PathTo(int state, const std::vector<Visit>& visits) const;

  PoseCheck& check_;
  const CoarseProblem& problem_;
  double step_m_;
  std::array<int, 2> before_{};  // number of columns and rows before the start's
  int columns_, rows_;
  std::vector<Known> holds_, turns_;  // by state
};

Grid::Move Grid::Turned(int state, int side) {
  const int heading = state % kHeadings, other = (heading + side + kHeadings) % kHeadings;
  const int next = state - heading + other;
  const double cost = problem_.weights.turn_m_rad * kTurn;
  return {next, cost, Holds(state) && Holds(next) && TurnsLeft(side > 0 ? state : next)};
}

/// The neighbouring cell. `direction` is relative to the heading, in eighths of a turn and even: forward, left, back,
/// right.
Grid::Move Grid::Moved(int state, int direction) {
  static constexpr std::array<std::array<int, 2>, kHeadings> kSteps = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  const int heading = state % kHeadings, cell = state / kHeadings, absolute = (heading + direction) % kHeadings;
  const auto& step = kSteps[static_cast<std::size_t>(absolute)];
  const int column = cell % columns_ + step[0], row = cell / columns_ + step[1];
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return {};
  const double length = (absolute % 2 == 0 ? 1.0 : std::numbers::sqrt2) * step_m_;
  const TravelWeights& weights = problem_.weights;
  const double weight = direction == 0 ? 1.0 : (direction == 4 ? weights.backward : weights.lateral);
  const int next = (row * columns_ + column) * kHeadings + heading;
  return {next, weight * length, Holds(next)};
}

std::vector<PlanarPose> Grid::PathTo(int state, const std::vector<Visit>& visits) const {
  std::vector<PlanarPose> path;
  for (int at = state; at >= 0; at = visits[static_cast<std::size_t>(at)].parent) path.push_back(PoseOf(at));
  std::reverse(path.begin(), path.end());
  for (std::size_t i = 1; i < path.size(); ++i) path[i].yaw_rad = UnwrappedNear(path[i].yaw_rad, path[i - 1].yaw_rad);
  return path;
}

std::vector<PlanarPose> Grid::Search(const Limits& limits) {
  std::vector<Visit> visits(holds_.size());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](int state, double cost, int from) {
    Visit& visit = visits[static_cast<std::size_t>(state)];
    if (visit.done || cost >= visit.cost || cost + ToGoal(state) > limits.cost) return;
    visit.cost = cost;
    visit.parent = from;
    open.push({cost + ToGoal(state), state});
  };
  const int first = (before_[1] * columns_ + before_[0]) * kHeadings;
  for (int heading = 0; heading < kHeadings; ++heading) {
    const double turn = std::abs(std::remainder(problem_.start.yaw_rad - kTurn * heading, 2.0 * std::numbers::pi));
    if (turn < kTurn && (limits.through || Holds(first + heading)))
      reach(first + heading, problem_.weights.turn_m_rad * turn, -1);
  }
  for (int visited = 0; !open.empty() && visited < limits.states;) {
    const int state = open.top().state;
    open.pop();
    Visit& visit = visits[static_cast<std::size_t>(state)];
    if (visit.done) continue;
    visit.done = true;
    ++visited;
    if (ToGoal(state) <= 0.75 * step_m_) return PathTo(state, visits);
    for (const Move& move :
         {Moved(state, 0), Moved(state, 2), Moved(state, 4), Moved(state, 6), Turned(state, 1), Turned(state, -1)}) {
      if (move.state < 0 || (!move.free && !limits.through)) continue;
      reach(move.state, visit.cost + move.cost * (move.free ? 1.0 : kThroughHindrance), state);
    }
  }
  return {};
}

/// Reason why a pose is not free, or not reachable from the previous one.
std::optional<Hindrance> ReasonNotReached(PoseCheck& check, const PlanarPose& from, const PlanarPose& to) {
  if (auto why = check.ReasonRefused(Between(from, to, 0.5))) return why;
  return check.ReasonRefused(to);
}

/// The first obstacle along a path whose end is free.
std::optional<Hindrance> FirstHindrance(PoseCheck& check, const std::vector<PlanarPose>& path) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (auto why = ReasonNotReached(check, path[i - 1], path[i])) return why;
  }
  return std::nullopt;
}

}  // namespace

CoarseRoute FindCoarseRoute(PoseCheck& check, const CoarseProblem& problem) {
  constexpr double kMuchLonger = 1.3, kNotablyShorter = 0.85;
  Grid grid(check, problem, kStepOfLeg);
  CoarseRoute route;
  route.poses = grid.Search({});
  const double straight = std::hypot(problem.goal.x_m - problem.start.x_m, problem.goal.y_m - problem.start.y_m);
  const double cost = route.poses.empty() ? kInfinity : TravelCost(route.poses, problem.weights);
  if (cost > kMuchLonger * straight) {
    const Limits limits{false, kNotablyShorter * cost, kMostFineStates};
    std::vector<PlanarPose> shorter = Grid(check, problem, kFineStepOfLeg).Search(limits);
    if (!shorter.empty()) route.poses = std::move(shorter);
  }
  route.complete = !route.poses.empty();
  if (!route.complete) route.poses = grid.Search({true});
  if (!route.complete) route.hindrance = FirstHindrance(check, route.poses);
  route.poses.push_back(problem.goal);
  return route;
}

}  // namespace gaitwright
