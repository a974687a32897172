// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// The paths of all input files of a walk except those of its robot: gaits (also built-in ones), sequence and ground,
/// with the files that these name. Missing files are included.
std::vector<std::string> FilesOf(const WalkRequest& request);

/// Hash of the contents of these files, independent of their paths.
std::string ContentsHash(const WalkRequest& request);

}  // namespace gaitwright
