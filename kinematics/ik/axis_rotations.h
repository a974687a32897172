// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// No angle, one angle or two angles [rad]. A single angle is a double root, or a chosen one if every angle is a
/// solution.
struct Angles {
  std::array<double, 2> rad{};
  int count = 0;
};

/// Solutions x of a cos x + b sin x = c. A ratio |c| / |(a, b)| that exceeds 1 only by rounding gives a double root.
/// @param any  [rad] the result if a, b and c are all zero.
Angles SolveCosineSine(double a, double b, double c, double any);

/// u rotated about a unit axis through the origin.
Vector3 Turned(const Vector3& axis, double angle_rad, const Vector3& u);

/// The rotation about a unit axis that brings `from` nearest to `to` [rad], in (-pi, pi].
/// @param any  the result if one of them is along the axis.   Paden and Kahan's first subproblem.
double AngleAbout(const Vector3& axis, const Vector3& from, const Vector3& to, double any);

/// Rotations x of u with h . Turned(axis, x, u) = height. @param any  as in SolveCosineSine.
Angles AnglesToHeight(const Vector3& axis, const Vector3& u, const Vector3& h, double height, double any);

/// Rotations x of u with |Turned(axis, x, u) - v| = distance. @param any  as in SolveCosineSine. Paden and Kahan's
/// third subproblem.
Angles AnglesToDistance(const Vector3& axis, const Vector3& u, const Vector3& v, double distance, double any);

/// Solutions of TurnOnto [rad].
struct TwoTurns {
  std::array<double, 2> first{}, second{};
  int count = 0;
};

/// (first, second) with Turned(a, first, Turned(b, second, u)) = v, |u| = |v|.
/// @param any  angles to use if a solution is free, in the same order. Paden and Kahan's second subproblem: Murray, Li
/// and Sastry, A Mathematical Introduction to Robotic Manipulation, 1994, section 3.3.2.
TwoTurns TurnOnto(const Vector3& a, const Vector3& b, const Vector3& u, const Vector3& v, const Vector2& any);

/// Angle of the direction v outside the directions that TurnOnto can reach from u [rad]; 0 inside.
double TurnGap(const Vector3& a, const Vector3& b, const Vector3& u, const Vector3& v);

/// Solutions of DecomposeRotation [rad].
struct ThreeTurns {
  std::array<Vector3, 2> rad;
  int count = 0;
};

/// (x1, x2, x3) with R = R(axis 1, x1) R(axis 2, x2) R(axis 3, x3), for any three unit axes, orthogonal or not. Empty
/// if they cannot represent R; perpendicular neighbours always can.
/// @param any  angles to keep if two of the axes are aligned.
ThreeTurns DecomposeRotation(const std::array<Vector3, 3>& axes, const Matrix3& R, const Vector3& any);

}  // namespace gaitwright
