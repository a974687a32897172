// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "playback/control/controller.h"

namespace gaitwright::examples {

/// Where the joints are, in answer to the command of that number.
struct JointState {
  std::uint64_t number = 0;
  VectorX q, v;
};

/// The controller's side of a robot that takes joint commands over UDP.
///
/// = Datagrams =   doubles in this machine's byte order
///   to the robot  number, q, v, tau_ff, stiffness, damping    of all joints, see JointCommand
///   from it       number of the command it answers, q, v
/// Each command is whole by itself, so that a lost one is made up for by the next. Numbers tell what is late.
/// The watchdog: when no state has come for `watchdog_s` it stops, for good, and all that is sent from then on is
/// damping: no stiffness and no feed-forward, so that joints come to rest wherever they are. A robot should do the same
/// by itself when it hears no commands.
class HardwareAdapter {
 public:
  /// @param robot_port  of this machine (127.0.0.1), where the robot listens; nobody else is heard.
  /// @throws std::system_error for want of a socket.
  explicit HardwareAdapter(std::uint16_t robot_port, double watchdog_s = 0.020);
  ~HardwareAdapter();
  HardwareAdapter(const HardwareAdapter&) = delete;
  HardwareAdapter& operator=(const HardwareAdapter&) = delete;

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
  std::optional<VectorX> Receive(double patience_s, Eigen::Index size) const;

  double watchdog_s_;
  int socket_;
  std::uint64_t sent_ = 0, answered_ = 0, next_ = 0;  // next_: the least number of a state that is new
  std::optional<double> heard_s_;
  bool stopped_ = false;
};

}  // namespace gaitwright::examples
