// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "planning/plan/terrain.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright::cli {

/// A ground as SVG: from above, with heights as shades, outlines and names of patches, obstacles dark and the robot's
/// place at the start; and below it the section along x through the start.
std::string TerrainPicture(const Terrain& terrain, const TerrainScale& scale);

}  // namespace gaitwright::cli
