// SPDX-License-Identifier: BSD-3-Clause
#include "examples/joint_datagrams.h"

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <ctime>
#include <system_error>

namespace gaitwright::examples {
namespace {

sockaddr_in OnLoopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

void Require(bool done, const char* what) {
  if (!done) throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

LoopbackSocket::LoopbackSocket() : LoopbackSocket(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  Require(fd_ >= 0, "socket");
  sockaddr_in address = OnLoopback(0);  // 0: any that is free
  socklen_t size = sizeof address;
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  Require(bind(fd_, generic, size) == 0 && getsockname(fd_, generic, &size) == 0, "bind");
  port_ = ntohs(address.sin_port);
}

LoopbackSocket::~LoopbackSocket() { close(fd_); }

void LoopbackSocket::Send(std::uint16_t to_port, const std::vector<double>& row) const {
  const sockaddr_in to = OnLoopback(to_port);
  const auto* generic = reinterpret_cast<const sockaddr*>(&to);
  Require(sendto(fd_, row.data(), row.size() * sizeof(double), 0, generic, sizeof to) >= 0, "sendto");
}

std::optional<ReceivedRow> LoopbackSocket::Receive(double patience_s) const {
  constexpr std::size_t kLongestRow = 8188;  // doubles that a datagram of UDP holds
  pollfd watched{fd_, POLLIN, 0};
  const timespec patience{static_cast<std::time_t>(patience_s), static_cast<long>(1e9 * std::fmod(patience_s, 1.0))};
  if (ppoll(&watched, 1, &patience, nullptr) != 1) return std::nullopt;
  ReceivedRow received{0, std::vector<double>(kLongestRow)};
  sockaddr_in from{};
  socklen_t size = sizeof from;
  auto* generic = reinterpret_cast<sockaddr*>(&from);
  const auto bytes = recvfrom(fd_, received.row.data(), kLongestRow * sizeof(double), MSG_DONTWAIT, generic, &size);
  if (bytes < 0) return std::nullopt;
  received.from_port = ntohs(from.sin_port);
  received.row.resize(static_cast<std::size_t>(bytes) / sizeof(double));
  return received;
}

std::vector<double> RowOf(const NumberedParts& said) {
  std::vector<double> row = {static_cast<double>(said.number)};
  for (const VectorX& part : said.parts) row.insert(row.end(), part.begin(), part.end());
  return row;
}

std::optional<NumberedParts> PartsOf(const std::vector<double>& row, Eigen::Index part_size, Eigen::Index part_count) {
  const Eigen::Map<const VectorX> all(row.data(), static_cast<Eigen::Index>(row.size()));
  if (all.size() != 1 + part_size * part_count || !all.allFinite() || all[0] < 0.0 || all[0] > 9e15)
    return std::nullopt;  // beyond that doubles do not count exactly
  NumberedParts said{static_cast<std::uint64_t>(all[0]), {}};
  for (Eigen::Index k = 0; k < part_count; ++k) said.parts.emplace_back(all.segment(1 + k * part_size, part_size));
  return said;
}

}  // namespace gaitwright::examples
