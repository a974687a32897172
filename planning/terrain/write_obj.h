// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/terrain/written_ground.h"

namespace gaitwright {

/// A ground as triangles in a Wavefront OBJ file [m], z up. Each obstacle, patch and height field is a group of
/// triangles, `o NAME`.
///
/// Patches are solids of depth kSolidDepth. Infinite surfaces are cut to the ground's extent (ExtentOf). A height field
/// is only its surface, with two triangles per cell along the diagonal of HeightField. A cylinder is an inscribed prism
/// of 32 sides. In names, _ replaces spaces and characters with a meaning in OBJ files; a number is appended to equal
/// names. The ground that is read back as a mesh has the same heights. For a height field they are exact if it is read
/// with its own resolution_m and its flat parts do not become patches.
/// Failure kBadInput: a ground without surfaces, or with more points or triangles than ReadMesh reads.
Result<WrittenGround> WriteObj(const Terrain& terrain);

}  // namespace gaitwright
