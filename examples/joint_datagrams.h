// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright::examples {

/// A datagram that came in: doubles in this machine's byte order.
struct ReceivedRow {
  std::uint16_t from_port = 0;
  std::vector<double> row;
};

/// A UDP socket of this machine's own network, 127.0.0.1, on a free port. Datagrams may get lost, come late or out of
/// order: what they mean must not depend on one another.
class LoopbackSocket {
 public:
  /// @throws std::system_error where the system gives none.
  LoopbackSocket();
  ~LoopbackSocket();
  LoopbackSocket(const LoopbackSocket&) = delete;
  LoopbackSocket& operator=(const LoopbackSocket&) = delete;

  std::uint16_t port() const { return port_; }

  /// Sends a row and knows nothing of its fate. @throws std::system_error where it cannot even be sent.
  void Send(std::uint16_t to_port, const std::vector<double>& row) const;

  /// The next datagram; nothing when none has come after that time [s]. 0 does not wait.
  std::optional<ReceivedRow> Receive(double patience_s) const;

 private:
  explicit LoopbackSocket(int fd) : fd_(fd) {}

  int fd_;
  std::uint16_t port_ = 0;
};

/// What a row says: vectors of one size each, and a number that counts up from row to row.
struct NumberedParts {
  std::uint64_t number = 0;
  std::vector<VectorX> parts;
};

/// number, then the parts one after the other.
std::vector<double> RowOf(const NumberedParts& said);

/// The same back; nothing for a row that is not of that form or not all finite, whoever sent it.
std::optional<NumberedParts> PartsOf(const std::vector<double>& row, Eigen::Index part_size, Eigen::Index part_count);

}  // namespace gaitwright::examples
