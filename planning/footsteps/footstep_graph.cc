// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/footstep_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/footsteps/plan_view.h"

namespace gaitwright {
namespace {

constexpr double kOneLevel = 0.05;  // largest height difference of footholds on one level, in leg lengths

Vector2 InPlan(const FootholdChoice& choice) { return choice.placed.X_WF.translation().head<2>(); }
double HeightOf(const FootholdChoice& choice) { return choice.placed.X_WF.translation().z(); }

}  // namespace

FootstepGraph::FootstepGraph(const RobotModel& model, const FootstepQuery& query, FootholdTable& table,
                             StanceChecker& stances, const GroundIndex& ground, const FootstepSearchOptions& options)
    : query_(&query),
      table_(&table),
      stances_(&stances),
      ground_(&ground),
      options_(options),
      leg_m_(model.leg_length_m()),
      groups_(FootGroups(query.gait)),
      num_feet_(model.feet.size()),
      slots_(1U << 12U, -1),
      chosen_(num_feet_),
      poses_(num_feet_),
      outlines_(num_feet_) {}

std::span<const int> FootstepGraph::FootholdsOf(int stance) const {
  return {footholds_.data() + static_cast<std::size_t>(stance) * num_feet_, num_feet_};
}

std::size_t FootstepGraph::Hash(std::span<const int> footholds, int group) const {
  std::uint64_t hash = static_cast<std::uint64_t>(group) + 0x9e3779b97f4a7c15ULL;
  for (const int foothold : footholds) {
    hash ^= static_cast<std::uint64_t>(foothold) + 0x9e3779b97f4a7c15ULL + (hash << 6U) + (hash >> 2U);
    hash *= 0xff51afd7ed558ccdULL;
  }
  return static_cast<std::size_t>(hash ^ (hash >> 32U)) & (slots_.size() - 1);
}

int FootstepGraph::StanceOf(const std::vector<int>& footholds, int group) {
  std::size_t at = Hash(footholds, group);
  for (; slots_[at] >= 0; at = (at + 1) & (slots_.size() - 1)) {
    const std::span<const int> other = FootholdsOf(slots_[at]);
    if (GroupOf(slots_[at]) == group && std::equal(other.begin(), other.end(), footholds.begin())) return slots_[at];
  }
  const int stance = size();
  slots_[at] = stance;
  footholds_.insert(footholds_.end(), footholds.begin(), footholds.end());
  group_.push_back(group);
  fault_.push_back(-1);
  if (2 * group_.size() > slots_.size()) Grow();
  return stance;
}

void FootstepGraph::Grow() {
  slots_.assign(2 * slots_.size(), -1);
  for (int stance = 0; stance < size(); ++stance) {
    std::size_t at = Hash(FootholdsOf(stance), GroupOf(stance));
    while (slots_[at] >= 0) at = (at + 1) & (slots_.size() - 1);
    slots_[at] = stance;
  }
}

StanceFault FootstepGraph::FaultOf(int stance) {
  int& fault = fault_[static_cast<std::size_t>(stance)];
  if (fault >= 0) return static_cast<StanceFault>(fault);
  const std::span<const int> footholds = FootholdsOf(stance);
  for (std::size_t f = 0; f < num_feet_; ++f) {
    const FootholdChoice& choice = (*table_)[footholds[f]];
    poses_[f] = choice.placed.X_WF;
    outlines_[f] = &choice.outline_W;
  }
  ++checked_;
  const StanceFault found = stances_->Check(poses_, outlines_);
  fault = static_cast<int>(found);
  return found;
}

bool FootstepGraph::IsGoal(int stance) const {
  const std::span<const int> footholds = FootholdsOf(stance);
  return std::all_of(footholds.begin(), footholds.end(), [this](int i) { return (*table_)[i].goal; });
}

double FootstepGraph::Progress(int stance) const {
  double sum = 0.0;
  for (const int foothold : FootholdsOf(stance)) sum += (*table_)[foothold].station_m;
  return sum / static_cast<double>(num_feet_);
}

double FootstepGraph::Heuristic(int stance) const {
  const std::span<const int> footholds = FootholdsOf(stance);
  const double end = query_->route.length_m(), stride = table_->stride_m();
  double left = 0.0;
  for (const std::vector<int>& group : groups_) {
    double sum = 0.0;
    for (const int foot : group) {
      const FootholdChoice& choice = (*table_)[footholds[static_cast<std::size_t>(foot)]];
      if (!choice.goal) sum += std::max(1.0, (end - choice.station_m) / stride);
    }
    left += sum / static_cast<double>(group.size());
  }
  return left;
}

void FootstepGraph::Steps(int stance, std::vector<Edge>& edges, Refusals* refusals) {
  edges.clear();
  Refusals own;
  const std::vector<int>& group = groups_[static_cast<std::size_t>(GroupOf(stance))];
  const double longest = options_.step_length * leg_m_ + table_->offset_m();
  double behind = std::numeric_limits<double>::infinity();
  for (const int foot : group)
    behind = std::min(behind, (*table_)[FootholdsOf(stance)[static_cast<std::size_t>(foot)]].station_m);
  const int first = std::max(0, static_cast<int>(std::floor(behind / table_->step_m())) - 2);
  for (int step = first; step <= table_->num_steps(); ++step) {
    bool near = false;
    for (const int foot : group) {
      const PlanarPose& place = table_->PlaceAtStep(foot, step);
      const FootholdChoice& from = (*table_)[FootholdsOf(stance)[static_cast<std::size_t>(foot)]];
      near = near || (Vector2(place.x_m, place.y_m) - InPlan(from)).norm() < longest;
    }
    if (!near) break;
    StepsTo(stance, step, edges, own);
  }
  if (refusals != nullptr) *refusals = own;
}

void FootstepGraph::StepsTo(int stance, int step, std::vector<Edge>& edges, Refusals& refusals) {
  const std::vector<int>& group = groups_[static_cast<std::size_t>(GroupOf(stance))];
  options_by_member_.resize(group.size());
  for (std::size_t m = 0; m < group.size(); ++m) {
    const std::vector<int>& near = table_->Near(group[m], step);
    if (near.empty()) ++refusals.no_foothold;
    const FootholdChoice& from = (*table_)[FootholdsOf(stance)[static_cast<std::size_t>(group[m])]];
    options_by_member_[m].clear();
    for (const int index : near)
      if (SwingHolds(from, (*table_)[index], refusals)) options_by_member_[m].push_back(index);
    if (options_by_member_[m].empty()) return;
  }
  const std::span<const int> footholds = FootholdsOf(stance);
  std::copy(footholds.begin(), footholds.end(), chosen_.begin());
  const std::size_t budget = group.size() == 1 ? options_by_member_[0].size() : 3;
  Combine(stance, 0, budget, edges);
  if (groups_.size() == 1) CombineLevel(stance, budget, edges);
}

/// For a leap of all feet, combines footholds on one level, which may come late in the order of each foot.
void FootstepGraph::CombineLevel(int stance, std::size_t budget, std::vector<Edge>& edges) {
  const double same_m = kOneLevel * leg_m_;
  const std::vector<std::vector<int>> all = options_by_member_;
  std::vector<double> levels_m;
  for (const int index : all.front()) {
    const double height = HeightOf((*table_)[index]);
    const auto near = [&](double level) { return std::abs(level - height) < same_m; };
    if (std::none_of(levels_m.begin(), levels_m.end(), near)) levels_m.push_back(height);
  }
  for (const double level : levels_m) {
    bool any = true, fewer = false;
    for (std::size_t m = 0; m < all.size(); ++m) {
      std::vector<int>& own = options_by_member_[m];
      own = all[m];
      std::erase_if(own, [&](int index) { return std::abs(HeightOf((*table_)[index]) - level) >= same_m; });
      any = any && !own.empty();
      fewer = fewer || own.size() < all[m].size();
    }
    if (any && fewer) Combine(stance, 0, budget, edges);
  }
}

void FootstepGraph::Combine(int stance, std::size_t member, std::size_t budget, std::vector<Edge>& edges) {
  const int next = GroupOf(stance);
  const std::vector<int>& group = groups_[static_cast<std::size_t>(next)];
  if (member == group.size()) {
    const double cost = CostOf(stance);
    const int to = StanceOf(chosen_, (next + 1) % static_cast<int>(groups_.size()));
    edges.push_back({to, cost});
    return;
  }
  for (std::size_t k = 0; k < options_by_member_[member].size() && k <= budget; ++k) {
    chosen_[static_cast<std::size_t>(group[member])] = options_by_member_[member][k];
    Combine(stance, member + 1, budget - k, edges);
  }
}

double FootstepGraph::LandingTilt() {
  if (groups_.size() > 1) return 0.0;
  for (std::size_t f = 0; f < num_feet_; ++f) poses_[f] = (*table_)[chosen_[f]].placed.X_WF;
  const BaseOverFeet base = stances_->BaseOf(poses_);
  return std::hypot(base.pitch_rad, base.roll_rad);
}

double FootstepGraph::CostOf(int stance) {
  const std::vector<int>& group = groups_[static_cast<std::size_t>(GroupOf(stance))];
  const std::span<const int> from = FootholdsOf(stance);
  const double stride = table_->stride_m(), end = query_->route.length_m();
  const double own = 1.0 / static_cast<double>(group.size());
  double cost = 0.0, reached = 0.0, others = 0.0;
  for (const int foot : group) {
    const FootholdChoice& a = (*table_)[from[static_cast<std::size_t>(foot)]];
    const FootholdChoice& b = (*table_)[chosen_[static_cast<std::size_t>(foot)]];
    const double gain = (b.station_m - a.station_m) / stride;
    cost += std::max(1.0, gain);
    cost += options_.length_weight * std::max(0.0, gain - 1.0);
    const double departure = b.departure_m / table_->offset_m();
    cost += options_.departure_weight * departure * departure;
    cost += options_.height_weight * std::abs(HeightOf(b) - HeightOf(a)) / leg_m_;
    cost += options_.risk_weight * b.placed.risk;
    reached += own * b.station_m;
  }
  for (std::size_t f = 0; f < from.size(); ++f) {
    if (std::find(group.begin(), group.end(), static_cast<int>(f)) == group.end())
      others = std::max(others, (*table_)[from[f]].station_m);
  }
  const double wanted = std::min(table_->advance_m(), end - others);
  const double lead = groups_.size() > 1 ? (reached - others - wanted) / stride : 0.0;
  const double landing = options_.landing_weight > 0.0 ? options_.landing_weight * LandingTilt() : 0.0;
  return own * cost + options_.phase_weight * (std::abs(lead) + lead * lead) + landing;
}

bool FootstepGraph::SwingHolds(const FootholdChoice& from, const FootholdChoice& to, Refusals& refusals) const {
  const double lift = options_.step_height * leg_m_;
  if ((InPlan(to) - InPlan(from)).norm() > options_.step_length * leg_m_) return ++refusals.too_long, false;
  if (std::abs(HeightOf(to) - HeightOf(from)) > lift) return ++refusals.too_high, false;
  if (RiseBetween(from, to) > lift) return ++refusals.riser, false;
  if (!IsFreeBetween(from, to)) return ++refusals.obstacle, false;
  return true;
}

double FootstepGraph::RiseBetween(const FootholdChoice& from, const FootholdChoice& to) const {
  constexpr double kStep = 0.05;  // share of the leg length
  const Vector2 a = InPlan(from), line = InPlan(to) - a;
  const double low = std::min(HeightOf(from), HeightOf(to));
  const Vector2 least = a.cwiseMin(InPlan(to)), most = a.cwiseMax(InPlan(to));
  const double bound = ground_->HighestIn(least, most) - low;
  if (bound <= options_.step_height * leg_m_) return bound;
  const int samples = 1 + static_cast<int>(std::ceil(line.norm() / (kStep * leg_m_)));
  double rise = 0.0;
  for (int i = 0; i <= samples; ++i) {
    const GroundPoint ground = ground_->At(a + static_cast<double>(i) / samples * line);
    if (ground.patch >= 0) rise = std::max(rise, ground.height_m - low);
  }
  return rise;
}

bool FootstepGraph::IsFreeBetween(const FootholdChoice& from, const FootholdChoice& to) const {
  constexpr double kLeg = 0.5;  // height above the foot, as a share of the leg length
  if (ground_->obstacles().empty()) return true;
  Vector2 least = from.outline_W.front(), most = least;
  for (const Polygon* outline : {&from.outline_W, &to.outline_W}) {
    for (const Vector2& p : *outline) {
      least = least.cwiseMin(p);
      most = most.cwiseMax(p);
    }
  }
  std::vector<int> near;
  ground_->ObstaclesIn(least, most, near);
  if (near.empty()) return true;
  Polygon swept = from.outline_W;
  swept.insert(swept.end(), to.outline_W.begin(), to.outline_W.end());
  swept = ConvexHull(swept);
  const double low = std::min(HeightOf(from), HeightOf(to)), high = std::max(HeightOf(from), HeightOf(to));
  return std::none_of(near.begin(), near.end(), [&](int i) {
    const ObstacleOutline& obstacle = ground_->obstacles()[static_cast<std::size_t>(i)];
    if (obstacle.top_m <= low + options_.step_height * leg_m_ || obstacle.bottom_m >= high + kLeg * leg_m_)
      return false;
    return !ApartBy(swept, obstacle.outline_W, 0.0);
  });
}

}  // namespace gaitwright
