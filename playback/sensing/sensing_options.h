// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/sensing/odometry_options.h"
#include "playback/sensing/sensor_options.h"

namespace gaitwright {

/// What stands between the robot and its controller.
struct SensingOptions {
  std::string state = "true";  ///< see StateSource
  double command_delay_s = 0.0;
  SensorOptions sensors;
  OdometryOptions odometry;

  /// `sensors.` and `odometry.` before the keys of those.
  OptionFields Fields() {
    return Joined({{{"state", &state, "", 0.0, 0.0,
                     "Where the controller has the robot's state from: true, the simulator; measured, joints and "
                     "contacts from their sensors; estimated, the base too, from IMU, joints and contacts.",
                     StateSourceNames()},
                    {"command_delay_s",
                     &command_delay_s,
                     "s",
                     0.0,
                     kLongestDelay,
                     "From the state that a command is made of to its first effect, in whole time steps.",
                     {}}},
                   Prefixed("sensors", sensors.Fields()),
                   Prefixed("odometry", odometry.Fields())});
  }

  /// Whether the controller has the true state at once, as if there were nothing between.
  bool is_transparent() const { return state == "true" && command_delay_s == 0.0; }
};

}  // namespace gaitwright
