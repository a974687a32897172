// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// What a robot is called that comes as a file: the file's name without its endings. `robot.urdf` tells nothing: then
/// it is the name of its folder, and in folders such as `urdf` that of <robot name> in the text.
std::string NameOfDescription(const std::string& path, const std::string& urdf);

}  // namespace gaitwright
