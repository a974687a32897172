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
  std::vector<OutputFile> files;   ///< the requested file first
  std::string terrain;             ///< value of --terrain that reads the files back; "" if it cannot read them
  std::vector<std::string> notes;  ///< how the files differ from the ground
};

/// Makes the files of a ground. The ending of `path` decides the format: MuJoCo's MJCF (.xml), triangles (.obj) or
/// 16-bit greyscale heights (.png). Failures: as of WriteObj and WriteHeights. @throws InvalidArgument for another
/// ending.
Result<GroundFiles> MakeGroundFiles(const Terrain& terrain, const std::string& path);

}  // namespace gaitwright::cli
