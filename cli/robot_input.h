// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright::cli {

/// The robot of a name, or of a URDF where `urdf` is not empty. Where it is refused for what a robot.yaml can tell, a
/// draft of one is written to robot.draft.yaml in the present folder, unless there is such a file, and the failure says
/// so.
Result<RobotModel> ReadRobot(const std::string& name, const std::string& urdf);

}  // namespace gaitwright::cli
