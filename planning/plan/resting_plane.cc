// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/resting_plane.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

using Three = std::array<std::size_t, 3>;

Matrix3 PlacesOf(const std::vector<Vector3>& ground_W, const Three& points) {
  Matrix3 places;
  for (int i = 0; i < 3; ++i) places.col(i) << ground_W[points[static_cast<std::size_t>(i)]].head<2>(), 1.0;
  return places;
}

/// Three of the first four points that have the load between them.
Three Around(const std::vector<Vector3>& ground_W, const Vector3& load) {
  constexpr double kTiny = 1e-9;
  const std::size_t corners = std::min<std::size_t>(4, ground_W.size());
  for (std::size_t left_out = corners == 3 ? 3 : 0; left_out < 4; ++left_out) {
    Three points{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < corners && n < 3; ++i)
      if (i != left_out) points[n++] = i;
    const Matrix3 places = PlacesOf(ground_W, points);
    if (n < 3 || std::abs(places.determinant()) < kTiny) continue;
    const Vector3 shares = places.inverse() * load;
    if (shares.minCoeff() >= -kTiny) return points;
  }
  throw InvalidArgument("RestingPlane: the load must be within the polygon of the first four ground points");
}

}  // namespace

Vector3 RestingPlane(const std::vector<Vector3>& ground_W, const Vector2& load_W) {
  constexpr int kMost = 200;
  constexpr double kOn = 1e-9;  // [m]
  const Vector3 load(load_W.x(), load_W.y(), 1.0);
  Three points = Around(ground_W, load);
  Vector3 plane = Vector3::Zero();
  for (int i = 0; i < kMost; ++i) {
    const Matrix3 inverse = PlacesOf(ground_W, points).inverse();
    plane = inverse.transpose() * Vector3(ground_W[points[0]].z(), ground_W[points[1]].z(), ground_W[points[2]].z());
    std::size_t highest = 0;
    double above = kOn;
    for (std::size_t k = 0; k < ground_W.size(); ++k) {
      const double rise = ground_W[k].z() - plane.dot(Vector3(ground_W[k].x(), ground_W[k].y(), 1.0));
      if (rise > above) above = rise, highest = k;
    }
    if (above == kOn) break;
    // The point that the new contact relieves first leaves the support (ratio test of the simplex method).
    const Vector3 shares = inverse * load;
    const Vector3 taken = inverse * Vector3(ground_W[highest].x(), ground_W[highest].y(), 1.0);
    int out = -1;
    double least = 0.0;
    for (int k = 0; k < 3; ++k) {
      if (taken[k] <= 1e-12) continue;
      const double ratio = std::max(shares[k], 0.0) / taken[k];
      if (out < 0 || ratio < least) least = ratio, out = k;
    }
    points[static_cast<std::size_t>(out)] = highest;
  }
  return plane;
}

}  // namespace gaitwright
