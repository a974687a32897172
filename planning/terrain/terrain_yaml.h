// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright {

/// Reads a ground from YAML, see docs/terrain-format.md: a built-in one to begin with, patches, height fields and
/// obstacles. Files that it names are looked for from its own folder.
/// Failure kBadInput with file and line: text that is no YAML, keys that are unknown (the nearest is named), missing or
/// there twice, values of the wrong kind, numbers out of range, shapes that cannot be, and no ground at all.
Result<Terrain> ReadTerrainYaml(const std::string& path, const TerrainScale& scale);

/// The grounds that such a file names under `files`, with their parameters, from its own folder; none where it is
/// not to be read.
std::vector<std::string> FilesOfTerrainYaml(const std::string& path);

}  // namespace gaitwright
