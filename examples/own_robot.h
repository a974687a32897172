// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright::examples {

/// A robot is data: that of a URDF file and nothing else, no robot.yaml even if there is one. Legs, feet and a standing
/// posture are derived; a failure names what in the file is wrong.
Result<RobotModel> ReadOwnRobot(const std::string& urdf_path);

/// What was derived, for people: its legs, their feet, how high it stands, and notes on what each was taken from.
std::string WhatWasDerived(const RobotModel& model);

/// A walk of two leg lengths at the robot's own speed, with its best gait, or why there is none.
Result<PlannedWalk> PlanOwnWalk(const RobotModel& model);

/// Why something failed and what would help, a line each.
std::string WhyNot(const Failure& failure);

}  // namespace gaitwright::examples
