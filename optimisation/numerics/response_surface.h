// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A quadratic function of n unknowns: constant + slope^T x + x^T curvature x / 2, curvature symmetric.
struct QuadraticSurface {
  double constant = 0.0;
  VectorX slope;
  MatrixX curvature;

  /// Value at x (size n).
  double At(const VectorX& x) const { return constant + slope.dot(x) + 0.5 * x.dot(curvature * x); }
};

/// A surface fitted to measured values, and its cross-validated quality.
struct FittedSurface {
  QuadraticSurface surface;
  /// 1 - sum of squared errors / sum of squares about the mean. Each value is predicted by the fit to all others: 1 is
  /// exact, 0 is no better than the mean. 0 if there are no more values than coefficients, or if all values are equal.
  double predicted = 0.0;
};

/// Coefficients of a quadratic function: (n + 1)(n + 2) / 2.
int CoefficientsOfQuadratic(int unknowns);

/// The quadratic surface with the least squared error at the points (Box and Wilson, J. Royal Stat. Soc. B 13(1),
/// 1951). Exact for values of a quadratic function. The leave-one-out errors follow from the leverage h as e / (1 - h)
/// (Allen, Technometrics 16(1), 1974).
/// @throws InvalidArgument unless there is one value per point, at least as many points as coefficients, all points
/// have the same size of 1 or more, and everything is finite.
FittedSurface FitQuadratic(const std::vector<VectorX>& points, const std::vector<double>& values);

/// The point of the largest value between two corners. Least squares with bounds by Ceres is started from combinations
/// of lower end, middle and upper end of each coordinate (beyond four unknowns, from at most 64 vertices). Each result
/// is then improved along one coordinate after the other. The largest value is returned; of equal values, the first.
///
/// The residuals: along each eigenvector v of the curvature, with t = v^T x, the surface minus its constant is g t + c
/// t^2 / 2. For c < 0 the residual is sqrt(-c) (t + g / c), otherwise sqrt(2 (k - g t - c t^2 / 2)), where k exceeds
/// all values between the corners. Half the sum of their squares equals a constant minus the surface everywhere.
/// @throws InvalidArgument unless all sizes agree and low < high, finite.
VectorX HighestOf(const QuadraticSurface& surface, const VectorX& low, const VectorX& high);

}  // namespace gaitwright
