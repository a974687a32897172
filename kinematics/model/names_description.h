// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Whether a text names a robot description rather than a robot by its name: a path, or an ending of a URDF, xacro,
/// MJCF or SDF file.
bool NamesDescription(const std::string& text);

}  // namespace gaitwright
