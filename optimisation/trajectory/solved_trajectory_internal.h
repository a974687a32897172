// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/trajectory/body_problem_internal.h"

namespace gaitwright {

/// A solution of a BodyProblem, between its knots too.
///
/// At knots the dynamics hold. Between knots the joints follow a cubic spline, forces are linear, and the base moves as
/// Newton's and Euler's equations demand: to the base's spline a correction d is added, of which the second derivative
/// is a polynomial of degree 4 in each interval, and which is zero at the knots.
///
/// The rate of d is continuous at a knot k where the integral of hat_k d'' over time is zero, hat_k being linear, 1 at
/// that knot and 0 at all others. The spline has to leave a small wrench unbalanced at knots for this; ResidualsAtKnots
/// says which. (This is Galerkin's condition with linear functions, whose values at knots are exact: Tong, AIAA Journal
/// 7, 1969.)
class SolvedTrajectory {
 public:
  /// The problem must outlive this. @param points  control points, as of ChainSpline. @param forces  by knot, in units
  /// of the weight.
  SolvedTrajectory(const BodyProblem& problem, MatrixX points, std::vector<VectorX> forces);

  /// Coordinates of a BodyProblem at a time.
  void Sample(double time_s, VectorJet& jet) const;

  /// Contacts at a time, and forces at their points in units of the weight.
  void ForcesAt(double time_s, std::vector<KnotContact>& contacts, VectorX& forces) const;

  /// By knot: the wrench that the spline is to leave unbalanced there (BodyKnot::residual_W).
  const std::vector<Vector6>& ResidualsAtKnots() const { return residual_W_; }

  /// Largest change of the base's velocity at a knot [m/s], [rad/s].
  double largest_jump() const { return largest_jump_; }

  const MatrixX& points() const { return points_; }
  const std::vector<VectorX>& forces() const { return forces_; }
  const BodyProblem& problem() const { return problem_; }

 private:
  static constexpr int kDegree = 4;
  /// Second derivative of d in an interval: the sum of c_i u^i, u from 0 to 1; the rate at u = 0 is h rate_0.
  struct Correction {
    Eigen::Matrix<double, 6, kDegree + 1> c = Eigen::Matrix<double, 6, kDegree + 1>::Zero();
    Vector6 rate_0 = Vector6::Zero(), rate_1 = Vector6::Zero();
  };

  std::size_t IntervalAt(double time_s) const;
  double LengthOf(std::size_t interval) const { return problem_.time_s[interval + 1] - problem_.time_s[interval]; }
  Vector6 NeededCorrection(KnotModel& model, double time_s, Vector6* wrench = nullptr) const;
  void BalanceIntervals(KnotModel& model);
  void SetResiduals(KnotModel& model);

  const BodyProblem& problem_;
  ChainSpline spline_;
  MatrixX points_;
  std::vector<VectorX> forces_;
  std::vector<Correction> corrections_;  // by interval
  std::vector<Vector6> at_knots_;        // d'' by knot
  std::vector<Vector6> residual_W_;
  double largest_jump_ = 0.0;
};

}  // namespace gaitwright
