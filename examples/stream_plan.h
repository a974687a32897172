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

/// How a plan is streamed.
struct StreamOptions {
  double period_s = 0.002;    ///< from one command to the next
  double patience_s = 0.001;  ///< for the answer, less than a period
  double watchdog_s = 0.020;  ///< without a state for longer than this it stops
  /// Waits until that time of the stream and tells what time it is then [s]; empty for the machine's own clock.
  std::function<double(double until_s)> wait_until = {};
};

/// What came of it.
struct StreamReport {
  std::uint64_t sent = 0, lost = 0;
  bool stopped = false;        ///< by the watchdog
  double rate_hz = 0.0;        ///< of commands, as measured
  double largest_error = 0.0;  ///< of a joint against the plan at the time of the command that is answered [rad], [m]
};

/// Sends the plan's joints, with its torques, one command a period, until its end or until the watchdog stops it; of
/// damping ten, since any of them may get lost.
StreamReport StreamPlan(const MotionPlan& plan, const Gains& gains, HardwareAdapter& adapter,
                        const StreamOptions& options);

/// Plans 0.3 m of walking for a robot that comes with the program, and streams it to what listens at a port.
/// @throws InvalidArgument with the reason when it cannot be planned.
StreamReport StreamWalk(const std::string& robot, std::uint16_t port, const StreamOptions& options);

/// A stand-in for a robot in a process of its own, which ends when it is not spoken to any more.
class StandInProcess {
 public:
  /// @param program  the path of `stand_in_robot`.
  /// @throws InvalidArgument when it does not start.
  StandInProcess(const std::string& program, const StandInOptions& options);

  std::uint16_t port() const { return port_; }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> said_;
  std::uint16_t port_ = 0;
};

}  // namespace gaitwright::examples
