// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>
#include <string>

#include "playback/sensing/odometry_options.h"
#include "playback/sensing/sensor_options.h"

namespace gaitwright {

/// Sensors and delays between the robot and its controller.
struct SensingOptions {
  std::string state = "true";  ///< see StateSource
  double command_delay_s = 0.0;
  std::string drive_loop = "own";  ///< see DriveLoop
  SensorOptions sensors;
  OdometryOptions odometry;

  /// Includes the options of sensors and odometry, with the prefixes `sensors.` and `odometry.`.
  OptionFields Fields() {
    return Joined(
        {WithBasics(
             {"state", "command_delay_s"},
             {{"state", &state, "", 0.0, 0.0,
               "Source of the controller's state: simulator (true); joints and contacts from sensors (measured); also "
               "the base from IMU odometry (estimated).",
               StateSourceNames()},
              {"command_delay_s", &command_delay_s, "s", 0.0, kLongestDelay,
               "Delay from the state that a command uses to the command's first effect, rounded to whole time steps."},
              {"drive_loop", &drive_loop, "", 0.0, 0.0,
               "Feedback of the PD loop with play.actuation=torque: exact joint state at each step (own), or the "
               "controller's sensed, delayed state (sensed).",
               DriveLoopNames()}}),
         Prefixed("sensors", sensors.Fields()), Prefixed("odometry", odometry.Fields())});
  }

  /// Whether the controller gets the true state without delay.
  bool is_transparent() const { return state == "true" && command_delay_s == 0.0 && drive_loop == "own"; }

  /// Age of the speeds in a sensed loop when its command takes effect, beyond the time step [s].
  double LoopDelay() const {
    if (state == "true") return command_delay_s;
    const double wait_s = sensors.encoder_rate_hz > 0.0 ? 1.0 / sensors.encoder_rate_hz : 0.0;
    const double lag_s = sensors.speed_cutoff_hz > 0.0 ? 1.0 / (std::numbers::pi * sensors.speed_cutoff_hz) : 0.0;
    return command_delay_s + sensors.encoder_delay_s + wait_s + lag_s;
  }
};

}  // namespace gaitwright
