// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// The whole text of a file, or a failure that names it.
Result<std::string> ReadFile(const std::string& path);

/// Writes the text to a temporary file beside `path` and renames it, so that no half-written file is ever seen.
/// Parent folders are made. @return the path written.
Result<std::string> WriteFileAtomically(const std::string& path, const std::string& text);

}  // namespace gaitwright
