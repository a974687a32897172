// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Weights of the three control points that decide a cubic spline and its derivatives at one of its knots.
struct KnotBasis {
  std::array<double, 3> value{}, rate{}, acceleration{};
};

/// How fast a knot is passed: change of the spline's own time s with time t, and the change of that with s.
///   dx/dt = rate x',  d2x/dt2 = rate^2 x'' + rate slope x'
struct KnotPace {
  double rate = 1.0;
  double slope = 0.0;  ///< [1/s]
};
KnotBasis AtPace(const KnotBasis& basis, const KnotPace& pace);

/// A vector over time.
struct VectorJet {
  VectorX x, rate, acceleration;
};
/// Derivatives by the spline's own time, made those by time.
void SetPace(const KnotPace& pace, VectorJet& jet);

/// A cubic spline of vectors over knots at given times: its acceleration is continuous, and linear between knots. Knot
/// k is decided by control points k, k + 1 and k + 2 alone, so that what holds at knots makes a banded system.
class ChainSpline {
 public:
  /// @throws InvalidArgument for fewer than two times or where they do not increase.
  explicit ChainSpline(std::vector<double> time_s);
  /// Some knots in a row of a longer spline, with its basis there. It has no Sample and no Through.
  ChainSpline(std::vector<double> time_s, std::vector<KnotBasis> basis);

  int knots() const { return static_cast<int>(time_s_.size()); }
  int points() const { return knots() + 2; }
  const std::vector<double>& times_s() const { return time_s_; }
  const KnotBasis& At(int knot) const { return basis_[static_cast<std::size_t>(knot)]; }

  /// The control points (columns) of the spline through values (columns, one by knot), with rates at both ends.
  MatrixX Through(const MatrixX& values, const VectorX& first_rate, const VectorX& last_rate) const;

  /// The spline of control points (columns) at a time, which is taken into its range.
  void Sample(const Eigen::Ref<const MatrixX>& points, double at_s, VectorJet& jet) const;

 private:
  std::vector<double> time_s_;
  std::vector<KnotBasis> basis_;
};

}  // namespace gaitwright
