// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// The whole text of a file in UTF-8, without a byte-order mark. A failure names the file, and the line of a byte that
/// is no text.
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
/// Signals that ask the program to end wait until that is done.
/// @return the paths in their order; a failure that names the file that cannot be written, or that is named twice.
Result<std::vector<std::string>> WriteFilesTogether(const std::vector<OutputFile>& files);

}  // namespace gaitwright
