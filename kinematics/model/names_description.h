// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Whether a text is the file name of a robot description, not the name of a robot: it is a path or has the ending of a
/// URDF, xacro or MJCF file.
bool NamesDescription(const std::string& text);

}  // namespace gaitwright
