// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace gaitwright {

/// The basis functions that are not zero at one place of a clamped B-spline: the spline there is the sum of value[i]
/// times control point first + i; derivatives in the same way.
template <std::size_t degree>
struct BsplineBasis {
  int first = 0;
  std::array<double, degree + 1> value{}, rate{}, acceleration{};
};

using CubicBasis = BsplineBasis<3>;
using QuinticBasis = BsplineBasis<5>;

/// Of a quintic spline over u in [0, 1] with even knots, at u, which is taken into [0, 1]; derivatives by u. The first
/// three control points alone decide value, rate and acceleration at u = 0, the last three those at u = 1.
/// @throws InvalidArgument for fewer than six control points.
/// Piegl and Tiller, The NURBS Book, 1997, equations 2.5 and 2.7.
QuinticBasis EvaluateQuinticBasis(int control_points, double u);

/// Of a cubic spline that is three times differentiable but at its breaks, there twice; at t, which is taken into their
/// range; derivatives by t. There are two more control points than breaks; the first two alone decide value and rate at
/// the first break, the last two those at the last. At a break the last of the four functions is zero with all its
/// derivatives, but at the last break the first is.
/// @throws InvalidArgument for fewer than two breaks or where they do not increase.
CubicBasis EvaluateCubicBasis(const std::vector<double>& breaks, double t);

}  // namespace gaitwright
