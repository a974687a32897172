// SPDX-License-Identifier: BSD-3-Clause
// A minimal client with the messages of a browser to a live server.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace gaitwright {

/// A WebSocket or plain HTTP connection. Calls wait for at most ten seconds.
class SocketClient {
 public:
  /// @throws std::runtime_error if no server listens.
  explicit SocketClient(int port);
  ~SocketClient();

  /// Sends any bytes as they are.
  void SendRaw(const std::string& bytes);
  /// Requests a path, with header lines that each end in \r\n. @return the whole answer if the server then closes the
  /// connection, or its header if the connection becomes a WebSocket.
  std::string Get(const std::string& path, const std::string& header);
  /// Opens the WebSocket with the origin of a page. @return the status; 101 if it is open.
  int Open(const std::string& path, const std::string& origin, const std::string& host);

  /// Sends a text frame, masked as required for clients.
  void Say(const std::string& text);
  /// The next text; nothing if the connection was closed or no text arrives in time.
  std::optional<std::string> Hear(std::chrono::milliseconds within = std::chrono::seconds(10));

 private:
  bool Fill(std::chrono::steady_clock::time_point until);

  int socket_ = -1;
  std::string read_;
};

}  // namespace gaitwright
