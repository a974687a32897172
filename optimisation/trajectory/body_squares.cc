// SPDX-License-Identifier: BSD-3-Clause
// Normal equations of the rows of a whole body's trajectory, and their factors along the chain of knots.
#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "optimisation/trajectory/body_rows_internal.h"

namespace gaitwright {
namespace {

using Eigen::Index;

/// Sum over the sides of a friction pyramid of a weight times the square of the side's direction.
Matrix3 SquareOfSides(const PressingFoot& foot, const Eigen::Ref<const VectorX>& weights) {
  Matrix3 sum = Matrix3::Zero();
  const double share = foot.friction * std::cos(std::numbers::pi / kPyramidSides);
  for (int side = 0; side < kPyramidSides; ++side) {
    const double angle = 2.0 * std::numbers::pi * side / kPyramidSides;
    const Vector3 along(std::cos(angle), std::sin(angle), -share);
    sum += weights[side] * along * along.transpose();
  }
  return foot.axes_W * sum * foot.axes_W.transpose();
}

}  // namespace

/// Adds to the dense rows of a knot what belongs to its dynamics and its limits of efforts. @return the row after
/// these.
Index BodyRows::AddDense(std::size_t k, const VectorX& of_rows) const {
  const Knot& knot = knots_[k];
  Index row = knot.row[kEffortLimit];
  if (Asked(k).is_given) return row;
  dense_.head<6>() += of_rows.segment<6>(knot.row[kDynamics]);
  for (const int motor : motors_.limited()) dense_[6 + motor] += of_rows[row++];
  return row;
}

/// What belongs to the posture rows of a knot, with a factor for those of points.
VectorX BodyRows::OfPosture(std::size_t k, const VectorX& of_rows, double of_points) const {
  const Knot& knot = knots_[k];
  const auto count = [&](Kind kind) { return CountOf(knot, Asked(k), kind); };
  VectorX of_posture(knot.posture.size());
  of_posture << of_rows.segment(knot.row[kFeet], count(kFeet)), of_rows.segment(knot.row[kApart], count(kApart)),
      of_points * of_rows.segment(knot.row[kPoint], count(kPoint));
  return of_posture;
}

/// J^T * by of a knot's rows, by y.
void BodyRows::FlatGradient(std::size_t k, const VectorX& by, VectorX& g) const {
  const Knot& knot = knots_[k];
  const BodyKnot& asked = Asked(k);
  const Index m = motors_.count();
  dense_.resize(6 + m + powers());
  dense_.head<6>().setZero();
  dense_.segment(6, m) =
      share_[k] * problem_.weights.effort * by.segment(knot.row[kEffort], m).cwiseProduct(effort_factor_);
  dense_.tail(powers()) = share_[k] * problem_.weights.power * by.segment(knot.row[kPower], powers());
  Index row = AddDense(k, by);
  const Index first_curve = row;
  for (const MotorRows::Curve& curve : motors_.curves()) {
    if (row == knot.row[kAcceleration]) break;
    dense_[6 + curve.motor] += curve.by_effort * by[row++];
  }
  g.noalias() = knot.D.transpose() * dense_;
  if (knot.posture.size() > 0) g.head(n_).noalias() += knot.J.transpose() * OfPosture(k, by, share_[k]);
  row = first_curve;
  for (const MotorRows::Curve& curve : motors_.curves()) {
    if (row == knot.row[kAcceleration]) break;
    for (const Actuator::Term& term : motors_.motors()[static_cast<std::size_t>(curve.motor)].terms)
      g[n_ + 6 + term.dof] += term.by_speed / curve.speed_scale * by[row];
    ++row;
  }
  for (Index i = 0; i < n_; ++i) {
    g[i] += share_[k] * NearWeight(k, i) * by[knot.row[kNear] + i];
    g[2 * n_ + i] += share_[k] * AccelerationWeight(i) * by[knot.row[kNearAcceleration] + i];
  }
  g.tail(knot.forces) += share_[k] * problem_.weights.force * by.segment(knot.row[kForce], knot.forces);
  for (Index i = 0; i < knot.row[kRange] - knot.row[kAcceleration]; ++i) {
    const int dof = accelerated_[static_cast<std::size_t>(i)];
    g[2 * n_ + 6 + dof] += by[knot.row[kAcceleration] + i] / MostAcceleration(dof);
  }
  for (Index i = 0; i < knot.row[kCone] - knot.row[kRange]; ++i)
    g[6 + ranged_[static_cast<std::size_t>(i)]] += by[knot.row[kRange] + i];
  row = knot.row[kCone];
  Index force = 3 * n_;
  for (const PressingFoot& foot : asked.pressing) {
    const double share = foot.friction * std::cos(std::numbers::pi / kPyramidSides);
    for (std::size_t p = 0; p < foot.contact.points_F.size(); ++p, force += 3) {
      Vector3 sum = Vector3::Zero();
      for (int side = 0; side < kPyramidSides; ++side) {
        const double angle = 2.0 * std::numbers::pi * side / kPyramidSides;
        sum += by[row++] * Vector3(std::cos(angle), std::sin(angle), -share);
      }
      g.segment<3>(force) += foot.axes_W * sum;
    }
  }
  if (asked.tie) g.head(3 * n_) += tie_unit_.cwiseProduct(by.segment(knot.row[kTied], 3 * n_));
  if (asked.pins_place) g.head(n_) += by.segment(knot.row[kPinnedPlace], n_);
  if (!asked.pins_motion) return;
  g.segment(n_, n_) += by.segment(knot.row[kPinnedMotion], n_);
  g.segment(2 * n_, n_) += by.segment(knot.row[kPinnedMotion] + n_, n_);
}

VectorX BodyRows::Gradient(const VectorX& by) const {
  VectorX gradient = VectorX::Zero(size());
  for (std::size_t k = 0; k < knots_.size(); ++k) AddGradient(k, by, gradient);
  return gradient;
}

void BodyRows::AddGradient(std::size_t k, const VectorX& by, VectorX& gradient) const {
  FlatGradient(k, by, flat_);
  const KnotBasis& basis = basis_[k];
  for (std::size_t i = 0; i < 3; ++i) {
    gradient.segment(static_cast<Index>(k + i) * n_, n_) += basis.value[i] * flat_.head(n_) +
                                                            basis.rate[i] * flat_.segment(n_, n_) +
                                                            basis.acceleration[i] * flat_.segment(2 * n_, n_);
  }
  gradient.segment(knots_[k].force, knots_[k].forces) += flat_.tail(knots_[k].forces);
  AddJerkGradient(k, by, gradient);
}

/// The weighted squares of a knot's rows of one value each.
void BodyRows::AddDiagonal(std::size_t k, const VectorX& weights) {
  const Knot& knot = knots_[k];
  const BodyKnot& asked = Asked(k);
  auto diagonal = square_.diagonal();
  for (Index i = 0; i < n_; ++i) {
    diagonal[i] += std::pow(share_[k] * NearWeight(k, i), 2);
    diagonal[2 * n_ + i] += std::pow(share_[k] * AccelerationWeight(i), 2);
  }
  diagonal.tail(knot.forces).array() += std::pow(share_[k] * problem_.weights.force, 2);
  for (Index i = 0; i < knot.row[kRange] - knot.row[kAcceleration]; ++i) {
    const int dof = accelerated_[static_cast<std::size_t>(i)];
    diagonal[2 * n_ + 6 + dof] += weights[knot.row[kAcceleration] + i] / std::pow(MostAcceleration(dof), 2);
  }
  for (Index i = 0; i < knot.row[kCone] - knot.row[kRange]; ++i)
    diagonal[6 + ranged_[static_cast<std::size_t>(i)]] += weights[knot.row[kRange] + i];
  if (asked.tie) diagonal.head(3 * n_) += tie_unit_.cwiseAbs2().cwiseProduct(weights.segment(knot.row[kTied], 3 * n_));
  if (asked.pins_place) diagonal.head(n_) += weights.segment(knot.row[kPinnedPlace], n_);
  if (asked.pins_motion) diagonal.segment(n_, 2 * n_) += weights.segment(knot.row[kPinnedMotion], 2 * n_);
}

/// The lower triangle of the weighted squares of a knot's rows, by y.
void BodyRows::AddSquares(std::size_t k, const VectorX& weights) {
  const Knot& knot = knots_[k];
  const BodyKnot& asked = Asked(k);
  const Index m = motors_.count(), size = knot.y.size();
  const double effort = share_[k] * problem_.weights.effort;
  dense_.resize(6 + m + powers());
  dense_.head<6>().setZero();
  dense_.segment(6, m) = effort * effort * effort_factor_.cwiseAbs2();
  dense_.tail(powers()).setConstant(std::pow(share_[k] * problem_.weights.power, 2));
  Index row = AddDense(k, weights);
  const Index first_curve = row;
  for (const MotorRows::Curve& curve : motors_.curves()) {
    if (row == knot.row[kAcceleration]) break;
    dense_[6 + curve.motor] += curve.by_effort * curve.by_effort * weights[row++];
  }
  scaled_ = dense_.cwiseSqrt().asDiagonal() * knot.D;
  square_.setZero(size, size);
  square_.selfadjointView<Eigen::Lower>().rankUpdate(scaled_.transpose());
  if (knot.posture.size() > 0) {
    VectorX of_posture = OfPosture(k, weights, 1.0);
    of_posture.tail(CountOf(knot, asked, kPoint)).setConstant(share_[k] * share_[k]);
    scaled_ = of_posture.cwiseSqrt().asDiagonal() * knot.J;
    square_.topLeftCorner(n_, n_).selfadjointView<Eigen::Lower>().rankUpdate(scaled_.transpose());
  }
  row = first_curve;
  for (const MotorRows::Curve& curve : motors_.curves()) {
    if (row == knot.row[kAcceleration]) break;
    const double weight = weights[row++];
    const std::vector<Actuator::Term>& terms = motors_.motors()[static_cast<std::size_t>(curve.motor)].terms;
    for (const Actuator::Term& term : terms) {
      const Index at = n_ + 6 + term.dof;
      const double by = term.by_speed / curve.speed_scale;
      for (const Actuator::Term& other : terms) {
        if (other.dof <= term.dof) square_(at, n_ + 6 + other.dof) += weight * by * other.by_speed / curve.speed_scale;
      }
      if (curve.by_effort == 0.0) continue;
      const auto effort_row = weight * by * curve.by_effort * knot.D.row(6 + curve.motor);
      square_.row(at).head(at) += effort_row.head(at);
      square_.col(at).tail(size - at) += effort_row.tail(size - at).transpose();
      square_(at, at) += effort_row[at];
    }
  }
  AddDiagonal(k, weights);
  row = knot.row[kCone];
  Index force = 3 * n_;
  for (const PressingFoot& foot : asked.pressing) {
    for (std::size_t p = 0; p < foot.contact.points_F.size(); ++p, force += 3, row += kPyramidSides)
      square_.block<3, 3>(force, force) += SquareOfSides(foot, weights.segment(row, kPyramidSides));
  }
}

/// From a knot's squares by y: factors of the forces' own block, and their coupling to control points.
bool BodyRows::EliminateForces(std::size_t k, double damping) {
  Knot& knot = knots_[k];
  const Index f = knot.forces;
  knot.L.resize(f, f);
  knot.E.resize(f, 3 * n_);
  if (f == 0) return true;
  knot.L = square_.bottomRightCorner(f, f);
  knot.L.diagonal().array() += damping;
  Eigen::Ref<MatrixX> own = knot.L;
  if (const Eigen::LLT<Eigen::Ref<MatrixX>> factors(own); factors.info() != Eigen::Success) return false;
  const auto coupled = square_.bottomRows(f);
  const KnotBasis& basis = basis_[k];
  for (std::size_t i = 0; i < 3; ++i) {
    knot.E.middleCols(static_cast<Index>(i) * n_, n_) = basis.value[i] * coupled.leftCols(n_) +
                                                        basis.rate[i] * coupled.middleCols(n_, n_) +
                                                        basis.acceleration[i] * coupled.middleCols(2 * n_, n_);
  }
  knot.L.triangularView<Eigen::Lower>().solveInPlace(knot.E);
  return true;
}

/// What is left of a knot's squares, by control points.
void BodyRows::AddToChain(std::size_t k) {
  const KnotBasis& basis = basis_[k];
  const auto weight = [&](Index derivative, std::size_t point) {
    const auto& of = derivative == 0 ? basis.value : derivative == 1 ? basis.rate : basis.acceleration;
    return of[point];
  };
  yy_ = square_.topLeftCorner(3 * n_, 3 * n_).selfadjointView<Eigen::Lower>();
  chain_square_.resize(3 * n_, 3 * n_);
  mixed_.resize(n_, 3 * n_);
  for (std::size_t i = 0; i < 3; ++i) {
    mixed_ = weight(0, i) * yy_.topRows(n_) + weight(1, i) * yy_.middleRows(n_, n_) + weight(2, i) * yy_.bottomRows(n_);
    for (std::size_t j = 0; j <= i; ++j) {
      chain_square_.block(static_cast<Index>(i) * n_, static_cast<Index>(j) * n_, n_, n_) =
          weight(0, j) * mixed_.leftCols(n_) + weight(1, j) * mixed_.middleCols(n_, n_) +
          weight(2, j) * mixed_.rightCols(n_);
    }
  }
  if (knots_[k].forces > 0) chain_square_.selfadjointView<Eigen::Lower>().rankUpdate(knots_[k].E.transpose(), -1.0);
  chain_.Add(static_cast<int>(k), chain_square_);
}

bool BodyRows::Factor(const VectorX& weights, double damping) {
  chain_.SetDiagonal(damping);
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    AddSquares(k, weights);
    if (!EliminateForces(k, damping)) return false;
    AddToChain(k);
    AddJerkSquares(k, weights);
  }
  return chain_.Factor();
}

/// The share of the forces in solving with the factors: before that of the chain, or after it.
template <class Right>
void BodyRows::Substitute(Right& solved, bool forward) const {
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    const Knot& knot = knots_[k];
    if (knot.forces == 0) continue;
    auto own = solved.middleRows(knot.force, knot.forces);
    auto points = solved.middleRows(static_cast<Index>(k) * n_, 3 * n_);
    if (forward) {
      knot.L.triangularView<Eigen::Lower>().solveInPlace(own);
      points.noalias() -= knot.E.transpose() * own;
    } else {
      own.noalias() -= knot.E * points;
      knot.L.triangularView<Eigen::Lower>().transpose().solveInPlace(own);
    }
  }
}

VectorX BodyRows::Solved(const VectorX& right) const {
  VectorX solved = right;
  Substitute(solved, true);
  chain_.Solve(solved.head(points_size_));
  Substitute(solved, false);
  return solved;
}

MatrixX BodyRows::SolvedAll(const MatrixX& right) const {
  MatrixX solved = right;
  Substitute(solved, true);
  chain_.SolveAll(solved.topRows(points_size_));
  Substitute(solved, false);
  return solved;
}

}  // namespace gaitwright
