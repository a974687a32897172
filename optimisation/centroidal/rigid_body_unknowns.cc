// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_unknowns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "kinematics/base/result.h"
#include "kinematics/trajectory/bspline.h"
#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/centroidal/gait_phases.h"

namespace gaitwright {
namespace {

std::size_t Nearest(const std::vector<double>& times, double t) {
  const auto after = std::lower_bound(times.begin(), times.end(), t - kSameSwitch_s);
  return static_cast<std::size_t>(std::min(after, times.end() - 1) - times.begin());
}

/// Adds sum_i of[i] * (control point first + i) of a detour whose unknowns begin at `start`, two unknowns at a time.
/// `of` holds the coefficients of the spline or of a derivative.
void AddDetour(int start, int points, int first, const std::array<double, 6>& of, FootPlace& place) {
  const auto column = [&](int number) -> Vector3 {
    const int i = number / 3 + kFixedSwingPoints - first;
    if (i < 0 || i >= 6) return Vector3::Zero();
    return of[static_cast<std::size_t>(i)] * Vector3::Unit(number % 3);
  };
  for (int number = 0; number < 3 * points; number += 2) {
    FootPlace::Part part{start + number, {}};
    part.axes << column(number), column(number + 1);
    if (!part.axes.isZero(0.0)) place.parts.push_back(part);
  }
}

}  // namespace

Vector3 FootPlace::At(const VectorX& x) const {
  Vector3 p = constant;
  for (const Part& part : parts) p += part.axes * x.segment<2>(part.start);
  return p;
}

FootPlace& FootPlace::Add(double factor, const FootPlace& other) {
  constant += factor * other.constant;
  for (const Part& part : other.parts) parts.push_back({part.start, factor * part.axes});
  return *this;
}

FootPlace FootPlace::SeenBy(SeenUnknowns& seen) const {
  FootPlace own = *this;
  for (Part& part : own.parts) part.start = seen.See(part.start, 2);
  return own;
}

RigidBodyUnknowns::RigidBodyUnknowns(const RigidBodyProblem& problem, double spacing_s, int least_intervals,
                                     double grid_s)
    : problem_(problem), mean_inertia_(problem.inertia_B.trace() / 3.0) {
  PlaceNodes(spacing_s, least_intervals, grid_s);
  AddAll();
}

RigidBodyUnknowns::RigidBodyUnknowns(const RigidBodyProblem& problem, std::vector<double> nodes_s)
    : problem_(problem), mean_inertia_(problem.inertia_B.trace() / 3.0), nodes_s_(std::move(nodes_s)) {
  if (nodes_s_.size() < 2 ||
      std::adjacent_find(nodes_s_.begin(), nodes_s_.end(), std::greater_equal<>()) != nodes_s_.end())
    throw InvalidArgument("rigid body: two or more nodes at increasing times are needed");
  for (const double t : SwitchTimes(problem)) {
    const double nearest = nodes_s_[Nearest(nodes_s_, t)];
    if (std::abs(nearest - t) > kSameSwitch_s)
      throw InvalidArgument(fmt::format("rigid body: contacts change at {} s, but there is no node at this time", t));
  }
  AddAll();
}

void RigidBodyUnknowns::AddAll() {
  AddCentreOfMass();
  AddTurning();
  AddForces();
  AddFootholds();
  AddDetours();
}

void RigidBodyUnknowns::PlaceNodes(double spacing_s, int least_intervals, double grid_s) {
  const std::vector<double> switches = SwitchTimes(problem_);
  std::vector<int> parts(switches.size() - 1, 1);
  for (const RigidStance& stance : problem_.stances) {
    const std::size_t from = Nearest(switches, stance.start_s), to = Nearest(switches, stance.end_s);
    const double spacing = std::min(spacing_s, (stance.end_s - stance.start_s) / least_intervals);
    for (std::size_t i = from; i < to; ++i) {
      const double length = switches[i + 1] - switches[i];
      parts[i] = std::max(parts[i], static_cast<int>(std::ceil(length / spacing - 1e-6)));
    }
  }
  nodes_s_ = {0.0};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double from = switches[i], to = switches[i + 1];
    for (int part = 1; part < parts[i]; ++part) {
      const double even = from + (to - from) * part / parts[i];
      const double at = grid_s > 0.0 ? grid_s * std::round(even / grid_s) : even;
      if (at > nodes_s_.back() + kSameSwitch_s && at < to - kSameSwitch_s) nodes_s_.push_back(at);
    }
    nodes_s_.push_back(to);
  }
}

AffineVector RigidBodyUnknowns::Next() {
  size_ += 3;
  return AffineVector::Unknown(size_ - 3);
}

const RigidRest* RigidBodyUnknowns::RestTouching(std::size_t first, std::size_t last) const {
  for (const RigidRest& rest : problem_.rests) {
    if (Nearest(nodes_s_, rest.start_s) <= last && Nearest(nodes_s_, rest.end_s) >= first) return &rest;
  }
  return nullptr;
}

void RigidBodyUnknowns::AddCentreOfMass() {
  const std::size_t n = nodes_s_.size() + 2;
  control_.resize(n);
  const double first = (nodes_s_[1] - nodes_s_[0]) / 3.0, last = (nodes_s_[n - 3] - nodes_s_[n - 4]) / 3.0;
  control_[0].constant = problem_.start.p_WC;
  control_[1].constant = problem_.start.p_WC + first * problem_.start.v_WC;
  for (std::size_t i = 2; i + 2 < n; ++i) {
    // The interval between a node and the next one depends on the node's control point and on the three after it.
    const RigidRest* rest = RestTouching(i - 2, i);
    control_[i] = rest == nullptr ? Next() : AffineVector{rest->p_WC};
  }
  control_[n - 2].constant = problem_.goal.p_WC - last * problem_.goal.v_WC;
  control_[n - 1].constant = problem_.goal.p_WC;
}

void RigidBodyUnknowns::AddTurning() {
  const auto momentum = [&](const RigidBodyState& state) -> Vector3 {
    return RotationOf(state.angles_rad) * problem_.inertia_B * state.w_WB_B / mean_inertia_;
  };
  const std::size_t n = nodes_s_.size();
  angles_.resize(n);
  momentum_.resize(n);
  angles_[0].constant = problem_.start.angles_rad;
  momentum_[0].constant = momentum(problem_.start);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const RigidRest* rest = RestTouching(k, k);
    angles_[k] = rest == nullptr ? Next() : AffineVector{rest->angles_rad};
    momentum_[k] = rest == nullptr ? Next() : AffineVector{};
  }
  angles_[n - 1].constant = problem_.goal.angles_rad;
  momentum_[n - 1].constant = momentum(problem_.goal);
}

void RigidBodyUnknowns::AddFootholds() {
  for (const RigidStance& stance : problem_.stances) {
    FootPlace place{stance.X_WF.translation()};
    if (!stance.held) {
      place.parts.push_back({size_, stance.X_WF.linear().leftCols<2>()});
      size_ += 2;
    }
    footholds_.push_back(place);
  }
}

void RigidBodyUnknowns::AddDetours() {
  for (const RigidSwing& swing : problem_.swings) {
    detours_.push_back(size_);
    size_ += swing.unknowns();
  }
}

FootPlace RigidBodyUnknowns::InSwing(std::size_t swing, double share) const {
  const RigidSwing& of = problem_.swings[swing];
  const double gone = of.GoneAt(share);
  FootPlace place;
  place.Add(1.0 - gone, footholds_[of.from]).Add(gone, footholds_[of.to]);
  if (!of.free) {
    place.constant += of.OffAt(share);
    return place;
  }
  const int points = static_cast<int>(of.detour_W.size());
  const QuinticBasis basis = EvaluateQuinticBasis(points + 2 * kFixedSwingPoints, share);
  AddDetour(detours_[swing], points, basis.first, basis.value, place);
  return place;
}

FootPlace RigidBodyUnknowns::InSwingAcceleration(std::size_t swing, double share) const {
  const RigidSwing& of = problem_.swings[swing];
  const double change = SmoothStep(share, of.cruise).acceleration;
  FootPlace place;
  place.Add(-change, footholds_[of.from]).Add(change, footholds_[of.to]);
  const int points = static_cast<int>(of.detour_W.size());
  const QuinticBasis basis = EvaluateQuinticBasis(points + 2 * kFixedSwingPoints, share);
  AddDetour(detours_[swing], points, basis.first, basis.acceleration, place);
  return place;
}

FootPlace RigidBodyUnknowns::ContactPoint(std::size_t stance, std::size_t point) const {
  FootPlace place = footholds_[stance];
  const RigidStance& of = problem_.stances[stance];
  place.constant += of.X_WF.linear() * problem_.feet[static_cast<std::size_t>(of.foot)].contacts_F[point];
  return place;
}

AffineVector RigidBodyUnknowns::CentreOfMass(double time_s) const {
  const CubicBasis basis = EvaluateCubicBasis(nodes_s_, time_s);
  AffineVector p;
  for (std::size_t i = 0; i < 4; ++i) p.Add(basis.value[i], control_[static_cast<std::size_t>(basis.first) + i]);
  return p;
}

AffineVector RigidBodyUnknowns::Velocity(double time_s) const {
  const CubicBasis basis = EvaluateCubicBasis(nodes_s_, time_s);
  AffineVector v;
  for (std::size_t i = 0; i < 4; ++i) v.Add(basis.rate[i], control_[static_cast<std::size_t>(basis.first) + i]);
  return v;
}

AffineVector RigidBodyUnknowns::WholeForce(std::size_t at_node) const {
  const CubicBasis basis = EvaluateCubicBasis(nodes_s_, nodes_s_[at_node]);
  AffineVector force{Vector3::UnitZ()};
  const bool last = at_node + 1 == nodes_s_.size();
  for (std::size_t i = last ? 1 : 0; i < (last ? 4 : 3); ++i)
    force.Add(basis.acceleration[i] / kGravity, control_[static_cast<std::size_t>(basis.first) + i]);
  return force;
}

std::vector<BoundForce> RigidBodyUnknowns::Carry(const std::vector<std::size_t>& stances, std::size_t at_node) {
  std::vector<BoundForce> carried;
  AffineVector rest = WholeForce(at_node);
  for (const std::size_t s : stances) {
    const auto foot = static_cast<std::size_t>(problem_.stances[s].foot);
    for (std::size_t point = 0; point < problem_.feet[foot].contacts_F.size(); ++point) {
      const bool last = s == stances.back() && point + 1 == problem_.feet[foot].contacts_F.size();
      carried.push_back({s, point, at_node, last ? rest : Next()});
      rest.Add(-1.0, carried.back().force);
    }
  }
  return carried;
}

void RigidBodyUnknowns::AddForces() {
  const std::size_t n = nodes_s_.size();
  std::vector<std::size_t> from, to;
  for (const RigidStance& stance : problem_.stances) {
    from.push_back(Nearest(nodes_s_, stance.start_s));
    to.push_back(Nearest(nodes_s_, stance.end_s));
  }
  std::map<std::array<std::size_t, 3>, AffineVector> at;  // by stance, point and node
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<std::size_t> through, ending, starting;
    for (std::size_t s = 0; s < from.size(); ++s) {
      const bool before = from[s] < k || k == 0, after = to[s] > k || k + 1 == n;
      if (from[s] <= k && to[s] >= k) (before && after ? through : before ? ending : starting).push_back(s);
    }
    if (through.empty() && (ending.empty() || starting.empty())) {
      free_nodes_.push_back(k);
      continue;
    }
    std::vector<BoundForce> carried = Carry(through.empty() ? ending : through, k);
    if (through.empty()) {
      const std::vector<BoundForce> others = Carry(starting, k);
      carried.insert(carried.end(), others.begin(), others.end());
    }
    for (const BoundForce& force : carried) at[{force.stance, force.point, k}] = force.force;
    bound_forces_.insert(bound_forces_.end(), carried.begin(), carried.end());
  }
  forces_.resize(n - 1);
  for (std::size_t s = 0; s < from.size(); ++s) {
    const auto foot = static_cast<std::size_t>(problem_.stances[s].foot);
    for (std::size_t k = from[s]; k < to[s]; ++k) {
      for (std::size_t point = 0; point < problem_.feet[foot].contacts_F.size(); ++point)
        forces_[k].push_back({s, point, at[{s, point, k}], at[{s, point, k + 1}]});
    }
  }
}

}  // namespace gaitwright
