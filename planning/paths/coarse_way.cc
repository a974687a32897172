// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/coarse_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "planning/paths/travel_cost.h"

namespace gaitwright {
namespace {

constexpr double kStepOfLeg = 0.25;        // edge of a cell in leg lengths
constexpr double kMostCells = 4e5;         // of the grid; beyond that cells grow
constexpr double kThroughHindrance = 1e4;  // what a metre through a hindrance costs
constexpr int kDirections = 8;

/// A search over cells, each entered in one of eight directions.
class Grid {
 public:
  Grid(PoseCheck& check, const PlanarPose& start, const PlanarPose& goal, const PlaneExtent& extent)
      : check_(check), start_(start), goal_(goal) {
    const Vector2 size = extent.sizes();
    step_m_ = std::max(kStepOfLeg * check.space().leg_length_m, std::sqrt(size.prod() / kMostCells));
    // The start is the middle of a cell.
    const Vector2 low = (Vector2(start.x_m, start.y_m) - extent.min()) / step_m_;
    before_ = {static_cast<int>(low.x()), static_cast<int>(low.y())};
    columns_ = before_[0] + 1 + static_cast<int>((extent.max().x() - start.x_m) / step_m_);
    rows_ = before_[1] + 1 + static_cast<int>((extent.max().y() - start.y_m) / step_m_);
    entering_.assign(static_cast<std::size_t>(columns_ * rows_ * kDirections), kUnknown);
  }

  /// The cells of the cheapest way, start first; empty when there is none. @param through  lets it pass hindrances.
  std::vector<int> Search(bool through);

  PlanarPose PoseOf(int cell, double yaw) const {
    return {start_.x_m + step_m_ * (cell % columns_ - before_[0]),
            start_.y_m + step_m_ * (cell / columns_ - before_[1]), yaw};
  }
  double HeadingOf(int from, int to) const {
    return std::atan2(to / columns_ - from / columns_, to % columns_ - from % columns_);
  }
  bool Enters(int cell, int direction);

 private:
  enum State : std::uint8_t { kUnknown, kFree, kBlocked };

  int Neighbour(int cell, int direction) const {
    static constexpr std::array<std::array<int, 2>, kDirections> kSteps = {
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    const auto& step = kSteps[static_cast<std::size_t>(direction)];
    const int column = cell % columns_ + step[0], row = cell / columns_ + step[1];
    return column < 0 || row < 0 || column >= columns_ || row >= rows_ ? -1 : row * columns_ + column;
  }
  double ToGoal(int cell) const {
    const PlanarPose at = PoseOf(cell, 0.0);
    return std::hypot(goal_.x_m - at.x_m, goal_.y_m - at.y_m);
  }

  PoseCheck& check_;
  PlanarPose start_, goal_;
  double step_m_;
  std::array<int, 2> before_{};  // columns and rows before the start's
  int columns_, rows_;
  std::vector<State> entering_;  // by cell and direction
};

bool Grid::Enters(int cell, int direction) {
  State& state = entering_[static_cast<std::size_t>(cell * kDirections + direction)];
  if (state == kUnknown) {
    const double yaw = 0.25 * std::numbers::pi * direction;
    const PlanarPose to = PoseOf(cell, yaw);
    const double back = 0.5 * (direction % 2 == 0 ? 1.0 : std::numbers::sqrt2) * step_m_;
    const PlanarPose middle{to.x_m - back * std::cos(yaw), to.y_m - back * std::sin(yaw), yaw};
    state = check_.IsFree(to) && check_.IsFree(middle) ? kFree : kBlocked;
  }
  return state == kFree;
}

std::vector<int> Grid::Search(bool through) {
  struct Entry {
    double estimate;
    int cell;
    bool operator>(const Entry& other) const {
      return estimate != other.estimate ? estimate > other.estimate : cell > other.cell;
    }
  };
  const auto cells = static_cast<std::size_t>(columns_ * rows_);
  std::vector<double> cost(cells, std::numeric_limits<double>::infinity());
  std::vector<int> parent(cells, -1);
  std::vector<bool> done(cells, false);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const int first = before_[1] * columns_ + before_[0];
  cost[static_cast<std::size_t>(first)] = 0.0;
  open.push({ToGoal(first), first});
  while (!open.empty()) {
    const int cell = open.top().cell;
    open.pop();
    if (done[static_cast<std::size_t>(cell)]) continue;
    done[static_cast<std::size_t>(cell)] = true;
    if (ToGoal(cell) <= 0.75 * step_m_) {
      std::vector<int> way;
      for (int at = cell; at >= 0; at = parent[static_cast<std::size_t>(at)]) way.push_back(at);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (int direction = 0; direction < kDirections; ++direction) {
      const int next = Neighbour(cell, direction);
      if (next < 0 || done[static_cast<std::size_t>(next)]) continue;
      const bool enters = Enters(next, direction);
      if (!enters && !through) continue;
      const double length = (direction % 2 == 0 ? 1.0 : std::numbers::sqrt2) * step_m_;
      const double reached = cost[static_cast<std::size_t>(cell)] + length * (enters ? 1.0 : kThroughHindrance);
      if (reached >= cost[static_cast<std::size_t>(next)]) continue;
      cost[static_cast<std::size_t>(next)] = reached;
      parent[static_cast<std::size_t>(next)] = cell;
      open.push({reached + ToGoal(next), next});
    }
  }
  return {};
}

/// Why a cell cannot be entered from another: at its middle or on the way to it.
std::optional<Hindrance> WhyNotEntered(PoseCheck& check, const PlanarPose& from, const PlanarPose& to) {
  if (auto why = check.WhyNot(Between(from, to, 0.5))) return why;
  return check.WhyNot(to);
}

}  // namespace

CoarseWay FindCoarseWay(PoseCheck& check, const PlanarPose& start, const PlanarPose& goal, const PlaneExtent& extent) {
  Grid grid(check, start, goal, extent);
  CoarseWay way;
  std::vector<int> cells = grid.Search(false);
  way.complete = !cells.empty();
  if (!way.complete) cells = grid.Search(true);
  for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
    const double yaw = grid.HeadingOf(cells[i], cells[i + 1]);
    way.poses.push_back(grid.PoseOf(cells[i], yaw));
    if (way.complete || way.hindrance) continue;
    way.hindrance = WhyNotEntered(check, grid.PoseOf(cells[i], yaw), grid.PoseOf(cells[i + 1], yaw));
  }
  way.poses.push_back(goal);
  return way;
}

}  // namespace gaitwright
