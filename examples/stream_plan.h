// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "examples/hardware_adapter.h"
#include "examples/stand_in_robot.h"
#include "planning/plan/motion_plan.h"
#include "playback/control/gains.h"

namespace gaitwright::examples {

/// Options of streaming a plan.
struct StreamOptions {
  double period_s = 0.002;    ///< time from one command to the next
  double patience_s = 0.001;  ///< time to wait for an answer, less than a period
  double watchdog_s = 0.020;  ///< time without a state after which the stream stops
  /// Waits until a time of the stream and returns the time after waiting [s]; if empty, the machine's clock is used.
  std::function<double(double until_s)> wait_until = {};
};

/// Result of streaming a plan.
struct StreamReport {
  std::uint64_t sent = 0, lost = 0;
  bool stopped = false;        ///< whether the watchdog stopped it
  double rate_hz = 0.0;        ///< measured rate of commands
  double largest_error = 0.0;  ///< largest joint error, against the plan at the time of the answered command [rad], [m]
};

/// Sends the plan's joint positions, velocities and torques, one command a period, until the plan ends. If the watchdog
/// stops it, it sends ten damping commands, because some of them may get lost.
StreamReport StreamPlan(const MotionPlan& plan, const Gains& gains, HardwareAdapter& adapter,
                        const StreamOptions& options);

/// Plans a walk of 0.3 m for a built-in robot, and streams it to the robot or stand-in that listens at a port.
/// @throws InvalidArgument if the walk cannot be planned.
StreamReport StreamWalk(const std::string& robot, std::uint16_t port, const StreamOptions& options);

/// A stand-in robot in a separate process, which ends when it no longer receives commands.
class StandInProcess {
 public:
  /// @param program  the path of `stand_in_robot`.
  /// @throws InvalidArgument if the program does not start.
  StandInProcess(const std::string& program, const StandInOptions& options);

  std::uint16_t port() const { return port_; }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> said_;
  std::uint16_t port_ = 0;
};

}  // namespace gaitwright::examples
