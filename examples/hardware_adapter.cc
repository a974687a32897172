// SPDX-License-Identifier: BSD-3-Clause
#include "examples/hardware_adapter.h"

namespace gaitwright::examples {

std::optional<JointState> HardwareAdapter::Exchange(double now_s, const JointCommand& command, double patience_s) {
  if (!heard_s_) heard_s_ = now_s;  // the first answer has as long as any
  if (now_s - *heard_s_ > watchdog_s_) stopped_ = true;
  const VectorX none = VectorX::Zero(command.q.size());
  const NumberedParts moving{sent_, {command.q, command.v, command.tau_ff, command.stiffness, command.damping}};
  const NumberedParts stopping{sent_, {command.q, none, none, none, command.damping}};
  socket_.Send(robot_port_, RowOf(stopped_ ? stopping : moving));
  ++sent_;
  std::optional<JointState> newest;
  for (auto received = socket_.Receive(patience_s); received; received = socket_.Receive(0.0)) {
    const auto said = PartsOf(received->row, command.q.size(), 2);
    if (received->from_port != robot_port_ || !said || said->number < next_ || said->number >= sent_) continue;
    next_ = said->number + 1;
    ++answered_;
    heard_s_ = now_s;
    newest = JointState{said->number, said->parts[0], said->parts[1]};
  }
  return newest;
}

}  // namespace gaitwright::examples
