// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>
#include <string>

#include "playback/sensing/odometry_options.h"
#include "playback/sensing/sensor_options.h"

namespace gaitwright {

/// What stands between the robot and its controller.
struct SensingOptions {
  std::string state = "true";  ///< see StateSource
  double command_delay_s = 0.0;
  std::string drive_loop = "own";  ///< see DriveLoop
  SensorOptions sensors;
  OdometryOptions odometry;

  /// `sensors.` and `odometry.` before the keys of those.
  OptionFields Fields() {
    return Joined(
        {{{"state", &state, "", 0.0, 0.0,
           "Where the controller has the robot's state from: true, the simulator; measured, joints and "
           "contacts from their sensors; estimated, the base too, from IMU, joints and contacts.",
           StateSourceNames()},
          {"command_delay_s",
           &command_delay_s,
           "s",
           0.0,
           kLongestDelay,
           "From the state that a command is made of to its first effect, in whole time steps.",
           {}},
          {"drive_loop", &drive_loop, "", 0.0, 0.0,
           "What stiffness and damping of a command act on, with play.actuation=torque: own, the joint as its "
           "drive's own encoder has it at that step; sensed, the state that the controller has, so that they "
           "come with its sensors' errors and the delay.",
           DriveLoopNames()}},
         Prefixed("sensors", sensors.Fields()),
         Prefixed("odometry", odometry.Fields())});
  }

  /// Whether the controller has the true state at once, as if there were nothing between.
  bool is_transparent() const { return state == "true" && command_delay_s == 0.0 && drive_loop == "own"; }

  /// How old the speeds that a sensed loop damps with are when its command acts, beyond the time step [s].
  double LoopDelay() const {
    if (state == "true") return command_delay_s;
    const double wait_s = sensors.encoder_rate_hz > 0.0 ? 1.0 / sensors.encoder_rate_hz : 0.0;
    const double lag_s = sensors.speed_cutoff_hz > 0.0 ? 1.0 / (std::numbers::pi * sensors.speed_cutoff_hz) : 0.0;
    return command_delay_s + sensors.encoder_delay_s + wait_s + lag_s;
  }
};

}  // namespace gaitwright
