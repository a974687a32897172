// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/plan/terrain.h"

namespace gaitwright {

/// A ground as a file for other programs.
struct WrittenGround {
  std::string bytes;               ///< content of the file
  std::string parameters;          ///< for --terrain to read the file as this ground; without the colon, may be ""
  std::vector<std::string> notes;  ///< differences between the file and the ground
};

/// Side of the square around the origin to which an infinite surface is cut [m].
inline constexpr double kKeptOfPlane = 10.0;

/// The extent of a ground in plan view: that of its bounded surfaces and, if `with_obstacles`, of its obstacles. With
/// an infinite surface it includes a square of side kKeptOfPlane around the origin. Empty for a ground without
/// surfaces.
Eigen::AlignedBox2d ExtentOf(const Terrain& terrain, bool with_obstacles);

/// Notes about infinite surfaces that are cut to this extent.
std::vector<std::string> NotesOfCutPlanes(const Terrain& terrain, const Eigen::AlignedBox2d& extent);

/// The parameter for the friction of a file without friction: the lowest coefficient of all surfaces. Adds a note if
/// surfaces have different coefficients. "" for the default coefficient.
std::string FrictionParameter(const Terrain& terrain, std::vector<std::string>& notes);

}  // namespace gaitwright
