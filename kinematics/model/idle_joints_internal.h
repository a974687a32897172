// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Names of the joints that move nothing: the bodies beyond them have no inertia about their axis.
std::vector<std::string> IdleJoints(const RobotModel& model);

/// Fixes joints and the joints that mimic them. @return the names of all these joints.
std::vector<std::string> FixJoints(urdf::ModelInterface& urdf, std::vector<std::string> names);

}  // namespace gaitwright
