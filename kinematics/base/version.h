// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// The program's version, as in the build's project version.
std::string Version();

}  // namespace gaitwright
