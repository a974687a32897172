// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A plane with the whole solid under a patch on one side:
///   normal_W . p <= offset_m for all points of the solid.
struct PartingPlane {
  Vector3 normal_W = Vector3::UnitZ();  ///< unit vector, never downward
  double offset_m = 0.0;

  /// Distance of a point beyond the plane [m].
  double Beyond(const Vector3& p_W) const { return normal_W.dot(p_W) - offset_m; }
};

/// The separating plane of a point. Candidates touch the solid under a patch at its top, at a side or at an edge of its
/// outline. The plane that the point is farthest beyond is returned; for a point inside, the one with the smallest
/// depth.
PartingPlane PlaneBefore(const TerrainPatch& patch, const Vector3& p_W);

/// The separating plane of a short, nearly straight path, given by points in order. It is the plane of the point with
/// the smallest distance beyond its own plane, so the whole path is beyond it unless it touches the solid.
PartingPlane PlaneBefore(const TerrainPatch& patch, const std::vector<Vector3>& path_W);

}  // namespace gaitwright
