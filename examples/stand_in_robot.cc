// SPDX-License-Identifier: BSD-3-Clause
#include "examples/stand_in_robot.h"

namespace gaitwright::examples {

void StandInRobot::Move(const JointCommand& command) {
  const double h = options_.step_s;
  const auto kp = command.stiffness.array(), kd = command.damping.array();
  const VectorX torque = (kp * (command.q - q_ - h * v_).array() + kd * (command.v - v_).array() -
                          options_.load_error * command.tau_ff.array())
                             .matrix();
  v_ += (h * torque.array() / (options_.inertia_kg_m2 + h * kd + h * h * kp)).matrix();
  q_ += h * v_;
}

void StandInRobot::Serve(double patience_s) {
  const std::optional<ReceivedRow> received = socket_.Receive(patience_s);
  if (!received) return;
  const std::optional<NumberedParts> said = PartsOf(received->row, q_.size(), 5);
  if (!said || said->number < next_) return;
  next_ = said->number + 1;
  ++served_;
  Move({said->parts[0], said->parts[1], said->parts[2], said->parts[3], said->parts[4]});
  const bool lost = options_.loses_every > 0 && served_ % options_.loses_every == 0;
  const bool silent = options_.silent_after > 0 && served_ > options_.silent_after;
  if (!lost && !silent) socket_.Send(received->from_port, RowOf({said->number, {q_, v_}}));
}

}  // namespace gaitwright::examples
