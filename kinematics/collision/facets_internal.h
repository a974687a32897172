// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A side of a solid: all points p of the solid satisfy normal . p <= offset.
struct Facet {
  Vector3 normal = Vector3::UnitZ();
  double offset = 0.0;
};

/// The sides of a box, or of the convex hull of a mesh of up to 32 vertices, in frame A of X_AS. Empty for other
/// shapes, for more vertices, and for a hull without volume.
std::vector<Facet> FacetsOf(const Shape& shape, const Pose& X_AS);

/// Largest distance of a shape at a pose beyond a side of a solid. It is at most the distance to the solid. If it is
/// negative, its magnitude is a distance out of the solid, and at least the depth. -infinity without sides.
double BeyondFacets(const std::vector<Facet>& facets, const Shape& shape, const Pose& X_AS);

}  // namespace gaitwright
