// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/energy_margin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaitwright {
namespace {

double RiseOver(const Vector3& a, const Vector3& b, const Vector3& p_WC) {
  const Vector3 along = (b - a).normalized();
  const Vector3 arm = (p_WC - a) - (p_WC - a).dot(along) * along;
  const double cos_inclination = along.head<2>().norm();
  return arm.norm() * cos_inclination - arm.z();
}

/// The contact point below a corner of the hull.
Vector3 Lifted(const Support& support, const Vector2& corner) {
  return *std::min_element(support.points_W.begin(), support.points_W.end(), [&](const Vector3& a, const Vector3& b) {
    return (a.head<2>() - corner).squaredNorm() < (b.head<2>() - corner).squaredNorm();
  });
}

}  // namespace

double EnergyMargin(const MotionSample& sample) {
  const Polygon& polygon = sample.support.polygon;
  const Vector2 below = sample.p_WC.head<2>();
  if (polygon.size() < 3) {
    const double d = SignedDistance(polygon, below), z = sample.p_WC.z() - sample.support.reference_W.z();
    return -(std::hypot(d, z) - z);
  }
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double rise = RiseOver(Lifted(sample.support, a), Lifted(sample.support, b), sample.p_WC);
    const Vector2 edge = b - a, to = below - a;
    smallest = std::min(smallest, edge.x() * to.y() - edge.y() * to.x() >= 0.0 ? rise : -rise);
  }
  return smallest;
}

}  // namespace gaitwright
