// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/file.h"
#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"

namespace gaitwright::cli {

/// A ground as files for other programs.
struct GroundFiles {
  std::vector<OutputFile> files;   ///< the one that was asked for first
  std::string terrain;             ///< what --terrain takes to read it back; "" where it does not read such files
  std::vector<std::string> notes;  ///< in which respects the files differ from the ground
};

/// The files of a ground: by the ending of `path` MuJoCo's MJCF (.xml), triangles (.obj) or 16-bit grey heights (.png).
/// Failure as of WriteObj and WriteHeights. @throws InvalidArgument for another ending.
Result<GroundFiles> MakeGroundFiles(const Terrain& terrain, const std::string& path);

}  // namespace gaitwright::cli
