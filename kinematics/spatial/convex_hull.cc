// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/spatial/convex_hull.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

constexpr double kCollinear = 1e-12;

/// Removes corners that are, up to rounding, on the line between their neighbours. This is done after the chains,
/// because a tolerance there can remove a true corner next to two nearly collinear ones.
void DropMiddleCorners(Polygon& hull) {
  for (std::size_t i = 0; hull.size() > 2 && i < hull.size();) {
    const Vector2 in = hull[i] - hull[(i + hull.size() - 1) % hull.size()];
    const Vector2 out = hull[(i + 1) % hull.size()] - hull[i];
    if (std::abs(Cross(in, out)) <= kCollinear && in.dot(out) > 0.0) {
      hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

}  // namespace

Polygon ConvexHull(std::vector<Vector2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vector2& a, const Vector2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  points.erase(std::unique(points.begin(), points.end(), [](const Vector2& a, const Vector2& b) { return a == b; }),
               points.end());
  if (points.size() < 3) return points;
  Polygon hull;
  const auto add_chain = [&hull](auto begin, auto end) {
    const std::size_t base = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= base + 2 && Cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  DropMiddleCorners(hull);
  return hull;
}

double Area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += Cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return polygon.size() < 3 ? 0.0 : 0.5 * twice;
}

double ShareOfHull(const std::vector<Vector2>& outline) {
  const double hull = Area(ConvexHull(outline));
  return hull > 0.0 ? Area(outline) / hull : 0.0;
}

}  // namespace gaitwright
