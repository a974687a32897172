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

/// A parameter of a built-in ground and its value.
struct TerrainParameter {
  std::string key, unit;
  double lowest = 0.0, highest = 0.0;
  std::string meaning, value;
};

/// The parameters of a ground as MakeTerrain would take them; it fails as that does.
Result<std::vector<TerrainParameter>> TerrainParameters(const std::string& spec, const TerrainScale& scale);

/// A built-in ground by its name, or by name and parameters: `stairs:rise_m=0.07,tread_m=0.25,count=3`. Other
/// parameters have sizes that suit the robot; the feature begins one body length in front of the robot, which stands at
/// the origin and faces x. The terrain's name is the whole text. Failure kBadInput: a ground that does not exist (the
/// list is named), a parameter that it does not have (the nearest is named), that is a duplicate, not a number, out of
/// its range, or inconsistent with the others.
Result<Terrain> MakeTerrain(const std::string& spec, const TerrainScale& scale);

}  // namespace gaitwright
