// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/base_over_feet.h"

#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

Vector3 Middle(const std::vector<Pose>& feet) {
  Vector3 sum = Vector3::Zero();
  for (const Pose& foot : feet) sum += foot.translation();
  return sum / static_cast<double>(feet.size());
}

/// Yaw that rotates the standing feet onto the present feet, about their mean positions; for a single foot, its own
/// yaw.
double FitYaw(const std::vector<Pose>& standing, const std::vector<Pose>& X_WF) {
  if (standing.size() == 1) return YawOf(X_WF[0].linear()) - YawOf(standing[0].linear());
  const Vector3 from = Middle(standing), to = Middle(X_WF);
  double dot = 0.0, cross = 0.0;
  for (std::size_t f = 0; f < standing.size(); ++f) {
    const Vector3 a = standing[f].translation() - from, b = X_WF[f].translation() - to;
    dot += a.x() * b.x() + a.y() * b.y();
    cross += a.x() * b.y() - a.y() * b.x();
  }
  return std::atan2(cross, dot);
}

/// Slope of the least-squares plane through the feet in the base's heading, z = slope . p. Zero in directions in which
/// the feet are not spread.
Vector2 SlopeOf(const Matrix3& R, const Vector3& middle, const std::vector<Pose>& X_WF) {
  constexpr double kSpread = 0.05;  // share of the largest spread
  Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
  Vector2 rises = Vector2::Zero();
  for (const Pose& foot : X_WF) {
    const Vector3 p = R.transpose() * (foot.translation() - middle);
    moments += p.head<2>() * p.head<2>().transpose();
    rises += p.z() * p.head<2>();
  }
  if (moments(0, 0) <= kSpread * kSpread * moments(1, 1)) return Vector2::Zero();
  const double determinant = moments.determinant(), least = kSpread * kSpread * moments(0, 0) * moments(0, 0);
  if (determinant <= least) return {rises.x() / moments(0, 0), 0.0};
  return {(moments(1, 1) * rises.x() - moments(0, 1) * rises.y()) / determinant,
          (moments(0, 0) * rises.y() - moments(0, 1) * rises.x()) / determinant};
}

}  // namespace

BaseOverFeet FitBase(const std::vector<Pose>& standing, const std::vector<Pose>& X_WF) {
  if (standing.empty() || standing.size() != X_WF.size())
    throw InvalidArgument("FitBase: the numbers of standing and present feet must be equal, and at least 1");
  return FitBase(standing, X_WF, FitYaw(standing, X_WF));
}

BaseOverFeet FitBase(const std::vector<Pose>& standing, const std::vector<Pose>& X_WF, double yaw_rad) {
  if (standing.empty() || standing.size() != X_WF.size())
    throw InvalidArgument("FitBase: the numbers of standing and present feet must be equal, and at least 1");
  BaseOverFeet base;
  base.plan.yaw_rad = yaw_rad;
  const Matrix3 R = YawRotation(yaw_rad);
  const Vector3 from = Middle(standing), to = Middle(X_WF), origin = to - R * from;
  base.plan.x_m = origin.x();
  base.plan.y_m = origin.y();
  const Vector2 slope = standing.size() > 2 ? SlopeOf(R, to, X_WF) : Vector2::Zero();
  base.pitch_rad = -std::atan(slope.x());
  base.roll_rad = std::atan(slope.y() * std::cos(base.pitch_rad));
  base.ground_m = to.z() - slope.dot(from.head<2>());
  return base;
}

double MeanHeading(const std::vector<Pose>& standing, const std::vector<Pose>& X_WF) {
  Vector2 sum = Vector2::Zero();
  for (std::size_t f = 0; f < standing.size(); ++f) {
    const double yaw = YawOf(X_WF[f].linear()) - YawOf(standing[f].linear());
    sum += Vector2(std::cos(yaw), std::sin(yaw));
  }
  return std::atan2(sum.y(), sum.x());
}

}  // namespace gaitwright
