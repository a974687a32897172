// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright {

/// A built-in kind of ground.
struct BuiltInTerrain {
  std::string name;
  std::string description;
};

/// List of all built-in grounds.
const std::vector<BuiltInTerrain>& BuiltInTerrains();

/// A parameter of a built-in ground and its value.
struct TerrainParameter {
  std::string key, unit;
  double lowest = 0.0, highest = 0.0;
  std::string meaning, value;
};

/// The parameters of a ground, as MakeTerrain accepts them. Fails as MakeTerrain does.
Result<std::vector<TerrainParameter>> TerrainParameters(const std::string& spec, const TerrainScale& scale);

/// A built-in ground from its name, or from name and parameters: `stairs:rise_m=0.07,tread_m=0.25,count=3`. Parameters
/// that are left out get sizes that suit the robot. The feature begins one body length in front of the robot, which
/// stands at the origin and faces x. The terrain's name is the whole text. Failure kBadInput: an unknown ground (the
/// message lists the known ones); an unknown parameter (with the nearest known one); a parameter that is a duplicate,
/// not a number, out of range, or inconsistent with the others.
Result<Terrain> MakeTerrain(const std::string& spec, const TerrainScale& scale);

}  // namespace gaitwright
