// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "examples/joint_datagrams.h"
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

/// A robot's side of the line: takes commands, lets joints move, answers each command with where they are.
///
/// A joint is a mass with a drive, I v' = tau - load, with the torque of JointCommand taken at the end of the step, so
/// that no gain is too stiff, and a load that the feed-forward meets but for a share:
///   v += h (kp (q_d - q - h v) + kd (v_d - v) - load_error tau_ff) / (I + h kd + h^2 kp),   q += h v.
/// Time goes by with commands alone, so what it does is the same on any machine.
class StandInRobot {
 public:
  StandInRobot(const VectorX& q_start, const StandInOptions& options)
      : options_(options), q_(q_start), v_(VectorX::Zero(q_start.size())) {}

  std::uint16_t port() const { return socket_.port(); }
  const VectorX& q() const { return q_; }
  const VectorX& v() const { return v_; }

  /// Takes one command, if one comes within that time [s], and answers. A command that is older than the last one, or
  /// is none, is passed over.
  void Serve(double patience_s);

 private:
  void Move(const JointCommand& command);

  StandInOptions options_;
  LoopbackSocket socket_;
  VectorX q_, v_;
  std::uint64_t next_ = 0;  // the least number that is new
  int served_ = 0;
};

}  // namespace gaitwright::examples
