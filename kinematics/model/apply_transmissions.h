// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_yaml.h"

namespace gaitwright {

/// Adds the transmissions of a robot.yaml to a model with known limits and motors; their limits replace the joints'
/// limits. A transmission with a joint that was fixed during loading is left out, with a finding.
/// @throws InvalidArgument with the line for a joint that does not exist, mimics another or has a transmission already;
/// ratios that are singular, with figures; a motor's name that is taken; limits of effort or speed, or traits of a
/// motor, that the file gives such a joint elsewhere.
void ApplyTransmissions(const RobotYaml& yaml, RobotModel& model);

}  // namespace gaitwright
