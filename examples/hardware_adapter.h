// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "playback/control/controller.h"

namespace gaitwright::examples {

/// State of the joints, in answer to the command of that number.
struct JointState {
  std::uint64_t number = 0;
  VectorX q, v;
};

/// The controller's side of a robot that takes joint commands over UDP.
///
/// = Datagrams =   doubles in this machine's byte order
///   to the robot    number, q, v, tau_ff, stiffness, damping    of all joints, see JointCommand
///   from the robot  number of the answered command, q, v
/// Each command is complete, so the next command replaces a lost one. The numbers show which datagrams are late.
/// Watchdog: if no state arrives for `watchdog_s`, the adapter stops permanently. From then on it sends damping only,
/// without stiffness and feed-forward, so that the joints come to rest at their current positions. The robot itself
/// should do the same if it receives no commands.
class HardwareAdapter {
 public:
  /// @param robot_port  port on 127.0.0.1 where the robot listens; datagrams from other senders are ignored.
  /// @throws std::system_error if no socket can be opened.
  explicit HardwareAdapter(std::uint16_t robot_port, double watchdog_s = 0.020);
  ~HardwareAdapter();
  HardwareAdapter(const HardwareAdapter&) = delete;
  HardwareAdapter& operator=(const HardwareAdapter&) = delete;

  /// Sends a command, or damping after the watchdog has stopped, and receives the answers that have arrived.
  /// @param now_s       time on any monotonic clock [s].
  /// @param patience_s  time to wait for the first answer [s].
  /// @return the newest state, if one has arrived that is newer than all earlier ones.
  std::optional<JointState> Exchange(double now_s, const JointCommand& command, double patience_s);

  bool stopped() const { return stopped_; }
  std::uint64_t sent() const { return sent_; }
  /// Number of commands without an answer, or with an answer that came after the answer to a later command.
  std::uint64_t lost() const { return sent_ - answered_; }

 private:
  std::optional<VectorX> Receive(double patience_s, Eigen::Index size) const;

  double watchdog_s_;
  int socket_;
  std::uint64_t sent_ = 0, answered_ = 0, next_ = 0;  // next_: smallest number of a new state
  std::optional<double> heard_s_;
  bool stopped_ = false;
};

}  // namespace gaitwright::examples
