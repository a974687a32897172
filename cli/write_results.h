// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/file.h"

namespace gaitwright::cli {

/// Writes the files of a long run together. Failure: as of WriteFilesTogether, with a hint that the results are kept.
/// @param so_far the file that keeps them, from which --resume continues
Result<std::vector<std::string>> WriteResults(const std::vector<OutputFile>& files, const std::string& so_far);

}  // namespace gaitwright::cli
