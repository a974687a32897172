// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "planning/plan/terrain.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright::cli {

/// Draws a ground as SVG. The top view has heights as shades, outlines and names of patches, dark obstacles and the
/// robot's place at the start. Below it is the section along x through the start.
std::string TerrainPicture(const Terrain& terrain, const TerrainScale& scale);

}  // namespace gaitwright::cli
