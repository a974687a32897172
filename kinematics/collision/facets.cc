// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "kinematics/collision/facets_internal.h"
#include "kinematics/collision/shape_extent.h"

namespace gaitwright {
namespace {

/// The plane through three points. @return whether all other points are on one side of it.
bool SidePlane(const std::vector<Vector3>& points, const Vector3& a, const Vector3& across, Facet& facet) {
  constexpr double kArea = 1e-10, kFlat = 1e-9;  // [m^2], [m]
  if (across.norm() < kArea) return false;
  facet.normal = across.normalized();
  double most = -std::numeric_limits<double>::infinity(), least = -most;
  for (const Vector3& p : points) {
    most = std::max(most, facet.normal.dot(p - a));
    least = std::min(least, facet.normal.dot(p - a));
  }
  if (most - least < kFlat) return false;  // no volume
  if (most > kFlat && least < -kFlat) return false;
  if (most > kFlat) facet.normal = -facet.normal;
  facet.offset = facet.normal.dot(a);
  return true;
}

std::vector<Facet> HullFacets(const std::vector<Vector3>& points) {
  constexpr std::size_t kMost = 32;
  std::vector<Facet> facets;
  if (points.size() > kMost) return facets;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        Facet facet;
        if (!SidePlane(points, points[i], (points[j] - points[i]).cross(points[k] - points[i]), facet)) continue;
        constexpr double kSame = 1e-9;
        const bool known = std::any_of(facets.begin(), facets.end(), [&](const Facet& other) {
          return (other.normal - facet.normal).norm() < kSame;
        });
        if (!known) facets.push_back(facet);
      }
    }
  }
  return facets;
}

}  // namespace

std::vector<Facet> FacetsOf(const Shape& shape, const Pose& X_AS) {
  std::vector<Facet> facets;
  if (shape.type == ShapeType::kMesh) facets = HullFacets(shape.vertices);
  for (int axis = 0; axis < 3 && shape.type == ShapeType::kBox; ++axis) {
    for (const double side : {-1.0, 1.0}) facets.push_back({side * Vector3::Unit(axis), 0.5 * shape.size[axis]});
  }
  for (Facet& facet : facets) {
    facet.normal = X_AS.linear() * facet.normal;
    facet.offset += facet.normal.dot(X_AS.translation());
  }
  return facets;
}

double BeyondFacets(const std::vector<Facet>& facets, const Shape& shape, const Pose& X_AS) {
  double beyond = -std::numeric_limits<double>::infinity();
  for (const Facet& facet : facets) {
    const Vector3 nearest_S = SupportPoint(shape, -(X_AS.linear().transpose() * facet.normal));
    beyond = std::max(beyond, facet.normal.dot(X_AS * nearest_S) - facet.offset);
  }
  return beyond;
}

}  // namespace gaitwright
