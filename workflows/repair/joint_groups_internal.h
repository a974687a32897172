// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "kinematics/model/upper_body.h"

namespace gaitwright {

inline constexpr char kLegJoints[] = "legs", kArmJoints[] = "arms", kHeadJoints[] = "head", kTorsoJoints[] = "torso";

/// The group of each independent joint: of legs, of arms with all joints that they carry, of the head, and the others.
std::vector<std::string> GroupsOfJoints(const RobotModel& model, const UpperBody& upper);

}  // namespace gaitwright
