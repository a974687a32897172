// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright {

/// A ground as given to `--terrain`, see docs/terrain-format.md: a built-in ground (MakeTerrain), a YAML file (.yaml,
/// .yml), a height map (.csv, .png) or a mesh (.obj, .stl, .dae); all but YAML files accept parameters. The terrain's
/// name is the text without folders, so that plans contain no path.
/// Failure kBadInput: those of MakeTerrain, ReadTerrainYaml, ReadHeightMap, ReadMesh and TerrainFromMesh; a file of
/// another kind; an unknown or wrong parameter.
Result<Terrain> LoadTerrain(const std::string& name_or_file, const TerrainScale& scale);

/// The path of the file that a text names, without parameters; "" for a built-in ground.
std::string TerrainFileOf(const std::string& name_or_file);

/// The paths of all files of a ground: the file that the text names and, if that is YAML, the files that it names;
/// empty for a built-in ground.
std::vector<std::string> TerrainFilesOf(const std::string& name_or_file);

}  // namespace gaitwright
