// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright {

/// A ground as `--terrain` names it, see docs/terrain-format.md: a built-in one with its parameters (MakeTerrain), or a
/// file, with parameters too: YAML (.yaml, .yml), a height map (.csv, .png), a mesh (.obj, .stl, .dae). The terrain's
/// name is the text without folders, so that plans hold no path.
/// Failure kBadInput: of MakeTerrain, ReadTerrainYaml, ReadHeightMap, ReadMesh and TerrainFromMesh; a file of another
/// kind; a parameter that is unknown or wrong.
Result<Terrain> LoadTerrain(const std::string& name_or_file, const TerrainScale& scale);

/// The path of the file that a text names, without parameters; "" for a built-in ground.
std::string TerrainFileOf(const std::string& name_or_file);

/// The paths of all files that a ground is read from: the one that the text names and, where that is YAML, those that
/// it names itself; none for a built-in ground.
std::vector<std::string> TerrainFilesOf(const std::string& name_or_file);

}  // namespace gaitwright
