// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Name of a robot from a file: the file's name without its endings. For an unspecific name such as `robot.urdf`, it is
/// the name of the folder, and in folders such as `urdf` the <robot name> of the text.
std::string NameOfDescription(const std::string& path, const std::string& urdf);

}  // namespace gaitwright
