// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/coarse_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <queue>
#include <set>
#include <tuple>
#include <vector>

#include "kinematics/spatial/rotation.h"
#include "planning/footsteps/foothold_check.h"
#include "planning/footsteps/stance_check.h"
#include "planning/footsteps/uneven_footsteps.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/terrain_scale.h"
#include "planning/plan/terrain_shapes.h"

namespace gaitwright {
namespace {

/// A place of a lattice, in cells along and across the line from start to goal and in fractions of a turn.
struct Cell {
  int along = 0, across = 0, turn = 0;
};

/// Places of the base, numbered.
class Lattice {
 public:
  static constexpr int kTurns = 16;

  Lattice(const RobotModel& model, const Terrain& terrain, const WalkCommand& command, double stride_m) {
    const bool straight = command.extent == WalkCommand::Extent::kDistance;
    if (!straight) goal_W_ << command.goal_x_m, command.goal_y_m;
    if (straight) goal_W_ << command.distance_m, 0.0;
    const double distance = goal_W_.norm(), wanted = straight ? stride_m / 3.0 : model.leg_length_m() / 3.0;
    const int cells = static_cast<int>(std::ceil(distance / wanted));
    cell_m_ = distance / cells;
    along_W_ = goal_W_ / distance;
    turns_ = straight ? 1 : kTurns;
    const int turn = static_cast<int>(std::lround(command.goal_yaw_rad / (2.0 * std::numbers::pi) * kTurns));
    goal_ = {cells, 0, straight ? 0 : (turn % kTurns + kTurns) % kTurns};
    highest_ = {cells, 0, 0};
    if (!straight) Widen(terrain, ScaleOf(model));
    ListMoves(straight);
  }

  PlanarPose At(int place) const {
    const Cell cell = CellOf(place);
    const Vector2 across_W(-along_W_.y(), along_W_.x());
    const Vector2 p_W = cell_m_ * (cell.along * along_W_ + cell.across * across_W);
    return {p_W.x(), p_W.y(), WrapAngle(2.0 * std::numbers::pi * cell.turn / kTurns)};
  }
  int Start() const { return NumberOf({0, 0, 0}); }
  int Goal() const { return NumberOf(goal_); }
  /// Remaining cells and turns.
  double ToGoal(int place) const {
    const Cell cell = CellOf(place);
    const int turned = std::abs(cell.turn - goal_.turn);
    return std::hypot(cell.along - goal_.along, cell.across - goal_.across) + 0.5 * std::min(turned, kTurns - turned);
  }
  /// The places to which feet may step while the other feet stand at this one, including itself.
  std::vector<int> Around(int place) const {
    std::vector<int> around;
    const Cell cell = CellOf(place);
    for (const Cell& move : moves_) {
      const Cell to{cell.along + move.along, cell.across + move.across, (cell.turn + move.turn + turns_) % turns_};
      const bool inside = to.along >= lowest_.along && to.along <= highest_.along && to.across >= lowest_.across &&
                          to.across <= highest_.across;
      if (inside) around.push_back(NumberOf(to));
    }
    return around;
  }

 private:
  void Widen(const Terrain& terrain, const TerrainScale& scale) {
    constexpr double kAround = 0.75;  // share of the body's diagonal
    const int margin = 1 + static_cast<int>(kAround * std::hypot(scale.body_length_m, scale.body_width_m) / cell_m_);
    for (const Obstacle& obstacle : terrain.obstacles) {
      for (const Vector3& corner : CornersOf(obstacle)) {
        const double along = along_W_.dot(corner.head<2>()) / cell_m_;
        const double across = (along_W_.x() * corner.y() - along_W_.y() * corner.x()) / cell_m_;
        lowest_.along = std::min(lowest_.along, static_cast<int>(std::floor(along)));
        highest_.along = std::max(highest_.along, static_cast<int>(std::ceil(along)));
        lowest_.across = std::min(lowest_.across, static_cast<int>(std::floor(across)));
        highest_.across = std::max(highest_.across, static_cast<int>(std::ceil(across)));
      }
    }
    for (int* low : {&lowest_.along, &lowest_.across}) *low -= margin;
    for (int* high : {&highest_.along, &highest_.across}) *high += margin;
  }

  void ListMoves(bool straight) {
    constexpr int kFarthest = 4;
    if (straight) {
      for (int along = 0; along <= kFarthest; ++along) moves_.push_back({along, 0, 0});
      return;
    }
    for (int along = -1; along <= 1; ++along)
      for (int across = -1; across <= 1; ++across) moves_.push_back({along, across, 0});
    for (const int turn : {-1, 1}) moves_.push_back({0, 0, turn});
  }

  int NumberOf(const Cell& cell) const {
    const int wide = highest_.across - lowest_.across + 1;
    return ((cell.along - lowest_.along) * wide + cell.across - lowest_.across) * turns_ + cell.turn;
  }
  Cell CellOf(int place) const {
    const int wide = highest_.across - lowest_.across + 1, column = place / turns_;
    return {lowest_.along + column / wide, lowest_.across + column % wide, place % turns_};
  }

  Vector2 goal_W_, along_W_;
  double cell_m_ = 1.0;
  int turns_ = 1;
  Cell goal_, lowest_, highest_;
  std::vector<Cell> moves_;
};

/// A few footholds for each foot and place of the base.
class Footholds {
 public:
  struct Choice {
    PlacedFoot placed;
    Polygon outline_W;
  };

  Footholds(const RobotModel& model, const FootholdChecker& checker, const Lattice& lattice, int most)
      : model_(model), checker_(checker), lattice_(lattice), standing_(StandingFeet(model)), most_(most) {}

  /// The nominal position of a foot for a place of the base.
  PlanarPose PlaceOf(int foot, int place) const {
    const Pose X_WF = Carried(lattice_.At(place), standing_[static_cast<std::size_t>(foot)]);
    return {X_WF.translation().x(), X_WF.translation().y(), YawOf(X_WF.linear())};
  }

  /// The footholds of a foot, the nearest to its nominal position first.
  const std::vector<int>& Near(int foot, int place, double radius_m) {
    const auto [entry, is_new] = near_.try_emplace({foot, place});
    if (is_new) entry->second = Find(foot, PlaceOf(foot, place), radius_m);
    return entry->second;
  }

  /// The foothold of a foot at its nominal position; -1 if it cannot stand there.
  int Own(int foot, int place) {
    const PlanarPose at = PlaceOf(foot, place);
    const Placing placing = checker_.Place(foot, at);
    return placing.ok() ? Number(placing.placed, at) : -1;
  }

  const Choice& operator[](int number) const { return choices_[static_cast<std::size_t>(number)]; }

 private:
  std::vector<int> Find(int foot, const PlanarPose& at, double radius_m) {
    constexpr double kApart = 1.0 / 16.0;  // share of the leg length
    std::vector<PlanarPose> places = {at};
    checker_.Near(foot, at, radius_m, places);
    for (const double share : {0.25, 0.5, 1.0}) {
      for (int k = 0; k < 8; ++k) {
        const double direction = 0.25 * std::numbers::pi * k;
        places.push_back({at.x_m + share * radius_m * std::cos(direction),
                          at.y_m + share * radius_m * std::sin(direction), at.yaw_rad});
      }
    }
    const auto far = [&](const PlanarPose& p) { return std::hypot(p.x_m - at.x_m, p.y_m - at.y_m); };
    std::stable_sort(places.begin(), places.end(),
                     [&](const PlanarPose& a, const PlanarPose& b) { return far(a) < far(b) - 1e-9; });
    std::vector<int> found;
    for (const PlanarPose& place : places) {
      if (static_cast<int>(found.size()) >= most_) break;
      const Placing placing = checker_.Place(foot, place);
      if (!placing.ok()) continue;
      const auto near = [&](int number) {
        return ((*this)[number].placed.X_WF.translation() - placing.placed.X_WF.translation()).norm() <
               kApart * model_.leg_length_m();
      };
      if (std::none_of(found.begin(), found.end(), near)) found.push_back(Number(placing.placed, place));
    }
    return found;
  }

  /// Footholds that are equal to a millimetre are stored once.
  int Number(const PlacedFoot& placed, const PlanarPose& at) {
    const auto unit = [](double value, double of) { return std::lround(value / of); };
    const auto key = std::make_tuple(placed.foot, unit(at.x_m, 1e-3), unit(at.y_m, 1e-3), unit(at.yaw_rad, 1e-2));
    const auto [entry, is_new] = numbers_.try_emplace(key, static_cast<int>(choices_.size()));
    if (is_new) choices_.push_back({placed, checker_.OutlineAt(placed.foot, at)});
    return entry->second;
  }

  const RobotModel& model_;
  const FootholdChecker& checker_;
  const Lattice& lattice_;
  std::vector<Pose> standing_;
  int most_;
  std::vector<Choice> choices_;
  std::map<std::tuple<int, long, long, long>, int> numbers_;
  std::map<std::pair<int, int>, std::vector<int>> near_;
};

/// Data of the search. The members refer to each other, so it must not be moved.
class Search {
 public:
  Search(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query, const WalkRequest& request)
      : model_(model),
        options_(request.motion.footsteps),
        groups_(FootGroups(query.gait)),
        ground_(terrain, 0.5 * model.leg_length_m()),
        checker_(model, ground_, options_.foothold),
        stances_(model, ground_, query, options_.foothold, options_.search),
        lattice_(model, terrain, request.command, query.stride_m),
        footholds_(model, checker_, lattice_, ChoicesOf(model, request.command)),
        radius_m_(options_.search.offset * model.leg_length_m()),
        tolerance_m_(std::min(options_.search.goal_tolerance * model.leg_length_m(), 0.5 * query.stride_m)) {}
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  CoarseAnswer Run() {
    State start;
    start.place = lattice_.Start();
    for (int foot = 0; foot < static_cast<int>(model_.feet.size()); ++foot)
      start.feet.push_back(footholds_.Own(foot, start.place));
    if (std::find(start.feet.begin(), start.feet.end(), -1) != start.feet.end() || !Holds(start.feet)) return {};
    for (start.next = 0; start.next < static_cast<int>(groups_.size()); ++start.next) Add(start);
    while (!open_.empty() && !found_) {
      const State state = states_[static_cast<std::size_t>(std::get<1>(open_.top()))];
      open_.pop();
      Expand(state);
    }
    return {found_, static_cast<int>(states_.size())};
  }

 private:
  struct State {
    std::vector<int> feet;  // footholds
    int place = 0;          // place of the group that stepped last
    int next = 0;           // next group
  };

  /// On level ground between walls, feet stand at their nominal positions.
  static int ChoicesOf(const RobotModel& model, const WalkCommand& command) {
    if (command.extent == WalkCommand::Extent::kGoal) return 1;
    return model.feet.size() <= 2 ? 8 : 4;
  }

  void Add(const State& state) {
    std::vector<int> key = state.feet;
    key.push_back(state.place);
    key.push_back(state.next);
    if (!seen_.insert(std::move(key)).second) return;
    found_ = found_ || AtGoal(state.feet);
    open_.emplace(lattice_.ToGoal(state.place), static_cast<int>(states_.size()));
    states_.push_back(state);
  }

  void Expand(const State& state) {
    for (const int place : lattice_.Around(state.place)) {
      State to = state;
      to.place = place;
      to.next = (state.next + 1) % static_cast<int>(groups_.size());
      Step(state, 0, to);
    }
  }

  void Step(const State& from, std::size_t member, State& to) {
    const std::vector<int>& group = groups_[static_cast<std::size_t>(from.next)];
    if (member == group.size()) {
      if (Holds(to.feet)) Add(to);
      return;
    }
    const auto foot = static_cast<std::size_t>(group[member]);
    const Vector3 here = footholds_[from.feet[foot]].placed.X_WF.translation();
    for (const int number : footholds_.Near(group[member], to.place, radius_m_)) {
      const Vector3 step = footholds_[number].placed.X_WF.translation() - here;
      const bool too_long = step.head<2>().norm() > options_.search.step_length * model_.leg_length_m();
      const bool too_high = std::abs(step.z()) > options_.search.step_height * model_.leg_length_m();
      if (too_long || too_high) continue;
      to.feet[foot] = number;
      Step(from, member + 1, to);
    }
  }

  bool Holds(const std::vector<int>& feet) {
    const auto [entry, is_new] = holds_.try_emplace(feet, false);
    if (!is_new) return entry->second;
    std::vector<Pose> X_WF;
    std::vector<const Polygon*> outlines;
    for (const int number : feet) {
      X_WF.push_back(footholds_[number].placed.X_WF);
      outlines.push_back(&footholds_[number].outline_W);
    }
    return entry->second = stances_.Check(X_WF, outlines) == StanceFault::kNone;
  }

  bool AtGoal(const std::vector<int>& feet) const {
    constexpr double kTurned = 0.03;  // [rad]
    for (std::size_t foot = 0; foot < feet.size(); ++foot) {
      const PlanarPose goal = footholds_.PlaceOf(static_cast<int>(foot), lattice_.Goal());
      const Pose& X_WF = footholds_[feet[foot]].placed.X_WF;
      const double away = std::hypot(X_WF.translation().x() - goal.x_m, X_WF.translation().y() - goal.y_m);
      if (away > tolerance_m_ || std::abs(WrapAngle(YawOf(X_WF.linear()) - goal.yaw_rad)) > kTurned) return false;
    }
    return true;
  }

  const RobotModel& model_;
  const FootstepOptions options_;
  const std::vector<std::vector<int>> groups_;
  const GroundIndex ground_;
  const FootholdChecker checker_;
  StanceChecker stances_;
  const Lattice lattice_;
  Footholds footholds_;
  double radius_m_, tolerance_m_;
  bool found_ = false;
  std::vector<State> states_;
  std::set<std::vector<int>> seen_;
  std::map<std::vector<int>, bool> holds_;
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open_;
};

}  // namespace

CoarseAnswer SearchCoarsely(const RobotModel& model, const Terrain& terrain, const WalkRequest& request) {
  const double speed = CommandedSpeed(model, request.command);
  const Result<Gait> gait = FindGait(model, request.gait, speed, request.gait_options);
  const Result<FootstepQuery> query = CourseQuery(model, gait.value(), request.command, request.motion.footsteps);
  return Search(model, terrain, query.value(), request).Run();
}

}  // namespace gaitwright
