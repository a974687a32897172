// SPDX-License-Identifier: BSD-3-Clause
#include "examples/hardware_adapter.h"

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <ctime>
#include <system_error>

namespace gaitwright::examples {

HardwareAdapter::HardwareAdapter(std::uint16_t robot_port, double watchdog_s)
    : watchdog_s_(watchdog_s), socket_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  const sockaddr_in robot{AF_INET, htons(robot_port), {htonl(INADDR_LOOPBACK)}, {}};
  if (connect(socket_, reinterpret_cast<const sockaddr*>(&robot), sizeof robot) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot open a socket to the robot");
}

HardwareAdapter::~HardwareAdapter() { close(socket_); }

std::optional<JointState> HardwareAdapter::Exchange(double now_s, const JointCommand& command, double patience_s) {
  if (!heard_s_) heard_s_ = now_s;  // the watchdog starts with the first command
  if (now_s - *heard_s_ > watchdog_s_) stopped_ = true;
  const Eigen::Index n = command.q.size();
  VectorX row(1 + 5 * n);
  row << static_cast<double>(sent_), command.q, command.v, command.tau_ff, command.stiffness, command.damping;
  if (stopped_) row.segment(1 + n, 3 * n).setZero();
  send(socket_, row.data(), static_cast<std::size_t>(row.size()) * sizeof(double), 0);  // a failure counts as lost
  ++sent_;
  std::optional<JointState> newest;
  for (auto said = Receive(patience_s, 1 + 2 * n); said; said = Receive(0.0, 1 + 2 * n)) {
    if (said->size() != 1 + 2 * n || !said->allFinite()) continue;
    const double number = (*said)[0];
    if (number < static_cast<double>(next_) || number >= static_cast<double>(sent_)) continue;
    newest = JointState{static_cast<std::uint64_t>(number), said->segment(1, n), said->tail(n)};
    next_ = newest->number + 1;
    ++answered_;
    heard_s_ = now_s;
  }
  return newest;
}

// The next datagram, or nothing if none arrives in time. Keeps at most `size` + 1 doubles, enough to detect that it is
// too long.
std::optional<VectorX> HardwareAdapter::Receive(double patience_s, Eigen::Index size) const {
  pollfd watched{socket_, POLLIN, 0};
  const timespec patience{static_cast<std::time_t>(patience_s), static_cast<long>(1e9 * std::fmod(patience_s, 1.0))};
  if (ppoll(&watched, 1, &patience, nullptr) != 1) return std::nullopt;
  VectorX row(size + 1);
  const auto bytes = recv(socket_, row.data(), static_cast<std::size_t>(size + 1) * sizeof(double), MSG_DONTWAIT);
  row.conservativeResize(bytes < 0 ? 0 : bytes / static_cast<long>(sizeof(double)));
  return row;
}

}  // namespace gaitwright::examples
