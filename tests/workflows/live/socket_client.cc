// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/live/socket_client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <stdexcept>
#include <utility>

namespace gaitwright {
namespace {

using Clock = std::chrono::steady_clock;

std::string FrameOf(unsigned char first, const std::string& text) {
  std::string frame(1, static_cast<char>(first));
  const std::size_t n = text.size();
  if (n < 126) {
    frame += static_cast<char>(0x80 | n);
  } else {
    const int bytes = n < 65536 ? 2 : 8;
    frame += static_cast<char>(0x80 | (bytes == 2 ? 126 : 127));
    for (int i = bytes - 1; i >= 0; --i) frame += static_cast<char>(n >> (8 * i) & 0xff);
  }
  const std::string mask = "\x11\x22\x33\x44";
  frame += mask;
  for (std::size_t i = 0; i < n; ++i) frame += static_cast<char>(text[i] ^ mask[i % 4]);
  return frame;
}

}  // namespace

SocketClient::SocketClient(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    ::close(socket_);
    throw std::runtime_error("nobody listens");
  }
}

SocketClient::~SocketClient() { ::close(socket_); }

void SocketClient::SendRaw(const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t n = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (n <= 0) return;  // the other side has closed
    sent += static_cast<std::size_t>(n);
  }
}

bool SocketClient::Fill(Clock::time_point until) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
  pollfd waits = {socket_, POLLIN, 0};
  if (left <= 0 || ::poll(&waits, 1, static_cast<int>(left)) <= 0) return false;
  char bytes[65536];
  const ssize_t n = ::recv(socket_, bytes, sizeof bytes, 0);
  if (n <= 0) return false;
  read_.append(bytes, static_cast<std::size_t>(n));
  return true;
}

std::string SocketClient::Get(const std::string& path, const std::string& header) {
  SendRaw("GET " + path + " HTTP/1.1\r\n" + header + "\r\n");
  const auto until = Clock::now() + std::chrono::seconds(10);
  std::size_t end;
  while ((end = read_.find("\r\n\r\n")) == std::string::npos && Fill(until)) continue;
  if (read_.find(" 101 ") < 20) {
    std::string answer = read_.substr(0, end + 4);
    read_.erase(0, end + 4);
    return answer;
  }
  const std::size_t length = read_.find("Content-Length: ");
  const std::size_t whole =
      end + 4 + (length < end ? static_cast<std::size_t>(std::stoul(read_.substr(length + 16, 20))) : 0);
  while (read_.size() < whole && Fill(until)) continue;
  return std::exchange(read_, "");
}

int SocketClient::Open(const std::string& path, const std::string& origin, const std::string& host) {
  const std::string answer =
      Get(path, "Host: " + host + "\r\n" + (origin.empty() ? "" : "Origin: " + origin + "\r\n") +
                    "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: "
                    "dGhlIHNhbXBsZSBub25jZQ==\r\n");
  return answer.size() > 12 ? std::stoi(answer.substr(9, 3)) : 0;
}

void SocketClient::Say(const std::string& text) { SendRaw(FrameOf(0x81, text)); }

std::optional<std::string> SocketClient::Hear(std::chrono::milliseconds within) {
  const auto until = Clock::now() + within;
  const auto byte = [&](std::size_t i) { return static_cast<std::uint64_t>(static_cast<unsigned char>(read_[i])); };
  while (true) {
    while (read_.size() < 2) {
      if (!Fill(until)) return std::nullopt;
    }
    const std::uint64_t kind = byte(0) & 0x0f, length = byte(1) & 0x7f;
    const std::size_t bytes = length == 126 ? 2 : (length == 127 ? 8 : 0);
    std::uint64_t size = bytes == 0 ? length : 0;
    while (read_.size() < 2 + bytes) {
      if (!Fill(until)) return std::nullopt;
    }
    for (std::size_t i = 0; i < bytes; ++i) size = size << 8 | byte(2 + i);
    while (read_.size() < 2 + bytes + size) {
      if (!Fill(until)) return std::nullopt;
    }
    std::string text = read_.substr(2 + bytes, size);
    read_.erase(0, 2 + bytes + size);
    if (kind == 1) return text;
    if (kind == 8) return std::nullopt;
    if (kind == 9) SendRaw(FrameOf(0x8a, text));
  }
}

}  // namespace gaitwright
