// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {

/// Interpolating cubic spline of a scalar on a uniform grid, at rest (zero rate) at both ends, twice continuously
/// differentiable. de Boor, A Practical Guide to Splines, 1978, chapter IV.
class CubicSpline {
 public:
  /// @param values two or more, at start_s + i * step_s.  @throws InvalidArgument for fewer or step_s not positive.
  CubicSpline(double start_s, double step_s, std::vector<double> values);

  /// Value and derivatives; outside the grid, the value at the nearer end, at rest.
  Motion1 At(double time_s) const;

 private:
  double start_s_, step_s_;
  std::vector<double> values_, rates_;
};

}  // namespace gaitwright
