// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include "workflows/render/devtools_pipe_internal.h"

extern char** environ;

namespace gaitwright {
namespace {

constexpr int kItReads = 3, kItWrites = 4;

Failure Broken(const std::string& what) {
  return {FailureKind::kBadInput, FailureCode::kBrowserGone, "DevtoolsPipe", "the browser " + what, {}};
}

/// Two connected ends whose numbers do not clash with those for the program, and that no other process inherits. They
/// are sockets, so that writing without a reader gives an error and no signal.
bool MakePair(std::array<int, 2>& ends) {
  std::array<int, 2> low{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, low.data()) != 0) return false;
  for (std::size_t i = 0; i < 2; ++i) {
    ends[i] = fcntl(low[i], F_DUPFD_CLOEXEC, 10);
    close(low[i]);
  }
  return ends[0] >= 0 && ends[1] >= 0;
}

/// Starts the program in a new process group, so that all its processes can be ended. @return 0 or the error number.
int Spawn(const std::string& program, const std::vector<std::string>& arguments, int reads, int writes,
          pid_t& process) {
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, reads, kItReads);
  posix_spawn_file_actions_adddup2(&actions, writes, kItWrites);
  for (const int quiet : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, quiet, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawn(&process, program.c_str(), &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

/// Waits some time for the process to end after its pipes were closed. Does not reap it.
void WaitForEnd(pid_t process) {
  constexpr int kLooks = 200;
  for (int look = 0; look < kLooks; ++look) {
    siginfo_t ended{};
    if (waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid != 0)
      return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

}  // namespace

Result<DevtoolsPipe> DevtoolsPipe::Start(const std::string& program, const std::vector<std::string>& arguments) {
  std::array<int, 2> commands{}, answers{};
  if (!MakePair(commands) || !MakePair(answers)) return Broken("could not be connected by pipes");
  DevtoolsPipe pipe;
  const int error = Spawn(program, arguments, commands[0], answers[1], pipe.process_);
  close(commands[0]);
  close(answers[1]);
  pipe.to_ = commands[1];
  pipe.from_ = answers[0];
  if (error != 0) {
    pipe.process_ = -1;
    return Broken(fmt::format("'{}' cannot be started: {}", program, std::strerror(error)));
  }
  return pipe;
}

DevtoolsPipe::DevtoolsPipe(DevtoolsPipe&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      to_(std::exchange(other.to_, -1)),
      from_(std::exchange(other.from_, -1)),
      buffer_(std::move(other.buffer_)) {}

DevtoolsPipe::~DevtoolsPipe() {
  for (const int end : {to_, from_})
    if (end >= 0) close(end);
  if (process_ <= 0) return;
  WaitForEnd(process_);
  kill(-process_, SIGKILL);  // also ends its remaining child processes
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

Result<int> DevtoolsPipe::Send(const nlohmann::ordered_json& message) {
  std::string text = message.dump();
  text += '\0';
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t n = send(to_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return Broken("reads no more");
    sent += static_cast<std::size_t>(n);
  }
  return static_cast<int>(text.size());
}

Result<nlohmann::ordered_json> DevtoolsPipe::Receive(double timeout_s) {
  using Clock = std::chrono::steady_clock;
  const auto deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout_s));
  std::size_t searched = 0;
  while (true) {
    if (const std::size_t end = buffer_.find('\0', searched); end != std::string::npos) {
      nlohmann::ordered_json message = nlohmann::ordered_json::parse(buffer_.substr(0, end), nullptr, false);
      buffer_.erase(0, end + 1);
      if (message.is_discarded()) return Broken("sent data that is not JSON");
      return message;
    }
    searched = buffer_.size();
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return Broken(fmt::format("did not answer within {:.0f} s", timeout_s));
    pollfd watch{from_, POLLIN, 0};
    const int ready = poll(&watch, 1, static_cast<int>(left));
    if (ready <= 0) continue;
    std::array<char, 65536> piece{};
    const ssize_t n = read(from_, piece.data(), piece.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return Broken("has ended");
    buffer_.append(piece.data(), static_cast<std::size_t>(n));
  }
}

}  // namespace gaitwright
