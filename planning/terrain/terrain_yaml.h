// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright {

/// Reads a ground from YAML, see docs/terrain-format.md: an optional built-in ground, patches, height fields and
/// obstacles. Paths of files are relative to the YAML file's folder. Failure kBadInput with file and line: invalid
/// YAML; keys that are unknown (the message names the nearest one), missing or duplicate; values of the wrong kind;
/// numbers out of range; invalid shapes; no ground.
Result<Terrain> ReadTerrainYaml(const std::string& path, const TerrainScale& scale);

/// The grounds that such a file names under `files`, with parameters and paths that include its folder; empty if the
/// file cannot be read.
std::vector<std::string> FilesOfTerrainYaml(const std::string& path);

}  // namespace gaitwright
