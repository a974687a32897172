// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "kinematics/model/load_robot.h"

namespace gaitwright {

/// A robot of robots/, read once.
inline const RobotModel& NamedRobot(const std::string& name) {
  static std::map<std::string, RobotModel> robots;
  const auto at = robots.find(name);
  return at != robots.end() ? at->second : robots.emplace(name, LoadNamedRobot(name).value()).first->second;
}

}  // namespace gaitwright
