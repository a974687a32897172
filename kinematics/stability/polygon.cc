// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/stability/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

Vector2 NearestOnSegment(const Vector2& a, const Vector2& b, const Vector2& p) {
  const Vector2 ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return a + t * ab;
}

}  // namespace

double SignedDistance(const Polygon& polygon, const Vector2& point) {
  if (polygon.empty()) throw InvalidArgument("SignedDistance: the polygon has no corner; one or more are needed");
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = polygon.size() >= 3;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2& b = polygon[(i + 1) % polygon.size()];
    nearest = std::min(nearest, (point - NearestOnSegment(a, b, point)).norm());
    inside = inside && Cross(b - a, point - a) >= 0.0;
  }
  return inside ? nearest : -nearest;
}

Vector2 NearestPoint(const Polygon& polygon, const Vector2& point) {
  if (SignedDistance(polygon, point) > 0.0) return point;
  Vector2 best = polygon.front();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 candidate = NearestOnSegment(polygon[i], polygon[(i + 1) % polygon.size()], point);
    if ((candidate - point).squaredNorm() < (best - point).squaredNorm()) best = candidate;
  }
  return best;
}

Polygon Clipped(const Polygon& polygon, const Vector2& normal, double least) {
  const auto height = [&](const Vector2& p) { return normal.dot(p) - least; };
  Polygon clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& p = polygon[i];
    const Vector2& next = polygon[(i + 1) % polygon.size()];
    const double h = height(p), h_next = height(next);
    if (h >= 0.0) clipped.push_back(p);
    if ((h > 0.0 && h_next < 0.0) || (h < 0.0 && h_next > 0.0)) clipped.push_back(p + h / (h - h_next) * (next - p));
  }
  return clipped;
}

Polygon Shrunk(const Polygon& polygon, double margin_m) {
  Polygon shrunk = polygon;
  for (std::size_t i = 0; i < polygon.size() && polygon.size() >= 3; ++i) {
    const Vector2 along = (polygon[(i + 1) % polygon.size()] - polygon[i]).normalized();
    const Vector2 inward(-along.y(), along.x());
    shrunk = Clipped(shrunk, inward, inward.dot(polygon[i]) + margin_m);
  }
  return polygon.size() >= 3 ? ConvexHull(shrunk) : polygon;
}

Vector2 Centroid(const Polygon& polygon) {
  if (polygon.size() < 3) {
    Vector2 sum = Vector2::Zero();
    for (const Vector2& p : polygon) sum += p;
    return sum / static_cast<double>(std::max<std::size_t>(polygon.size(), 1));
  }
  Vector2 sum = Vector2::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2& b = polygon[(i + 1) % polygon.size()];
    sum += Cross(a, b) * (a + b);
  }
  return sum / (6.0 * Area(polygon));
}

}  // namespace gaitwright
