// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/trajectory/swing_curve.h"

#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/bspline.h"

namespace gaitwright {
namespace {

/// The step with a cruise, for u in (0, 1): halves of the plain step at both ends, scaled so that the rates match.
Motion1 CruisingStep(double u, double cruise) {
  constexpr double kFastest = 1.875;  // rate of the plain step at half time
  const double ends = 1.0 - cruise, rate = 1.0 / (cruise + ends / kFastest), scale = rate / kFastest;
  if (std::abs(u - 0.5) <= 0.5 * cruise) return {0.5 + rate * (u - 0.5), rate, 0.0};
  const bool late = u > 0.5;
  const Motion1 half = SmoothStep((late ? 1.0 - u : u) / ends);
  const double gone = scale * ends * half.value, acceleration = scale / ends * half.acceleration;
  return {late ? 1.0 - gone : gone, scale * half.rate, late ? -acceleration : acceleration};
}

}  // namespace

Motion1 SmoothStep(double u, double cruise) {
  if (u <= 0.0) return {0.0, 0.0, 0.0};
  if (u >= 1.0) return {1.0, 0.0, 0.0};
  if (cruise > 0.0) return CruisingStep(u, cruise);
  const double w = 1.0 - u;
  return {u * u * u * (10.0 + u * (6.0 * u - 15.0)), 30.0 * u * u * w * w, 60.0 * u * w * (w - u)};
}

Motion1 SmoothBump(double u) {
  if (u <= 0.0 || u >= 1.0) return {};
  const double w = 1.0 - u, uw = u * w, slope = w - u;
  return {64.0 * uw * uw * uw, 192.0 * uw * uw * slope, 384.0 * uw * (slope * slope - uw)};
}

namespace {

/// A parabola over the progress of a step, 1 at its middle.
Motion1 Arc(const Motion1& step) {
  const double slope = 4.0 * (1.0 - 2.0 * step.value);
  return {4.0 * step.value * (1.0 - step.value), slope * step.rate,
          slope * step.acceleration - 8.0 * step.rate * step.rate};
}

/// Offset from the straight move, with its derivatives by the fraction of the swing.
struct Offset {
  Vector3 value = Vector3::Zero(), rate = Vector3::Zero(), acceleration = Vector3::Zero();
};

Offset OffsetAt(const SwingCurve& curve, double u) {
  Offset offset;
  if (curve.detour_W.empty()) {
    const Motion1 bump = curve.cruise > 0.0 ? Arc(SmoothStep(u, curve.cruise)) : SmoothBump(u);
    offset.value.z() = bump.value * curve.lift_m;
    offset.rate.z() = bump.rate * curve.lift_m;
    offset.acceleration.z() = bump.acceleration * curve.lift_m;
    return offset;
  }
  if (u <= 0.0 || u >= 1.0) return offset;
  const int free = static_cast<int>(curve.detour_W.size());
  const QuinticBasis basis = EvaluateQuinticBasis(free + 2 * kFixedSwingPoints, u);
  for (int i = 0; i < 6; ++i) {
    const int point = basis.first + i - kFixedSwingPoints;
    if (point < 0 || point >= free) continue;
    const auto at = static_cast<std::size_t>(i);
    const Vector3& p = curve.detour_W[static_cast<std::size_t>(point)];
    offset.value += basis.value[at] * p;
    offset.rate += basis.rate[at] * p;
    offset.acceleration += basis.acceleration[at] * p;
  }
  return offset;
}

}  // namespace

FrameMotion Evaluate(const SwingCurve& curve, double time_s) {
  const double duration = curve.end_s - curve.start_s;
  const double u = (time_s - curve.start_s) / duration;
  const Motion1 step = SmoothStep(u, curve.cruise);
  const Offset offset = OffsetAt(curve, u);
  const Vector3 travel = curve.X_WF_end.translation() - curve.X_WF_start.translation();
  const Vector3 turn = RotationLog(curve.X_WF_end.linear() * curve.X_WF_start.linear().transpose());
  const double per_s = 1.0 / duration;
  FrameMotion motion;
  motion.X_WF.translation() = curve.X_WF_start.translation() + step.value * travel + offset.value;
  motion.X_WF.linear() = RotationExp(step.value * turn) * curve.X_WF_start.linear();
  motion.v_WF = per_s * (step.rate * travel + offset.rate);
  motion.a_WF = per_s * per_s * (step.acceleration * travel + offset.acceleration);
  motion.w_WF = per_s * step.rate * turn;
  motion.alpha_WF = per_s * per_s * step.acceleration * turn;
  return motion;
}

SwingCurve StraightMoveOf(SwingCurve curve) {
  curve.lift_m = 0.0;
  curve.detour_W.clear();
  return curve;
}

double LiftAtHalfTime(const SwingCurve& curve) { return OffsetAt(curve, 0.5).value.z(); }

}  // namespace gaitwright
