// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/plan_view.h"

#include <algorithm>

#include "kinematics/base/non_finite.h"
#include "kinematics/stability/polygon.h"

namespace gaitwright {
namespace {

/// The gap between two outlines in a unit direction that points out of `a`.
double GapAlong(const Polygon& a, const Polygon& b, const Vector2& out) {
  double far_a = -kInfinity, near_b = kInfinity;
  for (const Vector2& p : a) far_a = std::max(far_a, out.dot(p));
  for (const Vector2& p : b) near_b = std::min(near_b, out.dot(p));
  return near_b - far_a;
}

bool ApartAlongEdges(const Polygon& a, const Polygon& b, double gap_m) {
  for (std::size_t i = 0; i < a.size() && a.size() >= 2; ++i) {
    const Vector2 along = a[(i + 1) % a.size()] - a[i];
    if (GapAlong(a, b, Vector2(along.y(), -along.x()).normalized()) >= gap_m) return true;
  }
  return false;
}

Vector2 MiddleOf(const Polygon& a) {
  Vector2 sum = Vector2::Zero();
  for (const Vector2& p : a) sum += p;
  return sum / static_cast<double>(a.size());
}

double Length(const Polygon& a) { return a.size() == 2 ? (a[1] - a[0]).norm() : 0.0; }

}  // namespace

PlanBox BoxOf(const Polygon& points, double margin_m) {
  PlanBox box{Vector2::Constant(kInfinity), Vector2::Constant(-kInfinity)};
  for (const Vector2& p : points) {
    box.lowest = box.lowest.cwiseMin(p);
    box.highest = box.highest.cwiseMax(p);
  }
  box.lowest.array() -= margin_m;
  box.highest.array() += margin_m;
  return box;
}

bool ApartBy(const Polygon& a, const Polygon& b, double gap_m) {
  if (ApartAlongEdges(a, b, gap_m) || ApartAlongEdges(b, a, gap_m)) return true;
  const Vector2 between = MiddleOf(b) - MiddleOf(a);
  return between.norm() > 0.0 && GapAlong(a, b, between.normalized()) >= gap_m;
}

Polygon Widened(const Polygon& outline, double margin_m) {
  if (outline.size() < 3) {
    const PlanBox box = BoxOf(outline, margin_m);
    return {box.lowest, {box.highest.x(), box.lowest.y()}, box.highest, {box.lowest.x(), box.highest.y()}};
  }
  Polygon wide;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2& p = outline[i];
    const Vector2 before = (p - outline[(i + outline.size() - 1) % outline.size()]).normalized();
    const Vector2 after = (outline[(i + 1) % outline.size()] - p).normalized();
    const Vector2 out = Vector2(before.y(), -before.x()) + Vector2(after.y(), -after.x());
    wide.push_back(p + 2.0 * margin_m / out.squaredNorm() * out);
  }
  return wide;
}

double ShareOf(const Polygon& part, const Polygon& outline) {
  const double area = Area(outline);
  if (area > 0.0) return Area(part) / area;
  return Length(outline) > 0.0 ? Length(part) / Length(outline) : 1.0;
}

double ReachOf(const Polygon& outline, const Vector2& direction) {
  double reach = 0.0;
  for (const Vector2& corner : outline) reach = std::max(reach, corner.dot(direction));
  return reach;
}

double DepthOfShare(const Polygon& outline, const Vector2& inward, double share) {
  constexpr int kHalvings = 9;
  double low = -ReachOf(outline, inward), high = ReachOf(outline, -inward);
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (ShareOf(Clipped(outline, inward, -middle), outline) < share ? low : high) = middle;
  }
  return high;
}

}  // namespace gaitwright
