// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Names of packages with their folders, given by the user.
using PackageFolders = std::vector<std::pair<std::string, std::string>>;

/// The folder of the ROS package `name`, for `package://NAME/` and `$(find NAME)`. Places are searched in this order:
///   1. the folders `given`;
///   2. `folder` (the folder of the file that names the package; "" is the current folder) and each folder above it:
///      the folder itself if it has this name or a package.xml with this name, and a folder NAME in it;
///   3. the folders of the environment variable ROS_PACKAGE_PATH, with packages to two folders below them, and the
///      folders share/NAME of AMENT_PREFIX_PATH;
///   4. the current folder, as in 2, without the folders above it.
/// @param accepts  whether a found folder is accepted; an empty function accepts all folders.
/// @return the absolute path of the first accepted folder. Failure `no_package`: no folder is found; the message lists
/// the searched places, and the hint says how to give the folder.
Result<std::string> FindPackage(const std::string& name, const std::string& folder, const PackageFolders& given = {},
                                const std::function<bool(const std::string&)>& accepts = {});

}  // namespace gaitwright
