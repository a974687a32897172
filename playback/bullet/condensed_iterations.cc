// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "playback/bullet/condensed_solver_internal.h"

namespace gaitwright::bullet {
namespace {

constexpr double kSettled = 1e-9;  // relative change of the impulses at which the iteration ends
constexpr double kHeld = 1e-13;    // share of a row's own A below which A is rounding: other rows hold its velocity, as
                                   // dry friction does at a stop

}  // namespace

bool CondensedSolver::Condense() {
  Fold();
  FillHalves(iterated_, halves_, b_small_);
  A_small_.setZero(halves_.cols(), halves_.cols());
  if (!iterated_.empty()) {
    A_small_.selfadjointView<Eigen::Lower>().rankUpdate(halves_.transpose());
    A_small_.triangularView<Eigen::StrictlyUpper>() = A_small_.transpose();
  }
  FillPositions();
  AddSharedSoftness(position_, position_, A_small_);
  if (!Eliminate()) return false;
  FillPlaces();
  w_small_.noalias() = A_small_ * p_small_;
  return true;
}

void CondensedSolver::FillPositions() {
  position_.assign(lines_.size(), -1);
  dense_position_.assign(lines_.size(), -1);
  for (std::size_t k = 0; k < iterated_.size(); ++k)
    position_[static_cast<std::size_t>(iterated_[k])] = static_cast<Eigen::Index>(k);
  for (std::size_t k = 0; k < dense_.size(); ++k)
    dense_position_[static_cast<std::size_t>(dense_[k])] = static_cast<Eigen::Index>(k);
}

void CondensedSolver::AddSharedSoftness(const std::vector<Eigen::Index>& row_places,
                                        const std::vector<Eigen::Index>& column_places, MatrixX& matrix) const {
  for (const SharedSoftness& shared : shared_softness_) {
    for (const auto& [a, b] : {std::pair(shared.first, shared.second), std::pair(shared.second, shared.first)}) {
      const Eigen::Index row = row_places[static_cast<std::size_t>(a)];
      const Eigen::Index column = column_places[static_cast<std::size_t>(b)];
      if (row >= 0 && column >= 0) matrix(row, column) += shared.softness;
    }
  }
}

void CondensedSolver::Fold() {
  M_ = inertia_.matrix();
  force_.setZero(inertia_.size());
  held_velocity_.setZero(inertia_.size());
  is_held_.assign(static_cast<std::size_t>(inertia_.size()), 0);
  any_held_ = false;
  dense_.clear();
  for (const Eigen::Index i : direct_) {
    Line& line = lines_[static_cast<std::size_t>(i)];
    const int at = line.coordinate;
    line.is_soft = at >= 0 && line.softness > 0.0 && !line.is_coupled;
    line.holds = at >= 0 && line.softness <= 0.0 && is_held_[static_cast<std::size_t>(at)] == 0;
    if (line.is_soft) {
      M_[inertia_.tree().offset(at) + static_cast<std::size_t>(inertia_.tree().depth(at))] +=
          line.share * line.share / line.softness;
      force_[at] += line.share * line.b / line.softness;
    } else if (line.holds) {
      is_held_[static_cast<std::size_t>(at)] = 1;
      held_velocity_[at] = line.b / line.share;
      any_held_ = true;
    } else {
      dense_.push_back(i);
    }
  }
  for (const Eigen::Index i : sliding_) AddForce(lines_[static_cast<std::size_t>(i)], impulse_[i], force_);
  free_ = force_;
  if (any_held_) TakeOutHeld();
  factor_.Compute(M_);
  factor_.SolveUpper(free_.data());
}

void CondensedSolver::TakeOutHeld() {
  const CoordinateTree& tree = inertia_.tree();
  scratch_.resize(inertia_.size());
  Multiply(tree, M_, held_velocity_.data(), scratch_.data());
  free_ -= scratch_;
  for (int i = 0; i < tree.size(); ++i) {
    double* row = &M_[tree.offset(i)];
    const bool held = is_held_[static_cast<std::size_t>(i)] != 0;
    for (int a = 0; a <= tree.depth(i); ++a) {
      if (held || is_held_[static_cast<std::size_t>(tree.path(i)[a])] != 0) row[a] = 0.0;
    }
    if (!held) continue;
    row[tree.depth(i)] = 1.0;
    free_[i] = 0.0;
  }
}

void CondensedSolver::FillHalves(const std::vector<Eigen::Index>& lines, MatrixX& halves, VectorX& b) {
  const auto count = static_cast<Eigen::Index>(lines.size());
  halves.setZero(inertia_.size(), count);
  b.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Line& line = lines_[static_cast<std::size_t>(lines[static_cast<std::size_t>(k)])];
    b[k] = line.b;
    if (line.last_coordinate >= 0) {
      FillHalfAlong(line, halves.col(k), b[k]);
      continue;
    }
    auto half = halves.col(k);
    half = JacobianOf(line);
    for (Eigen::Index i = 0; any_held_ && i < half.size(); ++i) {
      if (is_held_[static_cast<std::size_t>(i)] != 0) b[k] -= std::exchange(half[i], 0.0) * held_velocity_[i];
    }
    factor_.SolveUpper(half.data());
    b[k] -= half.dot(free_);
  }
}

void CondensedSolver::FillHalfAlong(const Line& line, Eigen::Ref<VectorX> half, double& b) {
  const int* path = inertia_.tree().path(line.last_coordinate);
  const int depth = inertia_.tree().depth(line.last_coordinate);
  const double* J = JacobianOf(line).data();
  scratch_.resize(inertia_.size());
  for (int a = 0; a <= depth; ++a) {
    const bool held = any_held_ && is_held_[static_cast<std::size_t>(path[a])] != 0;
    scratch_[a] = held ? 0.0 : J[path[a]];
    if (held) b -= J[path[a]] * held_velocity_[path[a]];
  }
  factor_.SolveUpperAlong(line.last_coordinate, scratch_.data());
  for (int a = 0; a <= depth; ++a) {
    half[path[a]] = scratch_[a];
    b -= scratch_[a] * free_[path[a]];
  }
}

bool CondensedSolver::Eliminate() {
  if (dense_.empty()) return true;
  FillHalves(dense_, halves_direct_, b_direct_);
  A_direct_.noalias() = halves_direct_.transpose() * halves_direct_;
  for (std::size_t k = 0; k < dense_.size(); ++k) {
    A_direct_.diagonal()[static_cast<Eigen::Index>(k)] += lines_[static_cast<std::size_t>(dense_[k])].softness;
  }
  AddSharedSoftness(dense_position_, dense_position_, A_direct_);
  dense_factor_.compute(A_direct_);
  const auto pivots = dense_factor_.matrixLLT().diagonal().array().square();
  if (dense_factor_.info() != Eigen::Success || (pivots <= kHeld * A_direct_.diagonal().array()).any()) return false;
  if (iterated_.empty()) return true;
  coupling_.noalias() = halves_direct_.transpose() * halves_;
  AddSharedSoftness(dense_position_, position_, coupling_);
  elimination_ = dense_factor_.solve(coupling_);
  A_small_.noalias() -= coupling_.transpose() * elimination_;
  b_small_.noalias() -= elimination_.transpose() * b_direct_;
  return true;
}

void CondensedSolver::FillPlaces() {
  const auto count = static_cast<Eigen::Index>(iterated_.size());
  places_.resize(iterated_.size());
  p_small_.resize(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index i = iterated_[static_cast<std::size_t>(k)];
    const Line& line = lines_[static_cast<std::size_t>(i)];
    Place& place = places_[static_cast<std::size_t>(k)];
    p_small_[k] = impulse_[i];
    place.softness = line.softness;
    place.is_cone = line.kind == Kind::kFriction && (k == 0 || !places_[static_cast<std::size_t>(k - 1)].is_cone);
    if (line.kind != Kind::kFriction) {
      place.inverse_diagonal = 1.0 / (A_small_(k, k) + line.softness);
      place.is_held = line.kind == Kind::kBounded &&
                      A_small_(k, k) + line.softness <= kHeld * inertia_.InverseAlong(JacobianOf(line).data());
      place.lowest = line.row->m_lowerLimit;
      place.highest = line.row->m_upperLimit;
    } else if (place.is_cone) {
      Eigen::Matrix2d block = A_small_.block<2, 2>(k, k);
      block(0, 0) += line.softness;
      block(1, 1) += lines_[static_cast<std::size_t>(i + 1)].softness;
      const double half = 0.5 * block.trace();
      place.inverse = block.inverse();
      place.largest = half + std::sqrt(std::max(0.0, half * half - block.determinant()));
      place.friction = line.row->m_friction;
      place.normal = position_[static_cast<std::size_t>(line.normal)];
    }
  }
}

void CondensedSolver::Iterate(int most) {
  const Eigen::Index count = p_small_.size();
  for (int iteration = 0; iteration < most; ++iteration) {
    double change = 0.0;
    for (Eigen::Index k = 0; k < count; ++k) {
      const bool is_cone = places_[static_cast<std::size_t>(k)].is_cone;
      change = std::max(change, is_cone ? SolveCone(k) : SolveLine(k));
      if (is_cone) ++k;
    }
    if (count == 0 || change <= kSettled * p_small_.lpNorm<Eigen::Infinity>()) break;
  }
  for (Eigen::Index k = 0; k < count; ++k) impulse_[iterated_[static_cast<std::size_t>(k)]] = p_small_[k];
}

double CondensedSolver::SolveLine(Eigen::Index k) {
  const Place& place = places_[static_cast<std::size_t>(k)];
  if (place.is_held) return 0.0;
  const double now = p_small_[k];
  const double free = now + (b_small_[k] - w_small_[k] - place.softness * now) * place.inverse_diagonal;
  const double change = std::clamp(free, place.lowest, place.highest) - now;
  if (change == 0.0) return 0.0;
  p_small_[k] += change;
  w_small_ += change * A_small_.col(k);
  return std::abs(change);
}

double CondensedSolver::SolveCone(Eigen::Index k) {
  const Place& place = places_[static_cast<std::size_t>(k)];
  const double radius = place.friction * p_small_[place.normal];
  const Vector2 now = p_small_.segment<2>(k);
  const Vector2 s(place.softness, places_[static_cast<std::size_t>(k + 1)].softness);
  const Vector2 residual = b_small_.segment<2>(k) - w_small_.segment<2>(k) - s.cwiseProduct(now);
  // A step by the larger eigenvalue keeps the projection onto the disc a descent step; the exact step is taken inside.
  Vector2 wanted = now + place.inverse * residual;
  if (wanted.squaredNorm() > radius * radius) {
    wanted = now + residual / place.largest;
    if (wanted.squaredNorm() > radius * radius) wanted *= radius / wanted.norm();
  }
  const Vector2 change = wanted - now;
  if (change.x() == 0.0 && change.y() == 0.0) return 0.0;
  p_small_.segment<2>(k) += change;
  w_small_ += change.x() * A_small_.col(k) + change.y() * A_small_.col(k + 1);
  return change.lpNorm<Eigen::Infinity>();
}

void CondensedSolver::Recover() {
  velocity_ = free_;
  velocity_.noalias() += halves_ * p_small_;
  if (!dense_.empty()) {
    p_direct_ = b_direct_;
    if (!iterated_.empty()) p_direct_.noalias() -= coupling_ * p_small_;
    dense_factor_.solveInPlace(p_direct_);
    velocity_.noalias() += halves_direct_ * p_direct_;
    for (std::size_t k = 0; k < dense_.size(); ++k) impulse_[dense_[k]] = p_direct_[static_cast<Eigen::Index>(k)];
  }
  factor_.SolveLower(velocity_.data());
  if (any_held_) velocity_ += held_velocity_;  // no entry is non-zero in both
  for (const Eigen::Index i : direct_) {
    const Line& line = lines_[static_cast<std::size_t>(i)];
    if (line.is_soft) impulse_[i] = (line.b - line.share * velocity_[line.coordinate]) / line.softness;
  }
  if (any_held_) RecoverHolding();
}

void CondensedSolver::RecoverHolding() {
  Multiply(inertia_.tree(), inertia_.matrix(), velocity_.data(), scratch_.data());
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (!lines_[i].holds) AddForce(lines_[i], -impulse_[static_cast<Eigen::Index>(i)], scratch_);
  }
  for (const Eigen::Index i : direct_) {
    const Line& line = lines_[static_cast<std::size_t>(i)];
    if (line.holds) impulse_[i] = scratch_[line.coordinate] / line.share;
  }
}

}  // namespace gaitwright::bullet
