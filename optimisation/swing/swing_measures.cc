// SPDX-License-Identifier: BSD-3-Clause
// Clearance and reach of a swing's curve.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/base/non_finite.h"
#include "optimisation/swing/refine_swing.h"
#include "planning/audit/swing_depth.h"

namespace gaitwright {

std::vector<Vector3> UndersideOf(const Foot& foot) {
  std::vector<Vector3> points = {Vector3::Zero()};
  constexpr int kAround = 8;
  for (int i = 0; foot.radius > 0.0 && i < kAround; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kAround;
    for (const double share : {0.6, 1.0}) {  // of the radius; heights 0.2 and 1 of the radius
      const Vector2 away = share * foot.radius * Vector2(std::cos(angle), std::sin(angle));
      points.emplace_back(away.x(), away.y(), foot.radius * (1.0 - std::sqrt(1.0 - share * share)));
    }
  }
  if (foot.sole_F.empty()) return points;
  points.clear();
  Vector2 middle = Vector2::Zero();
  for (const Vector2& corner : foot.sole_F) middle += corner / static_cast<double>(foot.sole_F.size());
  constexpr int kPieces = 4;  // samples of an edge
  for (std::size_t i = 0; i < foot.sole_F.size(); ++i) {
    const Vector2 &corner = foot.sole_F[i], &next = foot.sole_F[(i + 1) % foot.sole_F.size()];
    for (int piece = 0; piece < kPieces; ++piece) {
      const Vector2 edge = corner + (next - corner) * piece / kPieces, inner = 0.5 * (edge + middle);
      points.emplace_back(edge.x(), edge.y(), 0.0);
      points.emplace_back(inner.x(), inner.y(), 0.0);
    }
  }
  points.emplace_back(middle.x(), middle.y(), 0.0);
  return points;
}

double ClearanceRamp(double u) {
  return std::min(SmoothStep(u / kClearanceEnds).value, SmoothStep((1.0 - u) / kClearanceEnds).value);
}

double ClearanceMargin(const SwingCurve& curve, const std::vector<Vector3>& underside_F, const GroundHeight& ground,
                       double clearance_m, const SwingRoll& roll) {
  constexpr int kSamples = 180;
  double least = kInfinity;
  for (int k = 1; k < kSamples; ++k) {
    const double u = static_cast<double>(k) / kSamples;
    Pose X_WF = Evaluate(curve, curve.start_s + u * (curve.end_s - curve.start_s)).X_WF;
    X_WF.translation() += roll.At(u);
    const double asked = clearance_m * ClearanceRamp(u) - kDepthMargin * SwingEndShare(u);
    for (const Vector3& q_F : underside_F) {
      const Vector3 q_W = X_WF * q_F;
      least = std::min(least, q_W.z() - ground(q_W.head<2>()) - asked);
    }
  }
  return least;
}

double MidSwingClearance(const SwingCurve& curve, const std::vector<Vector3>& underside_F, const GroundHeight& ground,
                         const SwingRoll& roll) {
  constexpr int kSamples = 24;
  double lowest = kInfinity;
  for (int i = 0; i <= kSamples; ++i) {
    const double u = kClearanceEnds + (1.0 - 2.0 * kClearanceEnds) * i / kSamples;
    Pose X_WF = Evaluate(curve, curve.start_s + u * (curve.end_s - curve.start_s)).X_WF;
    X_WF.translation() += roll.At(u);
    for (const Vector3& q_F : underside_F) {
      const Vector3 q_W = X_WF * q_F;
      lowest = std::min(lowest, q_W.z() - ground(q_W.head<2>()));
    }
  }
  return lowest;
}

double OutOfReach(const SwingCurve& curve, const std::vector<ReachAt>& reach, const SwingRoll& roll) {
  double out = -kInfinity;
  for (const ReachAt& at : reach) {
    const double time_s = curve.start_s + at.u * (curve.end_s - curve.start_s);
    const Vector3 p_W = Evaluate(curve, time_s).X_WF.translation() + roll.At(at.u);
    for (const ReachSide& side : at.sides) out = std::max(out, side.normal_W.dot(p_W) - side.offset_m);
  }
  return out;
}

}  // namespace gaitwright
