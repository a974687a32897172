// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The side of a solid: all of it is where normal . p <= offset.
struct Facet {
  Vector3 normal = Vector3::UnitZ();
  double offset = 0.0;
};

/// The sides of a box, or of the convex hull of a mesh of up to 32 vertices, moved to the frame that X_AS leads to.
/// Nothing for other shapes, for more vertices, and for a hull without volume.
std::vector<Facet> FacetsOf(const Shape& shape, const Pose& X_AS);

/// How far a shape at a pose is beyond the side that parts it best from a solid: at most the distance, and where that
/// is negative a way out of the solid at least as long as the depth. -infinity without sides.
double BeyondFacets(const std::vector<Facet>& facets, const Shape& shape, const Pose& X_AS);

}  // namespace gaitwright
