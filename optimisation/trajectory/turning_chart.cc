// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "optimisation/trajectory/turning_chart_internal.h"

namespace gaitwright {
namespace {

/// The angle plus a multiple of a full turn that is nearest to another one.
double NearestTurn(double angle, double near) {
  constexpr double kFull = 2.0 * std::numbers::pi;
  return angle + kFull * std::round((near - angle) / kFull);
}

}  // namespace

TurningChart::TurningChart(First first, const Matrix3& R_0) : R_0_(R_0) {
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
  if (first == First::kPitch) axes_ = {y, x, z};
  if (first == First::kRoll) axes_ = {x, z, y};
}

TurningChart TurningChart::For(const std::vector<Matrix3>& R_WB, const Matrix3& R_0) {
  constexpr double kEnough = 1.0;  // [rad]
  TurningChart best;
  double least = 10.0;
  for (const First first : {First::kYaw, First::kPitch, First::kRoll}) {
    const TurningChart chart(first, R_0);
    double widest = 0.0;
    for (const Matrix3& R : R_WB) widest = std::max(widest, std::abs(chart.AnglesOf(R, Vector3::Zero())[1]));
    if (widest >= least) continue;
    least = widest;
    best = chart;
    if (widest <= kEnough) break;
  }
  return best;
}

ChartedTurn TurningChart::At(const AngleJet& jet) const {
  const Matrix3 R1 = Eigen::AngleAxisd(jet.x[0], axes_[0]).toRotationMatrix();
  const Matrix3 R12 = R1 * Eigen::AngleAxisd(jet.x[1], axes_[1]).toRotationMatrix();
  ChartedTurn turn;
  turn.R = R12 * Eigen::AngleAxisd(jet.x[2], axes_[2]).toRotationMatrix() * R_0_;
  const Vector3 &u1 = axes_[0], u2 = R1 * axes_[1], u3 = R12 * axes_[2];
  turn.E << u1, u2, u3;
  const double a = jet.rate[0], b = jet.rate[1], c = jet.rate[2];
  const Vector3 u12 = u1.cross(u2), u13 = u1.cross(u3), u23 = u2.cross(u3), turned = a * u1 + b * u2;
  turn.w = turned + c * u3;
  turn.alpha = turn.E * jet.acceleration + a * b * u12 + c * turned.cross(u3);
  // The first angle turns all, the second what is beyond it.
  turn.w_by_x << u1.cross(turn.w), c * u23, Vector3::Zero();
  turn.alpha_by_x << u1.cross(turn.alpha), jet.acceleration[2] * u23 + c * turned.cross(u23), Vector3::Zero();
  turn.alpha_by_rate << b * u12 + c * u13, a * u12 + c * u23, turned.cross(u3);
  return turn;
}

Vector3 TurningChart::AnglesOf(const Matrix3& R_WB, const Vector3& near) const {
  Matrix3 B;  // right-handed, in whose axes the three are z, y, x
  B << axes_[2], axes_[1], axes_[0];
  const Matrix3 M = B.transpose() * R_WB * R_0_.transpose() * B;
  const double first = std::atan2(M(1, 0), M(0, 0)), second = -std::asin(std::clamp(M(2, 0), -1.0, 1.0)),
               third = std::atan2(M(2, 1), M(2, 2));
  return {NearestTurn(first, near[0]), second, NearestTurn(third, near[2])};
}

AngleJet TurningChart::JetOf(const Matrix3& R_WB, const Vector3& w, const Vector3& alpha, const Vector3& near) const {
  AngleJet jet;
  jet.x = AnglesOf(R_WB, near);
  const Eigen::PartialPivLU<Matrix3> E(At(jet).E);
  jet.rate = E.solve(w);
  jet.acceleration = E.solve(alpha - At(jet).alpha);
  return jet;
}

}  // namespace gaitwright
