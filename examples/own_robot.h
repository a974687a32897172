// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright::examples {

/// Loads a robot from a URDF file alone, without robot.yaml even if there is one. Derives its legs, feet and standing
/// posture. A failure names the error in the file.
Result<RobotModel> ReadOwnRobot(const std::string& urdf_path);

/// Text that describes what was derived: legs, feet, standing height, and notes on the source of each.
std::string WhatWasDerived(const RobotModel& model);

/// Plans a walk of two leg lengths at the robot's default speed, with its best gait; or fails with the reason.
Result<PlannedWalk> PlanOwnWalk(const RobotModel& model);

/// Text of a failure: its message, then one line for each suggestion.
std::string ReasonRefused(const Failure& failure);

}  // namespace gaitwright::examples
