// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Address of a server.
struct LiveAddress {
  std::string host = "127.0.0.1";  ///< an address of this machine; the loopback address is local only
  int port = 0;                    ///< 0 for any free port
};

/// A message of a page.
struct LiveSaying {
  std::uint64_t page = 0;
  std::string text;
  bool left = false;  ///< the page was closed or lost
};

/// Serves a page over HTTP and a WebSocket, in its own thread: pages receive frames of the present state and send user
/// actions.
///
/// It accepts at most kMostPages pages at a time and messages up to kLongestLiveMessage. A slow page misses frames but
/// delays no other; a page that is silent and answers no ping for 30 s is disconnected. Requests with a host other than
/// this machine's name or an address, and WebSockets with a foreign Origin are refused (403), so no web page can reach
/// the robot through a user's browser.
class LiveServer {
 public:
  static constexpr int kMostPages = 64;

  /// @param page  the HTML of `/`. Failure kBadInput `address`: not an address of this machine, or in use.
  static Result<std::unique_ptr<LiveServer>> Start(const LiveAddress& address, const std::string& page);
  /// Disconnects all pages.
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  int port() const;
  /// "http://127.0.0.1:8080/"; the loopback address if it listens on all addresses.
  std::string url() const;
  /// Sets the first message to each page, followed by its number; open pages receive it now.
  void Greet(const std::string& greeting);
  /// Sends a frame to every page; it replaces a frame that a slow page has not received yet.
  void Publish(const std::string& picture);
  /// The next message of a page, in order; nothing if there is none. Beyond kMostLiveMessages, the oldest messages of
  /// the busiest page are dropped, but never the notice that a page left.
  std::optional<LiveSaying> Next();
  /// Answers one page, if it is still open.
  void Tell(std::uint64_t page, const std::string& text);
  /// Number of open pages.
  int pages() const;

 private:
  struct Impl;
  explicit LiveServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace gaitwright
