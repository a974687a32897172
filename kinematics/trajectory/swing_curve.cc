// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/trajectory/swing_curve.h"

#include <algorithm>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {

Motion1 SmoothStep(double u) {
  if (u <= 0.0) return {0.0, 0.0, 0.0};
  if (u >= 1.0) return {1.0, 0.0, 0.0};
  const double w = 1.0 - u;
  return {u * u * u * (10.0 + u * (6.0 * u - 15.0)), 30.0 * u * u * w * w, 60.0 * u * w * (w - u)};
}

Motion1 SmoothBump(double u) {
  if (u <= 0.0 || u >= 1.0) return {};
  const double w = 1.0 - u, uw = u * w, slope = w - u;
  return {64.0 * uw * uw * uw, 192.0 * uw * uw * slope, 384.0 * uw * (slope * slope - uw)};
}

FrameMotion Evaluate(const SwingCurve& curve, double time_s) {
  const double duration = curve.end_s - curve.start_s;
  const double u = (time_s - curve.start_s) / duration;
  const Motion1 step = SmoothStep(u), bump = SmoothBump(u);
  const Vector3 travel = curve.X_WF_end.translation() - curve.X_WF_start.translation();
  const Vector3 lift(0.0, 0.0, curve.lift_m);
  const Vector3 turn = RotationLog(curve.X_WF_end.linear() * curve.X_WF_start.linear().transpose());
  const double per_s = 1.0 / duration;
  FrameMotion motion;
  motion.X_WF.translation() = curve.X_WF_start.translation() + step.value * travel + bump.value * lift;
  motion.X_WF.linear() = RotationExp(step.value * turn) * curve.X_WF_start.linear();
  motion.v_WF = per_s * (step.rate * travel + bump.rate * lift);
  motion.a_WF = per_s * per_s * (step.acceleration * travel + bump.acceleration * lift);
  motion.w_WF = per_s * step.rate * turn;
  motion.alpha_WF = per_s * per_s * step.acceleration * turn;
  return motion;
}

double ApexHeight(const SwingCurve& curve) {
  const double base = std::max(curve.X_WF_start.translation().z(), curve.X_WF_end.translation().z());
  double apex = 0.0;
  constexpr int kSamples = 64;
  for (int i = 0; i <= kSamples; ++i) {
    const double time = curve.start_s + (curve.end_s - curve.start_s) * i / kSamples;
    apex = std::max(apex, Evaluate(curve, time).X_WF.translation().z() - base);
  }
  return apex;
}

}  // namespace gaitwright
