// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "playback/control/controller.h"

namespace gaitwright::examples {

/// Properties and faults of the stand-in robot.
struct StandInOptions {
  double step_s = 0.002;        ///< time from one command to the next
  double inertia_kg_m2 = 0.02;  ///< of each joint
  double load_error = 0.05;     ///< fraction by which a joint's load exceeds its feed-forward
  int loses_every = 0;          ///< every N-th answer is lost; 0: none
  int silent_after = 0;         ///< number of answers after which it is silent; 0: never
};

/// The robot's side of the protocol of HardwareAdapter: takes commands, moves its joints, and answers each command with
/// their state. The first command sets the number of joints and their initial positions.
///
/// A joint is a mass with a drive, I v' = tau - load. The torque of JointCommand is evaluated at the end of the step,
/// so that any gain is stable. The load exceeds the feed-forward torque by `load_error`:
///   v += h (kp (q_d - q - h v) + kd (v_d - v) - load_error tau_ff) / (I + h kd + h^2 kp),   q += h v.
/// Only commands advance its time, so its motion is the same on any machine.
class StandInRobot {
 public:
  /// @throws std::system_error if no socket can be opened.
  explicit StandInRobot(const StandInOptions& options);
  ~StandInRobot();
  StandInRobot(const StandInRobot&) = delete;
  StandInRobot& operator=(const StandInRobot&) = delete;

  std::uint16_t port() const { return port_; }
  const VectorX& q() const { return q_; }
  const VectorX& v() const { return v_; }

  /// Takes one command and answers it. A command that is older than the last one, or invalid, is ignored.
  /// @return whether a datagram arrived within `patience_s` [s].
  bool Serve(double patience_s);

 private:
  void Move(const JointCommand& command);
  bool Take(const VectorX& row);

  StandInOptions options_;
  int socket_;
  std::uint16_t port_ = 0;
  VectorX q_, v_;
  double next_ = 0.0;  // smallest number of a new command
  int served_ = 0;
};

}  // namespace gaitwright::examples
