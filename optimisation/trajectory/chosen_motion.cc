// SPDX-License-Identifier: BSD-3-Clause
// Rows of a knot that depend on what is chosen beside its motion: the pace, shifts of feet, and states of cycles; and
// the motors' powers.
#include <cmath>
#include <utility>

#include "kinematics/spatial/rotation.h"
#include "optimisation/trajectory/body_rows_internal.h"

namespace gaitwright {
namespace {

using Eigen::Index;

/// [N m/s] that is one unit of a motor's power.
double PowerUnit(const RobotModel& model) { return model.weight_n() * std::sqrt(kGravity * model.leg_length_m()); }

}  // namespace

void BodyRows::EvaluatePower(Knot& knot) {
  const double unit = PowerUnit(model_);
  for (Index m = 0; m < powers(); ++m) {
    const Actuator& motor = motors_.motors()[static_cast<std::size_t>(m)];
    const double effort = motors_.EffortOf(static_cast<int>(m)) * knot.dense[6 + m];
    knot.dense[6 + powers() + m] = effort * motor.Speed(knot.y.segment(n_ + 6, n_ - 6)) / unit;
  }
}

void BodyRows::DifferentiatePower(Knot& knot) {
  const double unit = PowerUnit(model_);
  for (Index m = 0; m < powers(); ++m) {
    const Actuator& motor = motors_.motors()[static_cast<std::size_t>(m)];
    const double scale = motors_.EffortOf(static_cast<int>(m)) / unit;
    auto row = knot.D.row(6 + powers() + m);
    row = scale * motor.Speed(knot.y.segment(n_ + 6, n_ - 6)) * knot.D.row(6 + m);
    for (const Actuator::Term& term : motor.terms) row[n_ + 6 + term.dof] += scale * knot.dense[6 + m] * term.by_speed;
  }
}

void BodyRows::SetChosen(const std::vector<KnotPace>& paces, const std::vector<std::vector<Vector3>>& shifts_W) {
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    knots_[k].pace = paces[k];
    basis_[k] = AtPace(spline_.At(static_cast<int>(k)), paces[k]);
    share_[k] = of_knot_[k] / std::sqrt(paces[k].rate);
    knots_[k].shift_W = shifts_W[k];
  }
}

void BodyRows::MovedByPace(std::size_t k, const KnotPace& by, VectorX& rows) const {
  const Knot& knot = knots_[k];
  const double faster = by.rate / knot.pace.rate;
  flat_.setZero(3 * n_ + knot.forces);
  const auto rate = knot.y.segment(n_, n_);
  flat_.segment(n_, n_) = faster * rate;
  flat_.segment(2 * n_, n_) = 2.0 * faster * knot.y.segment(2 * n_, n_) + (by.slope - faster * knot.pace.slope) * rate;
  dense_.noalias() = knot.D * flat_;
  posture_.setZero(knot.posture.size());
  FillRows(k, flat_, dense_, posture_, false, rows);
  const auto [residuals, constraints] = RowsOf(k);
  const Index count = residuals.second - residuals.first;
  rows.segment(residuals.first, count) -= 0.5 * faster * value_.segment(residuals.first, count);
}

void BodyRows::MovedByShift(std::size_t k, std::size_t goal, const Vector3& by_W, VectorX& rows) const {
  const auto [residuals, constraints] = RowsOf(k);
  rows.segment(residuals.first, residuals.second - residuals.first).setZero();
  rows.segment(constraints.first, constraints.second - constraints.first).setZero();
  if (Asked(k).pins_place) return;
  Index row = knots_[k].row[kFeet];
  for (std::size_t g = 0; g < goal; ++g) row += Asked(k).feet[g].count();
  const FootGoal& of = Asked(k).feet[goal];
  for (std::size_t i = 0; i < 3; ++i) {
    if (of.rows[i]) rows[row++] = -kFootUnit * of.axes_W.col(static_cast<Index>(i)).dot(by_W);
  }
}

void BodyRows::SetCycles(std::vector<VectorX> states) {
  if (states.size() != cycles_.size()) throw InvalidArgument("BodyRows: a state is needed for each cycle");
  cycles_ = std::move(states);
}

VectorX BodyRows::StateAt(std::size_t k, const VectorX& z) const {
  const KnotBasis& basis = spline_.At(static_cast<int>(k));
  VectorX state = VectorX::Zero(3 * n_);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto point = z.segment(static_cast<Index>(k + i) * n_, n_);
    state.head(n_) += basis.value[i] * point;
    state.segment(n_, n_) += basis.rate[i] * point;
    state.tail(n_) += basis.acceleration[i] * point;
  }
  return state;
}

/// The state at a tied knot; without its constants if `constant` is 0.
VectorX BodyRows::StateOfTie(const CycleTie& tie, const VectorX& state, double constant) const {
  VectorX tied = state;
  const Matrix3 R = YawRotation(tie.yaw_rad);
  for (const Index at : {Index{0}, n_, 2 * n_}) tied.segment<3>(at) = R * state.segment<3>(at);
  tied.head<3>() += constant * tie.move_W;
  tied[3] += constant * tie.yaw_rad;
  return tied;
}

void BodyRows::MovedByCycle(std::size_t k, const VectorX& by_state, VectorX& rows) const {
  for (const auto& [first, end] : RowsOf(k)) rows.segment(first, end - first).setZero();
  rows.segment(knots_[k].row[kTied], 3 * n_) = -tie_unit_.cwiseProduct(StateOfTie(*Asked(k).tie, by_state, 0.0));
}

std::array<std::pair<Index, Index>, 2> BodyRows::RowsOf(std::size_t k) const {
  return {{{knots_[k].row[kNear], knots_[k].residual_end}, {knots_[k].row[kDynamics], knots_[k].row[kKinds]}}};
}

}  // namespace gaitwright
