// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/smooth_route.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gaitwright {
namespace {

/// A waypoint between which parts of a path may be replaced.
struct Node {
  PlanarPose pose;
  std::size_t place = 0;  ///< index along the path
  double cost = std::numeric_limits<double>::infinity();
  std::size_t from = 0;
  DirectRoute kind = DirectRoute::kStraight;
  bool original = false;  ///< true if the path reaches it from the previous node as before
};

/// A possible edge to a node.
struct Edge {
  double cost;
  std::size_t from;
  DirectRoute kind;
  bool original;
  bool operator<(const Edge& other) const { return cost < other.cost; }
};

/// Nodes for each place of a path: with the original heading, and with the heading along the path.
std::vector<Node> NodesOf(const std::vector<PlanarPose>& path) {
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < path.size(); ++i) {
    nodes.push_back({path[i], i});
    if (i == 0 || i + 1 == path.size()) continue;
    const double dx = path[i + 1].x_m - path[i - 1].x_m, dy = path[i + 1].y_m - path[i - 1].y_m;
    if (std::hypot(dx, dy) == 0.0) continue;
    nodes.push_back({{path[i].x_m, path[i].y_m, UnwrappedNear(std::atan2(dy, dx), path[i].yaw_rad)}, i});
  }
  return nodes;
}

/// Shortest path over nodes. Edges are checked in the order of their cost, only until one is free.
class Shortcuts {
 public:
  Shortcuts(PoseCheck& check, const std::vector<PlanarPose>& path, const TravelWeights& weights)
      : check_(check), weights_(weights), spacing_{0.5 * check.space().leg_length_m, 0.5}, nodes_(NodesOf(path)) {}

  std::vector<PlanarPose> Cheapest() {
    nodes_.front().cost = 0.0;
    for (std::size_t to = 1; to < nodes_.size(); ++to) {
      for (const Edge& edge : EdgesTo(to)) {
        if (!edge.original && !IsFree(nodes_[edge.from].pose, to, edge.kind)) continue;
        nodes_[to].cost = edge.cost;
        nodes_[to].from = edge.from;
        nodes_[to].kind = edge.kind;
        nodes_[to].original = edge.original;
        break;
      }
    }
    return TracedPath();
  }

 private:
  static constexpr std::size_t kMostPlaces = 16;  // largest number of places that one direct path may skip

  std::vector<Edge> EdgesTo(std::size_t to) const {
    std::vector<Edge> edges;
    for (std::size_t from = to; from-- > 0;) {
      const Node& node = nodes_[from];
      if (node.place + kMostPlaces < nodes_[to].place) break;
      if (node.place == nodes_[to].place || !std::isfinite(node.cost)) continue;
      const bool as_it_was = node.place + 1 == nodes_[to].place && IsOnPath(from) && IsOnPath(to);
      for (const DirectRoute kind : kDirectRoutes) {
        const double cost = CostOf(kind, node.pose, nodes_[to].pose, weights_);
        edges.push_back({node.cost + cost, from, kind, as_it_was && kind == DirectRoute::kStraight});
      }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }
  bool IsOnPath(std::size_t i) const { return i == 0 || nodes_[i - 1].place != nodes_[i].place; }

  bool IsFree(const PlanarPose& from, std::size_t to, DirectRoute kind) const {
    return check_.IsFreeAlong(WaypointsOf(kind, from, nodes_[to].pose, spacing_));
  }

  std::vector<PlanarPose> TracedPath() const {
    std::vector<std::size_t> order;
    for (std::size_t i = nodes_.size() - 1; i > 0; i = nodes_[i].from) order.push_back(i);
    std::reverse(order.begin(), order.end());
    std::vector<PlanarPose> path = {nodes_.front().pose};
    for (const std::size_t i : order) {
      const std::vector<PlanarPose> part = WaypointsOf(nodes_[i].kind, path.back(), nodes_[i].pose, spacing_);
      path.insert(path.end(), part.begin() + 1, part.end());
    }
    return path;
  }

  PoseCheck& check_;
  TravelWeights weights_;
  Spacing spacing_;
  std::vector<Node> nodes_;
};

/// Moves waypoints by ever smaller steps while this reduces the cost and the path stays free.
class Relaxation {
 public:
  Relaxation(PoseCheck& check, const TravelWeights& weights, double step_m)
      : check_(check), weights_(weights), step_m_(step_m), turn_rad_(step_m / check.space().leg_length_m) {}

  void Run(std::vector<PlanarPose>& path) {
    constexpr int kMostSweeps = 24;
    constexpr double kSmallest = 0.05;  // share of the first step
    double share = 1.0;
    for (int sweep = 0; sweep < kMostSweeps && share > kSmallest; ++sweep) {
      bool moved = false;
      for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        const std::size_t at = sweep % 2 == 0 ? i : path.size() - 1 - i;
        moved = Move(path, at, share) || moved;
      }
      if (!moved) share *= 0.5;
    }
  }

 private:
  bool Move(std::vector<PlanarPose>& path, std::size_t i, double share) {
    const PlanarPose &before = path[i - 1], &after = path[i + 1];
    Vector2 along(after.x_m - before.x_m, after.y_m - before.y_m);
    along = along.norm() > 1e-9 ? Vector2(along.normalized())
                                : Vector2(std::cos(path[i].yaw_rad), std::sin(path[i].yaw_rad));
    const Vector2 step = share * step_m_ * along;
    const double turn = share * turn_rad_;
    const std::array<PlanarPose, 6> moves = {{{-step.y(), step.x(), 0.0},
                                              {step.y(), -step.x(), 0.0},
                                              {0.0, 0.0, turn},
                                              {0.0, 0.0, -turn},
                                              {step.x(), step.y(), 0.0},
                                              {-step.x(), -step.y(), 0.0}}};
    bool moved = false;
    for (const PlanarPose& move : moves) {
      const PlanarPose to{path[i].x_m + move.x_m, path[i].y_m + move.y_m, path[i].yaw_rad + move.yaw_rad};
      const double now = Through(before, path[i], after), then = Through(before, to, after);
      if (then >= now * (1.0 - 1e-6) || !check_.IsFreeBetween(before, to) || !check_.IsFreeBetween(to, after)) continue;
      path[i] = to;
      moved = true;
    }
    return moved;
  }
  double Through(const PlanarPose& a, const PlanarPose& b, const PlanarPose& c) const {
    return TravelCost(a, b, weights_) + TravelCost(b, c, weights_);
  }

  PoseCheck& check_;
  TravelWeights weights_;
  double step_m_, turn_rad_;
};

/// At most a given number of waypoints, if possible with no more than a given spacing.
std::vector<PlanarPose> Sampled(const std::vector<PlanarPose>& path, double leg) {
  constexpr double kMost = 60.0;
  double turned = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) turned += std::abs(path[i].yaw_rad - path[i - 1].yaw_rad);
  return Densified(path, {std::max(leg, LengthOf(path) / kMost), std::max(0.8, turned / kMost)});
}

}  // namespace

std::vector<PlanarPose> SmoothRoute(PoseCheck& check, const std::vector<PlanarPose>& path,
                                    const TravelWeights& weights) {
  const double leg = check.space().leg_length_m;
  std::vector<PlanarPose> best = path;
  for (const double spacing : {2.0, 1.0, 0.5}) {
    if (spacing >= 1.0) {
      std::vector<PlanarPose> shorter = Shortcuts(check, Sampled(best, leg), weights).Cheapest();
      if (TravelCost(shorter, weights) < TravelCost(best, weights)) best = std::move(shorter);
    }
    best = Densified(best, {spacing * leg, 0.6 * spacing});
    Relaxation(check, weights, 0.25 * spacing * leg).Run(best);
  }
  return best;
}

}  // namespace gaitwright
