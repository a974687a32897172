// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// The paths of files and folders for which this program called fsync since the last call, in order.
std::vector<std::string> TakeSyncedFiles();

}  // namespace gaitwright
