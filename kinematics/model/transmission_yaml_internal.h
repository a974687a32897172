// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <vector>

#include "kinematics/model/robot_yaml.h"

namespace gaitwright {

/// The list under `transmissions` of a robot.yaml. Refuses by line what it says wrong, whatever the robot is.
std::vector<RobotYaml::SharedDrive> ParseTransmissions(const YAML::Node& node);

}  // namespace gaitwright
