// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// The surface of the convex hull of points in space as triangles, counter-clockwise seen from outside; indices into
/// `points`. Points that are, up to rounding, on a face are not corners. Empty for points without volume.
std::vector<Eigen::Vector3i> HullTriangles(const std::vector<Vector3>& points);

}  // namespace gaitwright
