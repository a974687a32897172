// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Where a server listens.
struct LiveAddress {
  std::string host = "127.0.0.1";  ///< an address of this machine; the loopback one is reached from it alone
  int port = 0;                    ///< 0 for any that is free
};

/// A message of a page.
struct LiveSaying {
  std::uint64_t page = 0;
  std::string text;
  bool left = false;  ///< it says no more: it was closed, or lost
};

/// A page over HTTP, and its WebSocket, in a thread of its own: pages are sent pictures of how things stand, and send
/// what people do.
///
/// It takes at most kMostPages at once and messages of kLongestLiveMessage. A page that reads slowly misses pictures
/// and holds nobody up; one that says nothing and answers no ping for half a minute is let go. Requests for
/// another name than this machine's or an address, and WebSockets whose Origin is another page are refused (403): so no
/// page of the web can reach the robot through the browser of somebody.
class LiveServer {
 public:
  static constexpr int kMostPages = 64;

  /// @param page  the HTML that `/` gives. Failure kBadInput `address`: not of this machine, or taken.
  static Result<std::unique_ptr<LiveServer>> Start(const LiveAddress& address, const std::string& page);
  /// Lets all pages go.
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  int port() const;
  /// "http://127.0.0.1:8080/"; this machine's own where it listens at all of its addresses, which are no address to go
  /// to.
  std::string url() const;
  /// What each page is told first, and then its number; those that are open already are told now.
  void Greet(const std::string& greeting);
  /// Sends a picture to every page; it takes the place of one that a slow page has not been sent yet.
  void Publish(const std::string& picture);
  /// What pages have said, in that order; nothing where all has been taken. Beyond kMostLiveMessages the oldest of the
  /// page that said most are dropped; who left never is.
  std::optional<LiveSaying> Next();
  /// Answers one page, where it is still open.
  void Tell(std::uint64_t page, const std::string& text);
  /// How many pages are open.
  int pages() const;

 private:
  struct Impl;
  explicit LiveServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace gaitwright
