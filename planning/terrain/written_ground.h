// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/plan/terrain.h"

namespace gaitwright {

/// A ground as a file for other programs.
struct WrittenGround {
  std::string bytes;               ///< of the file
  std::string parameters;          ///< with which --terrain reads the file as this ground, without the colon; may be ""
  std::vector<std::string> notes;  ///< in which respects the file differs from the ground
};

/// Side of the square around the origin that is kept of an infinite surface [m].
inline constexpr double kKeptOfPlane = 10.0;

/// The extent of a ground in plan view: that of its bounded surfaces and, if asked for, of its obstacles; with an
/// infinite surface also a square of kKeptOfPlane around the origin. Empty for a ground without surfaces.
Eigen::AlignedBox2d ExtentOf(const Terrain& terrain, bool with_obstacles);

/// Notes of the infinite surfaces, which files of this extent do not contain.
std::vector<std::string> NotesOfCutPlanes(const Terrain& terrain, const Eigen::AlignedBox2d& extent);

/// The friction with which a file that has no friction is read back: the lowest of all surfaces. Adds a note where they
/// differ. "" for the default, else the parameter.
std::string FrictionParameter(const Terrain& terrain, std::vector<std::string>& notes);

}  // namespace gaitwright
