// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "cli/robot_input.h"
#include "workflows/exchange/import_motion.h"

namespace gaitwright::cli {

/// Adds the flags of a motion of other software: the file itself as argument `name`, then robot and ground, then how
/// the file is read. The group of flags for reading stays open.
void AddMotionSource(Verb verb, std::string_view name, std::string_view help, ImportRequest& request,
                     RobotFlags& robot);

/// Adds the files that these flags name.
void AddSourcePaths(const ImportRequest& request, const RobotFlags& robot, Paths& paths);

}  // namespace gaitwright::cli
