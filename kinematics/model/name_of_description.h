// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Name of a robot from its file: the file name without its endings. For an unspecific file name such as `robot.urdf`,
/// it is the name of the folder; if the folder has an unspecific name such as `urdf`, it is the <robot name> of the
/// text.
std::string NameOfDescription(const std::string& path, const std::string& urdf);

}  // namespace gaitwright
