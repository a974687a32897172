// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_yaml.h"

namespace gaitwright {

/// Adds the transmissions of a robot.yaml to a model with known limits and motors; their limits replace the joints'
/// limits. A transmission with a joint that was fixed during loading is left out, with a finding.
/// @throws InvalidArgument with the line for a joint that does not exist, mimics another joint or already has a
/// transmission; for singular ratios, with their regularity; for a motor name that is in use; for effort or speed
/// limits or motor data that the file gives elsewhere for a joint of a transmission.
void ApplyTransmissions(const RobotYaml& yaml, RobotModel& model);

}  // namespace gaitwright
