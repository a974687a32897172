// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/swing_ground.h"

#include <algorithm>
#include <cmath>

#include "kinematics/base/non_finite.h"

namespace gaitwright {
namespace {

/// The lowest and the highest corner of the box around an obstacle along its own axes, in O.
std::pair<Vector3, Vector3> BoxAbout(const Obstacle& obstacle) {
  Vector3 half = 0.5 * obstacle.size_m;
  if (obstacle.type == ShapeType::kCylinder)
    half = Vector3(obstacle.size_m.x(), obstacle.size_m.x(), 0.5 * obstacle.size_m.y());
  if (obstacle.type != ShapeType::kMesh) return {-half, half};
  Vector3 low = Vector3::Constant(kInfinity), high = -low;
  for (const Vector3& vertex : obstacle.vertices_O) low = low.cwiseMin(vertex), high = high.cwiseMax(vertex);
  return {low, high};
}

}  // namespace

std::optional<std::pair<double, double>> HeightsOf(const Obstacle& obstacle, const Vector2& p_W) {
  const auto [low, high] = BoxAbout(obstacle);
  const Pose X_OW = obstacle.X_WO.inverse();
  const Vector3 origin = X_OW * Vector3(p_W.x(), p_W.y(), 0.0), up = X_OW.linear().col(2);
  double from = -kInfinity, to = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    constexpr double kAcross = 1e-12;
    if (std::abs(up[axis]) < kAcross) {
      if (origin[axis] < low[axis] || origin[axis] > high[axis]) return std::nullopt;
      continue;
    }
    const double a = (low[axis] - origin[axis]) / up[axis], b = (high[axis] - origin[axis]) / up[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (!(from <= to)) return std::nullopt;
  return std::pair{from, to};
}

double HeightToClear(const Terrain& terrain, const Vector2& p_W, double below_m) {
  const GroundPoint ground = GroundAt(terrain, p_W);
  double height = ground.patch < 0 ? -kInfinity : ground.height_m;
  for (const Obstacle& obstacle : terrain.obstacles) {
    const auto heights = HeightsOf(obstacle, p_W);
    if (heights && heights->first < below_m) height = std::max(height, heights->second);
  }
  return height;
}

}  // namespace gaitwright
