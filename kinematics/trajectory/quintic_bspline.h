// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace gaitwright {

/// The six basis functions that are not zero at one place of a quintic B-spline over u in [0, 1] with even, clamped
/// knots: the spline there is the sum of value[i] times control point first + i, likewise its derivatives by u.
struct QuinticBasis {
  int first = 0;
  std::array<double, 6> value{}, rate{}, acceleration{};
};

/// The basis at u, which is taken into [0, 1]. The first three control points alone decide value, rate and acceleration
/// at u = 0, the last three those at u = 1.
/// @throws InvalidArgument for fewer than six control points.
/// Piegl and Tiller, The NURBS Book, 1997, equations 2.5 and 2.7.
QuinticBasis EvaluateQuinticBasis(int control_points, double u);

}  // namespace gaitwright
