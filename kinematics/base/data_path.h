// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Path of a file or folder that comes with Gaitwright: "robots", "gaits.yaml", "benchmarks/...". In this order:
///   1. the value of the environment variable `variable`, which need not exist;
///   2. `share/gaitwright/NAME` in the folder of the file that holds this code, or in one of the four folders above.
///      That file is the Python module, another shared library, or else the program. So an installed tree may be moved.
///      A build tree has links to the source tree there;
///   3. the data folder of the prefix that was configured, then those of /usr/local and /usr. Programs elsewhere that
///      link the libraries find the data there;
///   4. the build tree.
/// @return the first of 2 to 4 that exists, without symbolic links. Where none exists, the path below the configured
/// prefix, so that a message can name it.
std::string DataPath(const std::string& name, const char* variable = nullptr);

}  // namespace gaitwright
