// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/words/fake_model.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace gaitwright {

FakeModel::FakeModel(std::vector<FakeAnswer> answers) : answers_(std::move(answers)) {
  socket_ = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  if (socket_ < 0 || ::bind(socket_, reinterpret_cast<sockaddr*>(&address), size) != 0 || ::listen(socket_, 8) != 0 ||
      ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) != 0)
    throw std::runtime_error("no socket on loopback");
  port_ = ntohs(address.sin_port);
  thread_ = std::thread([this] { Serve(); });
}

FakeModel::~FakeModel() {
  stopping_ = true;
  thread_.join();
  ::close(socket_);
}

std::vector<std::string> FakeModel::requests() const {
  const std::lock_guard lock(mutex_);
  return requests_;
}

void FakeModel::Serve() {
  constexpr int kLook = 20;  // [ms]
  while (!stopping_) {
    pollfd waiting{socket_, POLLIN, 0};
    if (::poll(&waiting, 1, kLook) <= 0) continue;
    const int connection = ::accept(socket_, nullptr, nullptr);
    if (connection < 0) continue;
    Answer(connection);
    ::close(connection);
  }
}

void FakeModel::Answer(int connection) {
  std::string request;
  char buffer[4096];
  for (;;) {
    const std::size_t head = request.find("\r\n\r\n");
    const std::size_t length = request.find("Content-Length: ");
    if (head != std::string::npos && length != std::string::npos &&
        request.size() >= head + 4 + std::stoul(request.substr(length + 16)))
      break;
    const ssize_t got = ::recv(connection, buffer, sizeof(buffer), 0);
    if (got <= 0) return;
    request.append(buffer, static_cast<std::size_t>(got));
  }
  std::size_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    number = requests_.size();
    requests_.push_back(request);
  }
  const FakeAnswer& answer = answers_[std::min(number, answers_.size() - 1)];
  if (answer.kind == FakeAnswer::Kind::kHangUp) return;
  while (answer.kind == FakeAnswer::Kind::kSilence && !stopping_) ::usleep(10000);
  if (answer.kind == FakeAnswer::Kind::kSilence) return;
  const nlohmann::json completion = {{"choices", {{{"message", {{"role", "assistant"}, {"content", answer.text}}}}}}};
  const std::string body = answer.kind == FakeAnswer::Kind::kContent ? completion.dump() : answer.text;
  const std::string response =
      "HTTP/1.1 " + std::to_string(answer.status) + " X\r\nContent-Type: application/json\r\n" +
      "Connection: close\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  for (std::size_t sent = 0; sent < response.size();) {
    const ssize_t now = ::send(connection, response.data() + sent, response.size() - sent, MSG_NOSIGNAL);
    if (now <= 0) return;
    sent += static_cast<std::size_t>(now);
  }
}

}  // namespace gaitwright
