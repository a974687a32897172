// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "optimisation/trajectory/body_rows_internal.h"

namespace gaitwright {
namespace {

using Eigen::Index;

constexpr double kUnit = 0.01;    // [s] of time that weights are for
constexpr double kTieTime = 0.1;  // [s] by which rates of ties are multiplied, and accelerations twice
constexpr double kStill = 100.0;  // of weights of joints that stick

/// A side of the pyramid inside a friction cone: the force along it is at most zero.
Vector3 SideOf(const PressingFoot& foot, int side) {
  const double angle = 2.0 * std::numbers::pi * side / kPyramidSides;
  return foot.axes_W *
         Vector3(std::cos(angle), std::sin(angle), -foot.friction * std::cos(std::numbers::pi / kPyramidSides));
}

std::vector<int> JointsWithJerkLimit(const BodyProblem& problem) {
  std::vector<int> dofs;
  for (int d = 0; d < problem.model->num_dofs(); ++d) {
    if (problem.limits_jerk && std::isfinite(problem.model->MotorOf(d).jerk_limit)) dofs.push_back(d);
  }
  return dofs;
}

}  // namespace

BodyRows::BodyRows(const BodyProblem& problem, const VectorX& start)
    : problem_(problem),
      model_(*problem.model),
      spline_(problem.spline()),
      motors_(*problem.model, problem.use),
      knot_model_(*problem.model),
      n_(problem.model->nv()),
      jerked_(JointsWithJerkLimit(problem)),
      chain_(n_, spline_.points(), jerked_.empty() ? 2 : 3) {
  for (int d = 0; d < model_.num_dofs(); ++d) {
    if (std::isfinite(model_.dof_lower(d)) || std::isfinite(model_.dof_upper(d)) || problem_.StaysStill(d))
      ranged_.push_back(d);
    if (std::isfinite(model_.MotorOf(d).acceleration_limit)) accelerated_.push_back(d);
  }
  effort_factor_ = VectorX::Ones(motors_.count());
  for (std::size_t m = 0; m < problem.weights.effort_of.size(); ++m)
    effort_factor_[static_cast<Index>(m)] = problem.weights.effort_of[m];
  tie_unit_.resize(3 * n_);
  tie_unit_ << VectorX::Ones(n_), VectorX::Constant(n_, kTieTime), VectorX::Constant(n_, kTieTime * kTieTime);
  for (const BodyKnot& knot : problem.knots) {
    if (!knot.tie) continue;
    if (!problem.chart.yaw_first())
      throw InvalidArgument("BodyRows: periodic motions need a chart that turns by yaw first");
    cycles_.resize(std::max(cycles_.size(), static_cast<std::size_t>(knot.tie->cycle) + 1), VectorX::Zero(3 * n_));
  }
  ListRows();
  if (start.size() != size())
    throw InvalidArgument("BodyRows: the number of starting values differs from the number of unknowns");
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
    if (CountOf(knot, Asked(k), kFeet) > 0) knot.of_feet = FootBoundsOf(Asked(k));
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
    case kAcceleration:
      return asked.pins_motion ? 0 : static_cast<Index>(accelerated_.size());
    case kRange:
      return asked.pins_place ? 0 : static_cast<Index>(ranged_.size());
    case kCone:
      return knot.forces / 3 * kPyramidSides;
    case kApart:
      if (asked.pins_place) return 0;
      return std::accumulate(asked.apart.begin(), asked.apart.end(), Index{0}, [&](Index rows, const ApartPair& pair) {
        return rows + problem_.distances->num_points(pair.pair);
      });
    case kPinnedPlace:
      return asked.pins_place ? n_ : 0;
    case kPinnedMotion:
      return asked.pins_motion ? 2 * n_ : 0;
    case kTied:
      return asked.tie ? 3 * n_ : 0;
    case kJerk:
      return &knot == &knots_.front() || asked.is_given ? 0 : static_cast<Index>(jerked_.size());
    case kKinds:
      break;
  }
  return 0;
}

/// [rad/s^2], [m/s^2] that a joint may use.
double BodyRows::MostAcceleration(int dof) const { return problem_.use.speed * model_.MotorOf(dof).acceleration_limit; }

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
    if (k > 0) FillJerks(k, knots_[k - 1].y.segment(2 * n_, n_), knot.y.segment(2 * n_, n_), value_);
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
  rows.segment(knot.row[kEffort], m) =
      share_[k] * problem_.weights.effort * dense.segment(6, m).cwiseProduct(effort_factor_);
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
    if (row == knot.row[kAcceleration]) break;
    const Actuator& motor = motors_.motors()[static_cast<std::size_t>(curve.motor)];
    rows[row++] = curve.by_effort * dense[6 + curve.motor] + motor.Speed(rate.tail(n_ - 6)) / curve.speed_scale;
  }
  for (Index i = 0; i < knot.row[kRange] - knot.row[kAcceleration]; ++i) {
    const int dof = accelerated_[static_cast<std::size_t>(i)];
    rows[knot.row[kAcceleration] + i] = acceleration[6 + dof] / MostAcceleration(dof);
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
  if (asked.tie) {
    const VectorX& state = cycles_[static_cast<std::size_t>(asked.tie->cycle)];
    rows.segment(knot.row[kTied], 3 * n_) =
        tie_unit_.cwiseProduct(y.head(3 * n_) - constant * StateOfTie(*asked.tie, state, 1.0));
  }
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
    if (k > 0) FillJerks(k, before_, flat_.segment(2 * n_, n_), moved);
    before_ = flat_.segment(2 * n_, n_);
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
