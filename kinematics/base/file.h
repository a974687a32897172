// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// The whole text of a file, or a failure that names it.
Result<std::string> ReadFile(const std::string& path);

/// Writes the text to a temporary file beside `path` and renames it, so that no half-written file is ever seen.
/// Parent folders are made. @return the path written.
Result<std::string> WriteFileAtomically(const std::string& path, const std::string& text);

/// What is to be written where.
struct OutputFile {
  std::string path, text;
};

/// Writes all of the files or none: each to a temporary beside its path, then all are renamed. Upon a failure every
/// file and folder is again as it was found; files that were there before keep their old text. Parent folders are made.
/// @return the paths in their order; a failure that names the file that cannot be written, or that is named twice.
Result<std::vector<std::string>> WriteFilesTogether(const std::vector<OutputFile>& files);

}  // namespace gaitwright
