// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <vector>

#include "kinematics/model/robot_yaml.h"

namespace gaitwright {

/// Reads the list `transmissions` of a robot.yaml. Refuses errors that do not depend on the robot, with their lines.
std::vector<RobotYaml::SharedDrive> ParseTransmissions(const YAML::Node& node);

}  // namespace gaitwright
