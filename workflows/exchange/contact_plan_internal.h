// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Whether a YAML text has a plan of contacts as the LIPM walking controller reads it.
bool HoldsContactPlan(const std::string& text);

/// A plan of contacts of the LIPM walking controller as a text with footsteps (ReadFootsteps), in which each footstep
/// is on the line of its contact, so that messages name the right line. The first two contacts are the start.
/// @param unused  gets the keys that have no effect. @throws InvalidArgument and YAML::Exception, with the line.
std::string FootstepsOfContactPlan(const RobotModel& model, const std::string& text, std::vector<std::string>& unused);

}  // namespace gaitwright
