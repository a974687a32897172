// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/base_over_feet.h"

#include <Eigen/QR>
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

/// Yaw that turns the standing feet onto the feet as they are, about their middles; of a single foot its own.
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

}  // namespace

BaseOverFeet FitBase(const std::vector<Pose>& standing, const std::vector<Pose>& X_WF) {
  if (standing.empty() || standing.size() != X_WF.size())
    throw InvalidArgument("FitBase needs as many feet as stand, and at least one");
  BaseOverFeet base;
  base.plan.yaw_rad = FitYaw(standing, X_WF);
  const Matrix3 R = YawRotation(base.plan.yaw_rad);
  const Vector3 from = Middle(standing), to = Middle(X_WF), origin = to - R * from;
  base.plan.x_m = origin.x();
  base.plan.y_m = origin.y();
  // Heights in the base's heading: z = slope . p; directions in which the feet are not spread give no slope.
  constexpr double kSpread = 0.05;  // of the largest
  Eigen::MatrixX2d places(static_cast<Eigen::Index>(X_WF.size()), 2);
  VectorX heights(static_cast<Eigen::Index>(X_WF.size()));
  for (std::size_t f = 0; f < X_WF.size(); ++f) {
    const Vector3 p = R.transpose() * (X_WF[f].translation() - to);
    places.row(static_cast<Eigen::Index>(f)) = p.head<2>();
    heights[static_cast<Eigen::Index>(f)] = p.z();
  }
  const bool spread_x = places.col(0).norm() > kSpread * places.col(1).norm();
  const bool wide = standing.size() > 2;
  Vector2 slope = Vector2::Zero();
  if (wide && spread_x) slope = places.colPivHouseholderQr().solve(heights);
  base.pitch_rad = -std::atan(slope.x());
  base.roll_rad = std::atan(slope.y() * std::cos(base.pitch_rad));
  base.ground_m = to.z() - slope.dot(from.head<2>());
  return base;
}

}  // namespace gaitwright
