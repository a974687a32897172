// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A plane with all that is solid under a patch on one side of it:
///   normal_W . p <= offset_m for all points of the solid.
struct PartingPlane {
  Vector3 normal_W = Vector3::UnitZ();  ///< unit, never downwards
  double offset_m = 0.0;

  /// How far a point is beyond it [m].
  double Beyond(const Vector3& p_W) const { return normal_W.dot(p_W) - offset_m; }
};

/// Of the planes that touch what is solid under a patch, at its top, at one of its sides or at an edge of its outline,
/// the one that a point is farthest beyond; where the point is inside, least deep.
PartingPlane PlaneBefore(const TerrainPatch& patch, const Vector3& p_W);

/// The same for a way as short as to be nearly straight, by points on it in turn: that of the point that is least far
/// beyond its own, so that the whole way is beyond it where it does not touch the solid.
PartingPlane PlaneBefore(const TerrainPatch& patch, const std::vector<Vector3>& way_W);

}  // namespace gaitwright
