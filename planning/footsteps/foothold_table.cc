// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/foothold_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/spatial/rotation.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

constexpr double kLattice = 1.0 / 16.0;  // spacing of places around the nominal position, as a share of the leg length
constexpr double kBesideGoal = 4.0;      // multiple of the goal tolerance within which feet may end beside the goal
constexpr double kSafeRisk = 0.05;       // largest risk at which only few other places are offered

PlanarPose InPlan(const Pose& X_WF) { return {X_WF.translation().x(), X_WF.translation().y(), YawOf(X_WF.linear())}; }

double Distance(const PlanarPose& a, const PlanarPose& b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

PlanarPose Shifted(const PlanarPose& at, double forward, double left) {
  const double c = std::cos(at.yaw_rad), s = std::sin(at.yaw_rad);
  return {at.x_m + c * forward - s * left, at.y_m + s * forward + c * left, at.yaw_rad};
}

std::uint64_t KeyOf(const PlacedFoot& placed) {
  constexpr double kPlace = 1e-3, kTurn = 1e-2;  // [m], [rad]
  const PlanarPose at = InPlan(placed.X_WF);
  const auto part = [](double value, double unit) {
    return static_cast<std::uint64_t>(std::llround(value / unit) + (std::int64_t{1} << 21)) & 0x3fffffU;
  };
  const std::uint64_t turn = static_cast<std::uint64_t>(std::llround(at.yaw_rad / kTurn) + 512) & 0x3ffU;
  return part(at.x_m, kPlace) << 42U ^ part(at.y_m, kPlace) << 20U ^ turn << 8U ^
         static_cast<std::uint64_t>(placed.foot);
}

}  // namespace

FootholdTable::FootholdTable(const RobotModel& model, const FootholdChecker& checker, const FootstepQuery& query,
                             const FootstepSearchOptions& options, bool beside_goal)
    : checker_(&checker),
      query_(&query),
      options_(options),
      beside_goal_(beside_goal),
      standing_(StandingFeet(model)),
      leg_m_(model.leg_length_m()),
      offset_m_(options.offset * leg_m_) {
  const double groups = static_cast<double>(FootGroups(query.gait).size());
  const double length = query.route.length_m();
  const double advances = std::max(1.0, std::ceil(length * groups / query.stride_m - 1e-6));
  advance_m_ = length / advances;
  stride_m_ = groups * advance_m_;
  const double parts = std::max(1.0, std::ceil(advance_m_ / (kLattice * leg_m_) - 1e-6));
  step_m_ = advance_m_ / parts;
  num_steps_ = static_cast<int>(std::lround(advances * parts));
  cells_.assign(model.feet.size(), std::vector<Cell>(static_cast<std::size_t>(num_steps_) + 1));
  places_.resize(model.feet.size());
  for (std::size_t foot = 0; foot < model.feet.size(); ++foot)
    for (int step = 0; step <= num_steps_; ++step)
      places_[foot].push_back(PlaceAt(static_cast<int>(foot), step * step_m_));
}

PlanarPose FootholdTable::PlaceAt(int foot, double station_m) const {
  return InPlan(Carried(RouteAt(query_->route, station_m), standing_[static_cast<std::size_t>(foot)]));
}

const std::vector<int>& FootholdTable::Near(int foot, int step) {
  Cell& cell = cells_[static_cast<std::size_t>(foot)][static_cast<std::size_t>(step)];
  if (!cell.known) Fill(foot, step, cell);
  return cell.choices;
}

FootholdTable::Faults FootholdTable::FaultsAt(int foot, int step) const {
  return cells_[static_cast<std::size_t>(foot)][static_cast<std::size_t>(step)].faults;
}

Placing FootholdTable::Start(int foot, int& index) {
  Placing placing = checker_->Place(foot, PlaceAt(foot, 0.0));
  if (!placing.ok()) return placing;
  FootholdChoice choice;
  choice.placed = placing.placed;
  choice.outline_W = checker_->OutlineAt(foot, PlaceAt(foot, 0.0));
  index = static_cast<int>(choices_.size());
  choices_.push_back(std::move(choice));
  return placing;
}

FootholdTable::Offer FootholdTable::OfferAround(int foot, const Placing& own) const {
  if (own.ok() && own.placed.risk < kSafeRisk) return {4, 0};
  return checker_->MayRock(foot) ? Offer{16, 2} : Offer{8, 1};
}

void FootholdTable::ListPlaces(int foot, const PlanarPose& at, int parts, std::vector<PlanarPose>& places) const {
  const double unit = kLattice * leg_m_;
  const auto offer = [&](double forward, double left) {
    if (std::hypot(forward, left) <= offset_m_) places.push_back(Shifted(at, forward, left));
  };
  if (parts == 0) {
    for (const double left : {unit, -unit, 2.0 * unit, -2.0 * unit}) offer(0.0, left);
    return;
  }
  checker_->Near(foot, at, offset_m_, places);
  for (int i = -parts; i <= parts; ++i)
    for (int k = -3 * parts; k <= 3 * parts; ++k)
      if (i != 0 || k != 0) offer(i * unit / parts, k * unit / parts);
}

void FootholdTable::Fill(int foot, int step, Cell& cell) {
  cell.known = true;
  const PlanarPose at = PlaceAtStep(foot, step);
  const Placing own = checker_->Place(foot, at);
  std::vector<std::pair<double, int>> found;
  const auto take = [&](const Placing& placing, double distance) {
    ++cell.faults[static_cast<std::size_t>(placing.fault)];
    if (!placing.ok()) return;
    const double share = distance / offset_m_;
    const double cost = options_.departure_weight * share * share + options_.risk_weight * placing.placed.risk;
    found.emplace_back(cost, Intern(placing.placed, step));
  };
  take(own, 0.0);
  const Offer offer = OfferAround(foot, own);
  std::vector<PlanarPose> places;
  ListPlaces(foot, at, offer.parts, places);
  for (const PlanarPose& place : places) take(checker_->Place(foot, place), Distance(place, at));
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [cost, index] : found) {
    if (cell.choices.size() >= offer.most) break;
    if (std::find(cell.choices.begin(), cell.choices.end(), index) == cell.choices.end()) cell.choices.push_back(index);
  }
}

int FootholdTable::Intern(const PlacedFoot& placed, int step) {
  const auto [entry, is_new] = index_.try_emplace(KeyOf(placed), static_cast<int>(choices_.size()));
  if (!is_new) return entry->second;
  FootholdChoice choice;
  choice.placed = placed;
  choice.outline_W = checker_->OutlineAt(placed.foot, InPlan(placed.X_WF));
  Locate(choice, step);
  choices_.push_back(std::move(choice));
  return entry->second;
}

void FootholdTable::Locate(FootholdChoice& choice, int step) const {
  constexpr int kParts = 4;  // parts of a step of the route
  const int foot = choice.placed.foot, around = static_cast<int>(std::ceil(offset_m_ / step_m_)) + 1;
  const PlanarPose own = InPlan(choice.placed.X_WF);
  const double given = options_.goal_tolerance * leg_m_;
  const double tolerance = beside_goal_ ? kBesideGoal * given : std::min(given, 0.5 * stride_m_);
  choice.departure_m = std::numeric_limits<double>::infinity();
  for (int i = kParts * std::max(0, step - around); i <= kParts * std::min(num_steps_, step + around); ++i) {
    const double station = i * step_m_ / kParts, distance = Distance(PlaceAt(foot, station), own);
    if (distance >= choice.departure_m - 1e-9) continue;
    choice.departure_m = distance;
    choice.station_m = station;
  }
  if (step + around < num_steps_) return;
  constexpr double kTurned = 0.03;  // [rad]
  const PlanarPose goal = PlaceAt(foot, query_->route.length_m());
  const double to_goal = Distance(goal, own);
  if (to_goal > tolerance || std::abs(WrapAngle(own.yaw_rad - goal.yaw_rad)) > kTurned) return;
  choice.goal = true;
  choice.station_m = query_->route.length_m();
  choice.departure_m = to_goal;
}

}  // namespace gaitwright
