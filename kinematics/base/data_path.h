// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Path of a file or folder that comes with Gaitwright: "robots", "gaits.yaml", "benchmarks/...". In this order:
///   1. the value of the environment variable `variable`, even if that path does not exist;
///   2. `share/gaitwright/NAME` in the folder of the file that contains this code, or in one of the four folders above.
///      This file is the Python module, another shared library, or the program. So an installed tree may be moved. In a
///      build tree, there are links to the source tree;
///   3. the data folder of the configured prefix, then those of /usr/local and /usr, for programs elsewhere that link
///      the libraries;
///   4. the build tree.
/// @return the first path of 2 to 4 that exists, without symbolic links. If no path exists, the path below the
/// configured prefix, so that a message can name it.
std::string DataPath(const std::string& name, const char* variable = nullptr);

}  // namespace gaitwright
