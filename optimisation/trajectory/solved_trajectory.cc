// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "optimisation/trajectory/solved_trajectory_internal.h"

namespace gaitwright {
namespace {

constexpr int kPieces = 4;  // of an interval, at the ends of which d'' is found

/// From values at the ends of the pieces (columns) to the coefficients of their polynomial (columns).
Eigen::Matrix<double, kPieces + 1, kPieces + 1> ToCoefficients() {
  Eigen::Matrix<double, kPieces + 1, kPieces + 1> powers;
  for (int node = 0; node <= kPieces; ++node) {
    for (int i = 0; i <= kPieces; ++i) powers(i, node) = std::pow(static_cast<double>(node) / kPieces, i);
  }
  return powers.inverse();
}

/// Adds a contact, or the points of it that a contact of the same foot does not have.
void AddPoints(const KnotContact& contact, std::vector<KnotContact>& contacts) {
  const auto same = std::find_if(contacts.begin(), contacts.end(),
                                 [&](const KnotContact& known) { return known.foot == contact.foot; });
  if (same == contacts.end()) return contacts.push_back(contact);
  for (const Vector3& p_F : contact.points_F) {
    if (std::find(same->points_F.begin(), same->points_F.end(), p_F) == same->points_F.end())
      same->points_F.push_back(p_F);
  }
}

/// Index of the first component of the force at a foot's point.
Eigen::Index FirstOf(const std::vector<KnotContact>& contacts, int foot, const Vector3& p_F) {
  std::ptrdiff_t points = 0;
  for (const KnotContact& contact : contacts) {
    if (contact.foot == foot)
      return 3 *
             (points + (std::find(contact.points_F.begin(), contact.points_F.end(), p_F) - contact.points_F.begin()));
    points += static_cast<std::ptrdiff_t>(contact.points_F.size());
  }
  return 3 * points;
}

}  // namespace

SolvedTrajectory::SolvedTrajectory(const BodyProblem& problem, MatrixX points, std::vector<VectorX> forces)
    : problem_(problem),
      spline_(problem.time_s),
      points_(std::move(points)),
      forces_(std::move(forces)),
      corrections_(problem.time_s.size() - 1),
      at_knots_(problem.time_s.size(), Vector6::Zero()),
      residual_W_(problem.time_s.size(), Vector6::Zero()) {
  KnotModel model(*problem.model);
  BalanceIntervals(model);
  SetResiduals(model);
}

std::size_t SolvedTrajectory::IntervalAt(double time_s) const {
  const std::vector<double>& times = problem_.time_s;
  return static_cast<std::size_t>(std::upper_bound(times.begin() + 1, times.end() - 1, time_s) - times.begin()) - 1;
}

void SolvedTrajectory::Sample(double time_s, VectorJet& jet) const {
  spline_.Sample(points_, time_s, jet);
  const std::size_t interval = IntervalAt(time_s);
  const Correction& d = corrections_[interval];
  const double h = LengthOf(interval), u = std::clamp((time_s - problem_.time_s[interval]) / h, 0.0, 1.0);
  Vector6 x = u * d.rate_0, rate = d.rate_0, acceleration = Vector6::Zero();
  double power = 1.0;
  for (int i = 0; i <= kDegree; ++i, power *= u) {
    acceleration += power * d.c.col(i);
    rate += power * u / (i + 1) * d.c.col(i);
    x += power * u * u / ((i + 1) * (i + 2)) * d.c.col(i);
  }
  jet.x.head<6>() += h * h * x;
  jet.rate.head<6>() += h * rate;
  jet.acceleration.head<6>() += acceleration;
  for (int dof = 0; dof < problem_.model->num_dofs(); ++dof) {
    if (!problem_.StaysStill(dof)) continue;
    jet.x[6 + dof] = problem_.knots.front().reference.x[6 + dof];
    jet.rate[6 + dof] = jet.acceleration[6 + dof] = 0.0;
  }
}

/// A foot may press at other points at the next knot: a point that one knot lacks has no force there.
void SolvedTrajectory::ForcesAt(double time_s, std::vector<KnotContact>& contacts, VectorX& forces) const {
  const std::size_t left = IntervalAt(time_s);
  const double u = std::clamp((time_s - problem_.time_s[left]) / LengthOf(left), 0.0, 1.0);
  contacts.clear();
  for (const std::size_t k : {left, left + 1}) {
    for (const PressingFoot& foot : problem_.knots[k].pressing) AddPoints(foot.contact, contacts);
  }
  Eigen::Index size = 0;
  for (const KnotContact& contact : contacts) size += static_cast<Eigen::Index>(3 * contact.points_F.size());
  forces.setZero(size);
  const auto add = [&](std::size_t k, double share) {
    Eigen::Index from = 0;
    for (const PressingFoot& foot : problem_.knots[k].pressing) {
      for (const Vector3& p_F : foot.contact.points_F) {
        forces.segment<3>(FirstOf(contacts, foot.contact.foot, p_F)) += share * forces_[k].segment<3>(from);
        from += 3;
      }
    }
  };
  add(left, 1.0 - u);
  add(left + 1, u);
}

/// The change of d'' that balances the base at a time. @param wrench  what is unbalanced there [N, N m].
Vector6 SolvedTrajectory::NeededCorrection(KnotModel& model, double time_s, Vector6* wrench) const {
  VectorJet jet;
  ChartedState state;
  std::vector<KnotContact> contacts;
  VectorX forces, needed;
  Sample(time_s, jet);
  StateOf(problem_.chart, jet, state);
  ForcesAt(time_s, contacts, forces);
  model.Evaluate(state.q, state.v, state.a, contacts, model.model().weight_n() * forces, needed);
  if (wrench != nullptr) *wrench = needed.head<6>();
  Vector6 change = -model.LockedAcceleration(needed.head<6>());
  change.tail<3>() = state.turn.E.lu().solve(change.tail<3>().eval());
  return change;
}

/// Finds the corrections. A correction changes what is unbalanced in proportion to its own size alone, so that few
/// sweeps are enough.
void SolvedTrajectory::BalanceIntervals(KnotModel& model) {
  constexpr int kSweeps = 3;
  static const Eigen::Matrix<double, kPieces + 1, kPieces + 1> to_coefficients = ToCoefficients();
  const std::size_t last = problem_.time_s.size() - 1;
  std::vector<Eigen::Matrix<double, 6, kPieces + 1>> values(last);
  for (auto& value : values) value.setZero();
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t k = 1; k < last; ++k)  // the robot rests at both ends
      at_knots_[k] += NeededCorrection(model, problem_.time_s[k], sweep == 0 ? &residual_W_[k] : nullptr);
    for (std::size_t k = 0; k < last; ++k) {
      for (int node = 1; node < kPieces; ++node)
        values[k].col(node) += NeededCorrection(model, problem_.time_s[k] + LengthOf(k) * node / kPieces);
      values[k].col(0) = at_knots_[k];
      values[k].col(kPieces) = at_knots_[k + 1];
    }
    for (std::size_t k = 0; k < last; ++k) {
      Correction& d = corrections_[k];
      d.c = values[k] * to_coefficients;
      d.rate_0.setZero();
      Vector6 whole = Vector6::Zero();
      for (int i = 0; i <= kDegree; ++i) {
        d.rate_0 -= d.c.col(i) / ((i + 1) * (i + 2));
        whole += d.c.col(i) / (i + 1);
      }
      d.rate_1 = d.rate_0 + whole;
    }
  }
}

/// Takes the piecewise linear part of d'' out: the knots are to leave as much less unbalanced.
void SolvedTrajectory::SetResiduals(KnotModel& model) {
  const std::size_t last = problem_.time_s.size() - 1;
  if (last < 2) return;
  // Tridiagonal: (h_k-1 x_k-1 + 2 (h_k-1 + h_k) x_k + h_k x_k+1) / 6 = -jump_k, by elimination.
  std::vector<Vector6> change(last + 1, Vector6::Zero());
  std::vector<double> above(last + 1, 0.0);
  for (std::size_t k = 1; k < last; ++k) {
    const double before = LengthOf(k - 1), after = LengthOf(k);
    const Vector6 jump = before * corrections_[k - 1].rate_1 - after * corrections_[k].rate_0;
    largest_jump_ = std::max(largest_jump_, jump.cwiseAbs().maxCoeff());
    const double pivot = (2.0 * (before + after) - before * above[k - 1]) / 6.0;
    above[k] = after / 6.0 / pivot;
    change[k] = (-jump - before / 6.0 * change[k - 1]) / pivot;
  }
  for (std::size_t k = last - 1; k >= 1; --k) change[k] -= above[k] * change[k + 1];
  for (std::size_t k = 1; k < last; ++k) {
    Vector6 acceleration = change[k];
    VectorJet jet;
    ChartedState state;
    spline_.Sample(points_, problem_.time_s[k], jet);
    StateOf(problem_.chart, jet, state);
    VectorX needed;
    model.Evaluate(state.q, state.v, state.a, {}, VectorX(), needed);
    acceleration.tail<3>() = (state.turn.E * acceleration.tail<3>()).eval();
    residual_W_[k] -= model.LockedWrench(acceleration);
  }
}

}  // namespace gaitwright
