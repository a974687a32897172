// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// The paths of all files that a walk is planned from, beside those of its robot: of gaits, also of those that come
/// with the program, of the sequence and of the ground, with what these name in turn. Files that are not there count
/// too.
std::vector<std::string> FilesOf(const WalkRequest& request);

/// Hash of what stands in those files: the same for the same bytes, wherever they lie.
std::string ContentsHash(const WalkRequest& request);

}  // namespace gaitwright
