// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "examples/joint_datagrams.h"
#include "playback/control/controller.h"

namespace gaitwright::examples {

/// Where the joints are, in answer to the command of that number.
struct JointState {
  std::uint64_t number = 0;
  VectorX q, v;
};

/// The controller's side of a robot that takes joint commands over UDP.
///
/// = Datagrams =
///   to the robot  number, q, v, tau_ff, stiffness, damping    of all joints, see JointCommand
///   from it       number of the command it answers, q, v
/// Each command is whole by itself, so that a lost one is made up for by the next. Numbers tell what is late.
/// The watchdog: when no state has come for `watchdog_s` it stops, for good, and all that is sent from then on is
/// damping: no stiffness and no feed-forward, so that joints come to rest wherever they are. A robot should do the same
/// by itself when it hears no commands.
class HardwareAdapter {
 public:
  /// @param robot_port  where the robot listens.   @throws std::system_error for want of a socket.
  explicit HardwareAdapter(std::uint16_t robot_port, double watchdog_s = 0.020)
      : robot_port_(robot_port), watchdog_s_(watchdog_s) {}

  /// Sends a command, or damping when it has stopped, and takes in what comes.
  /// @param now_s       [s]; on any clock that does not go back.
  /// @param patience_s  how long to wait for the first answer [s].
  /// @return the newest state, if one has come that is newer than all before.
  std::optional<JointState> Exchange(double now_s, const JointCommand& command, double patience_s);

  bool stopped() const { return stopped_; }
  std::uint64_t sent() const { return sent_; }
  /// Commands without an answer in time to be of use: not before that to a later one.
  std::uint64_t lost() const { return sent_ - answered_; }

 private:
  std::uint16_t robot_port_;
  double watchdog_s_;
  LoopbackSocket socket_;
  std::uint64_t sent_ = 0, answered_ = 0, next_ = 0;  // next_: the least number of a state that is new
  std::optional<double> heard_s_;
  bool stopped_ = false;
};

}  // namespace gaitwright::examples
