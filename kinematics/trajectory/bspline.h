// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace gaitwright {

/// The non-zero basis functions of a clamped B-spline at one point. The spline is the sum of value[i] times control
/// point first + i; its derivatives are sums of the derivatives.
template <std::size_t degree>
struct BsplineBasis {
  int first = 0;
  std::array<double, degree + 1> value{}, rate{}, acceleration{};
};

using CubicBasis = BsplineBasis<3>;
using QuinticBasis = BsplineBasis<5>;

/// Basis of a quintic spline over u in [0, 1] with uniform knots; u is limited to [0, 1]; derivatives by u. The first
/// three control points alone determine value, rate and acceleration at u = 0, and the last three at u = 1.
/// @throws InvalidArgument for fewer than six control points.
/// Piegl and Tiller, The NURBS Book, 1997, equations 2.5 and 2.7.
QuinticBasis EvaluateQuinticBasis(int control_points, double u);

/// Basis of a cubic spline that is twice continuously differentiable at its knots; t is limited to their range;
/// derivatives by t. There are two more control points than knots. The first two alone determine value and rate at the
/// first knot, and the last two at the last knot. At a knot, the last of the four functions and its derivatives are
/// zero; at the last knot, the first function and its derivatives are zero.
/// @param knots  the knots. @throws InvalidArgument for fewer than two knots, or knots that do not increase.
CubicBasis EvaluateCubicBasis(const std::vector<double>& knots, double t);

}  // namespace gaitwright
