// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/axis_rotations.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gaitwright {
namespace {

constexpr double kNothing = 1e-12;     // a length, or a product of two lengths, that counts as zero
constexpr double kRounding = 1e-12;    // a cosine may exceed 1 by this
constexpr double kDoubleRoot = 1e-14;  // distance of a cosine from 1 at which rounding hides two roots

double AngleBetween(const Vector3& u, const Vector3& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); }

}  // namespace

Angles SolveCosineSine(double a, double b, double c, double any) {
  Angles angles;
  const double r = std::hypot(a, b);
  if (r < kNothing) {
    if (std::abs(c) < kNothing) angles = {{any, any}, 1};
    return angles;
  }
  const double ratio = c / r;
  if (!(std::abs(ratio) <= 1.0 + kRounding)) return angles;
  const double middle = std::atan2(b, a);
  if (std::abs(ratio) > 1.0 - kDoubleRoot) {
    const double at = ratio > 0.0 ? middle : middle + std::numbers::pi;
    return {{at, at}, 1};
  }
  const double half = std::acos(ratio);
  return {{middle + half, middle - half}, 2};
}

Vector3 Turned(const Vector3& axis, double angle_rad, const Vector3& u) {
  const double cosine = std::cos(angle_rad), sine = std::sin(angle_rad);
  return cosine * u + sine * axis.cross(u) + (1.0 - cosine) * axis.dot(u) * axis;
}

double AngleAbout(const Vector3& axis, const Vector3& from, const Vector3& to, double any) {
  const double sine = axis.dot(from.cross(to));
  const double cosine = from.dot(to) - axis.dot(from) * axis.dot(to);
  return std::hypot(sine, cosine) < kNothing * kNothing ? any : std::atan2(sine, cosine);
}

Angles AnglesToHeight(const Vector3& axis, const Vector3& u, const Vector3& h, double height, double any) {
  const double along = axis.dot(u) * axis.dot(h);
  return SolveCosineSine(h.dot(u) - along, h.dot(axis.cross(u)), height - along, any);
}

Angles AnglesToDistance(const Vector3& axis, const Vector3& u, const Vector3& v, double distance, double any) {
  return AnglesToHeight(axis, u, v, 0.5 * (u.squaredNorm() + v.squaredNorm() - distance * distance), any);
}

TwoTurns TurnOnto(const Vector3& a, const Vector3& b, const Vector3& u, const Vector3& v, const Vector2& any) {
  TwoTurns turns;
  const Angles second = AnglesToHeight(b, u, a, a.dot(v), any[1]);
  for (; turns.count < second.count; ++turns.count) {
    const auto i = static_cast<std::size_t>(turns.count);
    turns.second[i] = second.rad[i];
    turns.first[i] = AngleAbout(a, Turned(b, second.rad[i], u), v, any[0]);
  }
  return turns;
}

double TurnGap(const Vector3& a, const Vector3& b, const Vector3& u, const Vector3& v) {
  const double between = AngleBetween(a, b), cone = AngleBetween(b, u), wanted = AngleBetween(a, v);
  const double least = std::abs(between - cone);
  const double most = std::numbers::pi - std::abs(std::numbers::pi - between - cone);
  return std::max({0.0, least - wanted, wanted - most});
}

ThreeTurns DecomposeRotation(const std::array<Vector3, 3>& axes, const Matrix3& R, const Vector3& any) {
  ThreeTurns turns;
  const TwoTurns onto = TurnOnto(axes[0], axes[1], axes[2], R * axes[2], any.head<2>());
  const Vector3 across = axes[2].unitOrthogonal();
  const Vector3 R_across = R * across;
  for (; turns.count < onto.count; ++turns.count) {
    const auto i = static_cast<std::size_t>(turns.count);
    // R(axis 3, x3) rotates `across` to its image under R with the first two rotations removed.
    const Vector3 left = Turned(axes[1], -onto.second[i], Turned(axes[0], -onto.first[i], R_across));
    turns.rad[i] = Vector3(onto.first[i], onto.second[i], AngleAbout(axes[2], across, left, any[2]));
  }
  return turns;
}

}  // namespace gaitwright
