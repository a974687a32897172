// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Names of packages and the folders that hold them, as a user gives them.
using PackageFolders = std::vector<std::pair<std::string, std::string>>;

/// The folder of the ROS package `name`, for `package://NAME/` and `$(find NAME)`. It is looked for in this order:
///   1. the folders `given`;
///   2. `folder` (of the file that names the package; "" the current folder) and each folder above it: the folder
///      itself where it has that name or a package.xml with that name, and a folder NAME in it;
///   3. the folders of the environment variable ROS_PACKAGE_PATH, with packages to two folders below them, and the
///      folders share/NAME of AMENT_PREFIX_PATH;
///   4. the current folder, as in 2, without the folders above it.
/// @param accepts  whether a found folder is accepted; all are if empty.
/// @return the absolute path of the first folder that is accepted. Failure `no_package`: there is none; the message
/// lists the searched folders and how to give one.
Result<std::string> FindPackage(const std::string& name, const std::string& folder, const PackageFolders& given = {},
                                const std::function<bool(const std::string&)>& accepts = {});

}  // namespace gaitwright
