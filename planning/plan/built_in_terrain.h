// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright {

/// A kind of ground that comes with the program.
struct BuiltInTerrain {
  std::string name;
  std::string description;
};

/// The one list of built-in grounds.
const std::vector<BuiltInTerrain>& BuiltInTerrains();

/// What one parameter of a built-in ground is, and its value.
struct TerrainParameter {
  std::string key, unit;
  double lowest = 0.0, highest = 0.0;
  std::string meaning, value;
};

/// The parameters of a ground as MakeTerrain would take them; it fails as that does.
Result<std::vector<TerrainParameter>> TerrainParameters(const std::string& spec, const TerrainScale& scale);

/// A built-in ground by its name, or by name and parameters: `stairs:rise_m=0.07,tread_m=0.25,count=3`. What is not
/// said has the size that suits the robot; the feature begins one body length ahead of the robot's front, the robot
/// standing at the origin and facing x. The terrain's name is the whole text.
/// Failure kBadInput: a ground that does not exist (the list is named), a parameter that it does not have (the nearest
/// is named), that stands twice, is no number, is out of its range, or does not go with the others.
Result<Terrain> MakeTerrain(const std::string& spec, const TerrainScale& scale);

}  // namespace gaitwright
