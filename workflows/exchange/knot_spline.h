// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {

/// Interpolating cubic spline of a scalar through knots at any times, twice continuously differentiable. The first two
/// pieces are one cubic, and so are the last two (not-a-knot). Through three knots it is a parabola, through two a
/// line. de Boor, A Practical Guide to Splines, 1978, chapter IV.
class KnotSpline {
 public:
  /// @throws InvalidArgument for fewer than two knots, times that do not increase, or lists of different lengths.
  KnotSpline(std::vector<double> time_s, std::vector<double> values);

  /// Value and derivatives. Outside the knots: the end value, at rest.
  Motion1 At(double time_s) const;

 private:
  void Slopes();

  std::vector<double> time_s_, values_, rates_;
};

/// The values of the natural cubic smoothing spline
///   min sum_i (y_i - x(t_i))^2 + lambda integral x''^2 dt,   lambda = 1 / (h (2 pi f)^4),  h the mean step,
/// which passes frequencies well below f, removes those well above f, without delay, and halves amplitudes at f.
/// Reinsch, Numerische Mathematik 10, 1967.
/// @param cutoff_hz  f > 0.  @throws InvalidArgument as KnotSpline, and for f not above 0.
std::vector<double> Smoothed(const std::vector<double>& time_s, const std::vector<double>& values, double cutoff_hz);

/// Standard deviation of the noise on evenly sampled values, from their fourth differences, which are small for a
/// smooth motion: median |d4| / (0.6745 sqrt(70)). 0 for fewer than 9 values.
double NoiseOf(const std::vector<double>& values);

}  // namespace gaitwright
