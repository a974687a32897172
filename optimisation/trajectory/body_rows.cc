// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "optimisation/trajectory/body_rows_internal.h"

namespace gaitwright {
namespace {

using Eigen::Index;

constexpr double kUnit = 0.01;       // [s] of time that weights are for
constexpr double kToMargin = 0.3;    // [s] in which joints that stand at the end of their range come to its margin
constexpr double kOfLanding = 0.18;  // of the way from the standing posture: largest margin for landings
constexpr double kStill = 100.0;     // of weights of joints that stick

/// A side of the pyramid inside a friction cone: the force along it is at most zero.
Vector3 SideOf(const PressingFoot& foot, int side) {
  const double angle = 2.0 * std::numbers::pi * side / kPyramidSides;
  return foot.axes_W *
         Vector3(std::cos(angle), std::sin(angle), -foot.friction * std::cos(std::numbers::pi / kPyramidSides));
}

}  // namespace

BodyRows::BodyRows(const BodyProblem& problem, const VectorX& start)
    : problem_(problem),
      model_(*problem.model),
      spline_(problem.spline()),
      motors_(*problem.model, problem.use),
      knot_model_(*problem.model),
      n_(problem.model->nv()),
      chain_(n_, spline_.points()) {
  for (int d = 0; d < model_.num_dofs(); ++d) {
    if (std::isfinite(model_.dof_lower(d)) || std::isfinite(model_.dof_upper(d)) || problem_.StaysStill(d))
      ranged_.push_back(d);
  }
  ListRows();
  if (start.size() != size()) throw InvalidArgument("BodyRows: the start does not have the size of the unknowns");
  Evaluate(start);
  Differentiate();
}

void BodyRows::ListRows() {
  const std::vector<double>& times = spline_.times_s();
  points_size_ = n_ * spline_.points();
  knots_.resize(times.size());
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    const double before = k > 0 ? times[k] - times[k - 1] : 0.0,
                 after = k + 1 < times.size() ? times[k + 1] - times[k] : 0.0;
    of_knot_.push_back(Asked(k).is_given ? 0.0 : std::sqrt(0.5 * (before + after) / kUnit));
    basis_.push_back(spline_.At(static_cast<int>(k)));
    Knot& knot = knots_[k];
    knot.force = points_size_ + forces_size_;
    for (const PressingFoot& foot : Asked(k).pressing) {
      knot.contacts.push_back(foot.contact);
      knot.forces += static_cast<Index>(3 * foot.contact.points_F.size());
    }
    forces_size_ += knot.forces;
    for (int kind = kNear; kind < kDynamics; ++kind) {
      knot.row[kind] = residuals_;
      residuals_ += CountOf(knot, Asked(k), static_cast<Kind>(kind));
    }
    knot.residual_end = residuals_;
  }
  share_ = of_knot_;
  Index rows = residuals_;
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    Knot& knot = knots_[k];
    for (int kind = kDynamics; kind < kKinds; ++kind) {
      knot.row[kind] = rows;
      rows += CountOf(knot, Asked(k), static_cast<Kind>(kind));
    }
    knot.row[kKinds] = rows;
    knot.y = VectorX::Zero(3 * n_ + knot.forces);
    knot.dense = VectorX::Zero(6 + motors_.count() + powers());
    knot.D = MatrixX::Zero(knot.dense.size(), knot.y.size());
    knot.posture = VectorX::Zero(CountOf(knot, Asked(k), kFeet) + CountOf(knot, Asked(k), kApart) +
                                 CountOf(knot, Asked(k), kPoint));
    knot.J = MatrixX::Zero(knot.posture.size(), n_);
    if (CountOf(knot, Asked(k), kFeet) > 0) knot.feet_within = WithinOf(Asked(k));
  }
  value_ = VectorX::Zero(rows);
}

Index BodyRows::CountOf(const Knot& knot, const BodyKnot& asked, Kind kind) const {
  switch (kind) {
    case kNear:
    case kNearAcceleration:
      return n_;
    case kEffort:
      return motors_.count();
    case kForce:
      return knot.forces;
    case kPower:
      return powers();
    case kPoint:
      return asked.pins_place ? 0 : static_cast<Index>(3 * asked.points.size());
    case kDynamics:
      return asked.is_given ? 0 : 6;
    case kFeet: {
      if (asked.pins_place) return 0;
      Index rows = 0;
      for (const FootGoal& goal : asked.feet) rows += goal.count();
      return rows;
    }
    case kEffortLimit:
      return asked.is_given ? 0 : static_cast<Index>(motors_.limited().size());
    case kCurve:
      return asked.pins_motion ? 0 : static_cast<Index>(motors_.curves().size());
    case kRange:
      return asked.pins_place ? 0 : static_cast<Index>(ranged_.size());
    case kCone:
      return knot.forces / 3 * kPyramidSides;
    case kApart:
      return asked.pins_place ? 0 : static_cast<Index>(asked.apart.size());
    case kPinnedPlace:
      return asked.pins_place ? n_ : 0;
    case kPinnedMotion:
      return asked.pins_motion ? 2 * n_ : 0;
    case kKinds:
      break;
  }
  return 0;
}

RowBounds BodyRows::BoundsOf(Index row) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto above = std::upper_bound(knots_.begin(), knots_.end(), row,
                                      [](Index r, const Knot& knot) { return r < knot.row[kDynamics]; });
  const Knot& knot = *(above - 1);
  if (row >= knot.row[kEffortLimit] && row < knot.row[kRange]) return {-1.0, 1.0};
  if (row >= knot.row[kRange] && row < knot.row[kCone]) {
    const int dof = ranged_[static_cast<std::size_t>(row - knot.row[kRange])];
    if (problem_.StaysStill(dof)) {
      const double place = problem_.knots.front().reference.x[6 + dof];
      return {place, place};
    }
    const double lower = model_.dof_lower(dof), upper = model_.dof_upper(dof);
    const double standing = std::clamp(model_.standing_joints[dof], lower, upper);
    const double margin = std::min(problem_.use.range_margin, 0.25 * (upper - lower));
    const auto margin_to = [&](double end) {
      return std::max(margin, std::min(problem_.use.landing_margin, kOfLanding * std::abs(end - standing)));
    };
    const double now_s = problem_.time_s[static_cast<std::size_t>(&knot - knots_.data())];
    const double ramp = std::min(1.0, std::min(now_s - problem_.start_s(), problem_.end_s() - now_s) / kToMargin);
    const double low = lower + margin_to(lower), high = upper - margin_to(upper);
    return {low + (1.0 - ramp) * std::min(0.0, standing - low), high + (1.0 - ramp) * std::max(0.0, standing - high)};
  }
  if (row >= knot.row[kFeet] && row < knot.row[kEffortLimit]) {
    const double within = kFootUnit * knot.feet_within[row - knot.row[kFeet]];
    return {-within, within};
  }
  if (row >= knot.row[kCone] && row < knot.row[kApart]) return {-kNone, -problem_.use.cone_margin};
  if (row >= knot.row[kApart] && row < knot.row[kPinnedPlace]) {
    const std::vector<ApartPair>& apart = Asked(static_cast<std::size_t>(&knot - knots_.data())).apart;
    return {kApartUnit * problem_.use.apart * apart[static_cast<std::size_t>(row - knot.row[kApart])].least_m, kNone};
  }
  return {0.0, 0.0};
}

std::string BodyRows::NameOf(Index row) const {
  const auto above = std::upper_bound(knots_.begin(), knots_.end(), row,
                                      [](Index r, const Knot& knot) { return r < knot.row[kDynamics]; });
  const auto k = static_cast<std::size_t>(above - knots_.begin() - 1);
  const Knot& knot = knots_[k];
  const auto at = [&](Kind kind) { return static_cast<std::size_t>(row - knot.row[kind]); };
  const auto motor = [&](int index) { return motors_.motors()[static_cast<std::size_t>(index)].name; };
  const auto within = [&](Kind kind) { return row >= knot.row[kind] && row < knot.row[kind + 1]; };
  std::string what = "start and end";
  if (within(kDynamics)) what = at(kDynamics) < 3 ? "balance of forces" : "balance of moments";
  if (within(kEffortLimit)) what = fmt::format("torque of '{}'", motor(motors_.limited()[at(kEffortLimit)]));
  if (within(kCurve)) {
    const MotorRows::Curve& curve = motors_.curves()[at(kCurve)];
    what = fmt::format("{} of '{}'", curve.by_effort > 0.0 ? "torque at speed" : "speed", motor(curve.motor));
  }
  if (within(kRange))
    what = fmt::format("position of '{}'", model_.dof_names[static_cast<std::size_t>(ranged_[at(kRange)])]);
  const auto foot_name = [&](int foot) { return model_.feet[static_cast<std::size_t>(foot)].name; };
  if (within(kFeet)) {
    Index left = row - knot.row[kFeet];
    for (const FootGoal& goal : Asked(k).feet) {
      if (left >= 0 && left < goal.count())
        what = fmt::format("{} of foot '{}'", goal.swings ? "swing" : "foothold", foot_name(goal.foot));
      left -= goal.count();
    }
  }
  if (within(kApart)) what = fmt::format("distance of {}", problem_.distances->NameOf(Asked(k).apart[at(kApart)].pair));
  if (within(kCone)) {
    Index left = (row - knot.row[kCone]) / kPyramidSides;
    for (const PressingFoot& foot : Asked(k).pressing) {
      const auto points = static_cast<Index>(foot.contact.points_F.size());
      if (left >= 0 && left < points) what = fmt::format("friction cone of foot '{}'", foot_name(foot.contact.foot));
      left -= points;
    }
  }
  return fmt::format("{} at {:.3f} s", what, problem_.time_s[k]);
}

std::vector<double> BodyRows::TimesUnmet(double tolerance) const {
  std::vector<double> times;
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    for (Index row = knots_[k].row[kDynamics]; row < knots_[k].row[kKinds]; ++row) {
      const RowBounds bounds = BoundsOf(row);
      if (value_[row] >= bounds.lower - tolerance && value_[row] <= bounds.upper + tolerance) continue;
      times.push_back(problem_.time_s[k]);
      break;
    }
  }
  return times;
}

/// Factor of the weights of a joint's coordinate.
double BodyRows::StillnessOf(Index i) const { return motors_.Sticks(static_cast<int>(i - 6)) ? kStill : 1.0; }

double BodyRows::NearWeight(std::size_t k, Index i) const {
  const BodyWeights& w = problem_.weights;
  const double scale = Asked(k).near_scale.size() > 0 ? Asked(k).near_scale[i] : 1.0;
  return scale * (i < 3 ? w.base_position : i < 6 ? w.base_rotation : StillnessOf(i) * w.joint);
}

double BodyRows::AccelerationWeight(Index i) const {
  const BodyWeights& w = problem_.weights;
  return i < 6 ? w.base_acceleration : StillnessOf(i) * w.joint_acceleration;
}

void BodyRows::SetState(Knot& knot, ChartedState& state) {
  StateOf(problem_.chart, {knot.y.head(n_), knot.y.segment(n_, n_), knot.y.segment(2 * n_, n_)}, state);
}

void BodyRows::Evaluate(const VectorX& z) {
  const double weight = model_.weight_n(), moment = weight * model_.leg_length_m();
  ChartedState state;
  VectorX needed;
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    Knot& knot = knots_[k];
    Flat(k, z, knot.y);
    SetState(knot, state);
    knot_model_.Evaluate(state.q, state.v, state.a, knot.contacts, weight * knot.y.tail(knot.forces), needed);
    knot.dense.head<3>() = needed.head<3>() / weight;
    knot.dense.segment<3>(3) = needed.segment<3>(3) / moment;
    motors_.Efforts(needed.tail(n_ - 6), state.v.tail(n_ - 6), state.a.tail(n_ - 6),
                    knot.dense.segment(6, motors_.count()));
    EvaluatePower(knot);
    EvaluatePosture(knot, Asked(k), nullptr);
    FillRows(k, knot.y, knot.dense, knot.posture, true, value_);
  }
}

void BodyRows::Differentiate() {
  const double weight = model_.weight_n(), moment = weight * model_.leg_length_m();
  const Index joints = n_ - 6, m = motors_.count();
  ChartedState state;
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    Knot& knot = knots_[k];
    SetState(knot, state);
    knot_model_.Differentiate(state.q, state.v, state.a, knot.contacts, weight * knot.y.tail(knot.forces), forces_);
    const auto set = [&](Index column, const MatrixX& by, double unit) {
      auto block = knot.D.middleCols(column, by.cols());
      block.topRows<3>() = unit / weight * by.topRows<3>();
      block.middleRows<3>(3) = unit / moment * by.middleRows<3>(3);
      motors_.ToMotors(by.bottomRows(joints), block.middleRows(6, m));
      if (unit != 1.0) block.middleRows(6, m) *= unit;
    };
    set(0, forces_.by_q, 1.0);
    set(n_, forces_.by_v, 1.0);
    set(2 * n_, forces_.by_a, 1.0);
    set(3 * n_, forces_.by_force, weight);
    motors_.AddLosses(knot.D.block(6, n_ + 6, m, joints), knot.D.block(6, 2 * n_ + 6, m, joints));
    auto by_q = knot.D.middleCols<3>(3), by_v = knot.D.middleCols<3>(n_ + 3), by_a = knot.D.middleCols<3>(2 * n_ + 3);
    by_q = (by_q * state.turn.E + by_v * state.turn.w_by_x + by_a * state.turn.alpha_by_x).eval();
    by_v = (by_v * state.turn.E + by_a * state.turn.alpha_by_rate).eval();
    by_a = (by_a * state.turn.E).eval();
    DifferentiatePower(knot);
    EvaluatePosture(knot, Asked(k), &state);
  }
}

/// The rows of a knot at y, or without constants their changes by y.
void BodyRows::FillRows(std::size_t k, const VectorX& y, const VectorX& dense, const VectorX& posture, bool constants,
                        VectorX& rows) const {
  const Knot& knot = knots_[k];
  const BodyKnot& asked = Asked(k);
  const VectorJet& reference = asked.reference;
  const double constant = constants ? 1.0 : 0.0;
  const auto x = y.head(n_), rate = y.segment(n_, n_), acceleration = y.segment(2 * n_, n_);
  for (Index i = 0; i < n_; ++i) {
    rows[knot.row[kNear] + i] = share_[k] * NearWeight(k, i) * (x[i] - constant * reference.x[i]);
    rows[knot.row[kNearAcceleration] + i] =
        share_[k] * AccelerationWeight(i) * (acceleration[i] - constant * reference.acceleration[i]);
  }
  const Index m = motors_.count();
  rows.segment(knot.row[kEffort], m) = share_[k] * problem_.weights.effort * dense.segment(6, m);
  rows.segment(knot.row[kPower], powers()) = share_[k] * problem_.weights.power * dense.tail(powers());
  rows.segment(knot.row[kForce], knot.forces) = share_[k] * problem_.weights.force * y.tail(knot.forces);
  if (asked.is_given) {
    FillPins(knot, asked, y, constant, rows);
    return;
  }
  rows.segment<6>(knot.row[kDynamics]) = dense.head<6>();
  rows.segment<3>(knot.row[kDynamics]) -= constant / model_.weight_n() * asked.residual_W.head<3>();
  rows.segment<3>(knot.row[kDynamics] + 3) -=
      constant / (model_.weight_n() * model_.leg_length_m()) * asked.residual_W.tail<3>();
  const Index feet = knot.row[kFeet + 1] - knot.row[kFeet], apart = knot.row[kApart + 1] - knot.row[kApart],
              points = posture.size() - feet - apart;
  rows.segment(knot.row[kFeet], feet) = posture.head(feet);
  rows.segment(knot.row[kApart], apart) = posture.segment(feet, apart);
  rows.segment(knot.row[kPoint], points) = share_[k] * posture.tail(points);
  Index row = knot.row[kEffortLimit];
  for (const int motor : motors_.limited()) rows[row++] = dense[6 + motor];
  for (const MotorRows::Curve& curve : motors_.curves()) {
    if (row == knot.row[kRange]) break;
    const Actuator& motor = motors_.motors()[static_cast<std::size_t>(curve.motor)];
    rows[row++] = curve.by_effort * dense[6 + curve.motor] + motor.Speed(rate.tail(n_ - 6)) / curve.speed_scale;
  }
  for (Index i = 0; i < knot.row[kCone] - knot.row[kRange]; ++i)
    rows[knot.row[kRange] + i] = x[6 + ranged_[static_cast<std::size_t>(i)]];
  row = knot.row[kCone];
  Index force = 3 * n_;
  for (const PressingFoot& foot : asked.pressing) {
    for (std::size_t p = 0; p < foot.contact.points_F.size(); ++p, force += 3) {
      for (int side = 0; side < kPyramidSides; ++side) rows[row++] = SideOf(foot, side).dot(y.segment<3>(force));
    }
  }
  FillPins(knot, asked, y, constant, rows);
}

void BodyRows::FillPins(const Knot& knot, const BodyKnot& asked, const VectorX& y, double constant,
                        VectorX& rows) const {
  const VectorJet& reference = asked.reference;
  if (asked.pins_place) rows.segment(knot.row[kPinnedPlace], n_) = y.head(n_) - constant * reference.x;
  if (!asked.pins_motion) return;
  rows.segment(knot.row[kPinnedMotion], n_) = y.segment(n_, n_) - constant * reference.rate;
  rows.segment(knot.row[kPinnedMotion] + n_, n_) = y.segment(2 * n_, n_) - constant * reference.acceleration;
}

void BodyRows::Flat(std::size_t k, const VectorX& z, VectorX& y) const {
  const Knot& knot = knots_[k];
  const KnotBasis& basis = basis_[k];
  y.setZero(3 * n_ + knot.forces);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto point = z.segment(static_cast<Index>(k + i) * n_, n_);
    y.head(n_) += basis.value[i] * point;
    y.segment(n_, n_) += basis.rate[i] * point;
    y.segment(2 * n_, n_) += basis.acceleration[i] * point;
  }
  y.tail(knot.forces) = z.segment(knot.force, knot.forces);
}

VectorX BodyRows::Moved(const VectorX& by) const {
  VectorX moved = VectorX::Zero(count());
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    const Knot& knot = knots_[k];
    Flat(k, by, flat_);
    dense_.noalias() = knot.D * flat_;
    posture_.noalias() = knot.J * flat_.head(n_);
    FillRows(k, flat_, dense_, posture_, false, moved);
  }
  return moved;
}

MatrixX BodyRows::PointsOf(const VectorX& z) const { return Eigen::Map<const MatrixX>(z.data(), n_, spline_.points()); }

std::vector<VectorX> BodyRows::ForcesOf(const VectorX& z) const {
  std::vector<VectorX> forces;
  for (const Knot& knot : knots_) forces.emplace_back(z.segment(knot.force, knot.forces));
  return forces;
}

VectorX Unknowns(const MatrixX& points, const std::vector<VectorX>& forces) {
  Index size = points.size();
  for (const VectorX& of : forces) size += of.size();
  VectorX z(size);
  z.head(points.size()) = Eigen::Map<const VectorX>(points.data(), points.size());
  Index at = points.size();
  for (const VectorX& of : forces) {
    z.segment(at, of.size()) = of;
    at += of.size();
  }
  return z;
}

}  // namespace gaitwright
