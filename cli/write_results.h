// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/file.h"

namespace gaitwright::cli {

/// Writes the files of a long work together. Failure: as WriteFilesTogether, with a hint that nothing of the work is
/// lost. @param so_far  the file that keeps it, with which --resume goes on
Result<std::vector<std::string>> WriteResults(const std::vector<OutputFile>& files, const std::string& so_far);

}  // namespace gaitwright::cli
