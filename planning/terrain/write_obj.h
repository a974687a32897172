// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/terrain/written_ground.h"

namespace gaitwright {

/// A ground as triangles in a Wavefront OBJ file [m], z up: a group of triangles, `o NAME`, for each obstacle, patch
/// and height field.
///
/// Patches are solids kSolidDepth deep. Infinite surfaces are cut to the ground's extent (ExtentOf). A height field is
/// its surface alone, each cell two triangles by the diagonal of HeightField. A cylinder is a prism of 32 sides inside
/// it. Names have _ for spaces and for what has a meaning in OBJ files, and a number where they would be the same.
/// Read back as a mesh, the ground has the same heights; those of a height field are exact with its own resolution_m,
/// and where flat parts of it do not become patches.
/// Failure kBadInput: a ground without surfaces, or with more points or triangles than ReadMesh reads.
Result<WrittenGround> WriteObj(const Terrain& terrain);

}  // namespace gaitwright
