// SPDX-License-Identifier: BSD-3-Clause
// What a browser says to a live server, word by word.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace gaitwright {

/// A connection of a WebSocket, or of HTTP alone. Calls wait for at most ten seconds.
class SocketClient {
 public:
  /// @throws std::runtime_error where nobody listens.
  explicit SocketClient(int port);
  ~SocketClient();

  /// Sends any bytes as they are.
  void SendRaw(const std::string& bytes);
  /// Asks for a path, with lines of a header each ended by \r\n. @return the whole answer of a server that then closes,
  /// or its header where it becomes a WebSocket.
  std::string Get(const std::string& path, const std::string& header);
  /// Opens the WebSocket as that page. @return the status, 101 where it is open.
  int Open(const std::string& path, const std::string& origin, const std::string& host);

  /// A frame of text, masked as a client has to.
  void Say(const std::string& text);
  /// The next text; nothing where the connection was closed or none comes in time.
  std::optional<std::string> Hear(std::chrono::milliseconds within = std::chrono::seconds(10));

 private:
  bool Fill(std::chrono::steady_clock::time_point until);

  int socket_ = -1;
  std::string read_;
};

}  // namespace gaitwright
