// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "playback/control/controller.h"

namespace gaitwright::examples {

/// How the stand-in is unlike a perfect robot.
struct StandInOptions {
  double step_s = 0.002;        ///< time that goes by from one command to the next
  double inertia_kg_m2 = 0.02;  ///< of each joint
  double load_error = 0.05;     ///< share by which the load on a joint is more than the feed-forward for it
  int loses_every = 0;          ///< each so-manieth of its answers gets lost; 0 for none
  int silent_after = 0;         ///< answers after which it falls silent; 0 for never
};

/// A robot's side of the line, see HardwareAdapter: takes commands, lets joints move, answers each command with where
/// they are. It has as many joints as the first command is for, and they are where that one wants them.
///
/// A joint is a mass with a drive, I v' = tau - load, with the torque of JointCommand taken at the end of the step, so
/// that no gain is too stiff, and a load that the feed-forward meets but for a share:
///   v += h (kp (q_d - q - h v) + kd (v_d - v) - load_error tau_ff) / (I + h kd + h^2 kp),   q += h v.
/// Time goes by with commands alone, so what it does is the same on any machine.
class StandInRobot {
 public:
  /// @throws std::system_error for want of a socket.
  explicit StandInRobot(const StandInOptions& options);
  ~StandInRobot();
  StandInRobot(const StandInRobot&) = delete;
  StandInRobot& operator=(const StandInRobot&) = delete;

  std::uint16_t port() const { return port_; }
  const VectorX& q() const { return q_; }
  const VectorX& v() const { return v_; }

  /// Takes one command and answers. A command that is older than the last one, or is none, is passed over.
  /// @return whether anything came within that time [s].
  bool Serve(double patience_s);

 private:
  void Move(const JointCommand& command);
  bool Take(const VectorX& row);

  StandInOptions options_;
  int socket_;
  std::uint16_t port_ = 0;
  VectorX q_, v_;
  double next_ = 0.0;  // the least number that is new
  int served_ = 0;
};

}  // namespace gaitwright::examples
