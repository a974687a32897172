// SPDX-License-Identifier: BSD-3-Clause
#include "examples/stand_in_robot.h"

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <system_error>

namespace gaitwright::examples {

StandInRobot::StandInRobot(const StandInOptions& options)
    : options_(options), socket_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in own{AF_INET, 0, {htonl(INADDR_LOOPBACK)}, {}};  // port 0: any free port
  socklen_t size = sizeof own;
  auto* generic = reinterpret_cast<sockaddr*>(&own);
  if (bind(socket_, generic, size) != 0 || getsockname(socket_, generic, &size) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot open a socket for the stand-in robot");
  port_ = ntohs(own.sin_port);
}

StandInRobot::~StandInRobot() { close(socket_); }

void StandInRobot::Move(const JointCommand& command) {
  const double h = options_.step_s;
  const auto kp = command.stiffness.array(), kd = command.damping.array();
  const VectorX torque = (kp * (command.q - q_ - h * v_).array() + kd * (command.v - v_).array() -
                          options_.load_error * command.tau_ff.array())
                             .matrix();
  v_ += (h * torque.array() / (options_.inertia_kg_m2 + h * kd + h * h * kp)).matrix();
  q_ += h * v_;
}

// Applies a command to the joints. @return whether the row is a valid command that is newer than the last one.
bool StandInRobot::Take(const VectorX& row) {
  const Eigen::Index n = (row.size() - 1) / 5;
  if (n < 1 || row.size() != 1 + 5 * n || !row.allFinite() || row[0] < next_) return false;
  if (q_.size() == 0) {
    q_ = row.segment(1, n);
    v_ = VectorX::Zero(n);
  }
  if (q_.size() != n) return false;
  const auto part = [&](Eigen::Index k) { return row.segment(1 + k * n, n); };
  Move({part(0), part(1), part(2), part(3), part(4)});
  next_ = row[0] + 1.0;
  return true;
}

bool StandInRobot::Serve(double patience_s) {
  pollfd watched{socket_, POLLIN, 0};
  if (poll(&watched, 1, static_cast<int>(std::ceil(1e3 * patience_s))) != 1) return false;
  std::array<double, 8188> heard{};  // maximum size of a UDP datagram
  sockaddr_in from{};
  socklen_t size = sizeof from;
  auto* generic = reinterpret_cast<sockaddr*>(&from);
  const auto bytes = recvfrom(socket_, heard.data(), sizeof heard, MSG_DONTWAIT, generic, &size);
  if (bytes < 0) return true;
  const Eigen::Map<const VectorX> row(heard.data(), bytes / static_cast<long>(sizeof(double)));
  if (!Take(row)) return true;
  ++served_;
  const bool lost = options_.loses_every > 0 && served_ % options_.loses_every == 0;
  const bool silent = options_.silent_after > 0 && served_ > options_.silent_after;
  if (lost || silent) return true;
  VectorX answer(1 + 2 * q_.size());
  answer << row[0], q_, v_;
  sendto(socket_, answer.data(), static_cast<std::size_t>(answer.size()) * sizeof(double), 0, generic, size);
  return true;
}

}  // namespace gaitwright::examples
