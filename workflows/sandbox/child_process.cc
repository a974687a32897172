// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/sandbox/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "workflows/sandbox/start_child_internal.h"
#include "workflows/sandbox/system_call_filter.h"

namespace gaitwright {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLookEach = 50;     // [ms] between checks of the files that the child has written
constexpr int kMostFiles = 1000;  // number of files in its folder
constexpr double kMegabyte = 1 << 20;

double SecondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Time [s] for which the first thread of a process has run or waited for a processor, from /proc/PID/schedstat, which
/// is open and counts nanoseconds. 0 if it is not available; then all time counts as sleep.
double ActiveSeconds(int schedstat) {
  std::array<char, 128> text{};
  if (schedstat < 0 || pread(schedstat, text.data(), text.size() - 1, 0) <= 0) return 0.0;
  char* end = text.data();
  const double ran_ns = std::strtod(end, &end);
  return 1e-9 * (ran_ns + std::strtod(end, nullptr));
}

Failure Broken(FailureCode code, const std::string& message) {
  return {FailureKind::kBadInput, code, "ChildProcess", message, {}};
}

void CloseAll(std::initializer_list<int> handles) {
  for (const int handle : handles) {
    if (handle >= 0) close(handle);
  }
}

/// Whether the signal that ended the process means that its CPU time is used up.
bool IsOutOfTime(int signal, const ChildLimits& limits, double used_s) {
  return signal == SIGXCPU || (signal == SIGKILL && used_s >= limits.time_s);
}

std::string EndedBy(int signal, const ChildLimits& limits, double used_s) {
  if (IsOutOfTime(signal, limits, used_s))
    return fmt::format("the code took more than {} s of CPU time", limits.time_s);
  if (signal == SIGXFSZ) return fmt::format("the code wrote a file of more than {} MB", limits.file_mb);
  const char* name = sigabbrev_np(signal);
  return fmt::format("the code crashed: signal {}",
                     name == nullptr ? std::to_string(signal) : fmt::format("SIG{}", name));
}

/// Makes a pipe; this process keeps one end. Writing without a reader gives an error, since Send blocks SIGPIPE.
bool MakePipe(std::array<int, 2>& ends) { return pipe2(ends.data(), O_CLOEXEC) == 0; }

/// Blocks SIGPIPE in this thread while this object exists, and discards a SIGPIPE that arrived meanwhile.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &former_);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;
  ~NoPipeSignal() {
    const timespec at_once{};
    if (sigismember(&former_, SIGPIPE) == 0) sigtimedwait(&pipe_, nullptr, &at_once);
    pthread_sigmask(SIG_SETMASK, &former_, nullptr);
  }

 private:
  sigset_t pipe_{}, former_{};
};

}  // namespace

std::string ReasonNotConfined() {
  const std::string files = ReasonNoLandlock();
  return files.empty() ? ReasonNoCallFilter() : files;
}

Result<ChildProcess> ChildProcess::Start(const ChildSetup& setup) {
  std::array<int, 2> requests{-1, -1}, answers{-1, -1};
  if (!MakePipe(requests) || !MakePipe(answers)) {
    CloseAll({requests[0], requests[1]});
    return Broken(FailureCode::kChild, "cannot create pipes for a submission's process");
  }
  const Result<pid_t> process = StartChild(setup, requests[0], answers[1]);
  CloseAll({requests[0], answers[1]});
  if (!process) {
    CloseAll({requests[1], answers[0]});
    return process.failure();
  }
  for (const int handle : {requests[1], answers[0]}) fcntl(handle, F_SETFL, O_NONBLOCK);
  return ChildProcess(*process, requests[1], answers[0], setup);
}

ChildProcess::ChildProcess(int process, int requests, int answers, ChildSetup setup)
    : process_(process),
      requests_(requests),
      answers_(answers),
      schedstat_(open(fmt::format("/proc/{}/schedstat", process).c_str(), O_RDONLY | O_CLOEXEC)),
      setup_(std::move(setup)),
      looked_(Clock::now()) {}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      requests_(std::exchange(other.requests_, -1)),
      answers_(std::exchange(other.answers_, -1)),
      schedstat_(std::exchange(other.schedstat_, -1)),
      setup_(std::move(other.setup_)),
      slept_s_(other.slept_s_),
      looked_(other.looked_),
      rest_(std::move(other.rest_)),
      failure_(std::move(other.failure_)) {}

ChildProcess::~ChildProcess() { Kill(); }

void ChildProcess::Kill() {
  if (process_ > 0) {
    kill(-process_, SIGKILL);
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  CloseAll({requests_, answers_, schedstat_});
  process_ = requests_ = answers_ = schedstat_ = -1;
}

Failure ChildProcess::End(FailureCode code, const std::string& message) {
  Kill();
  failure_ = Broken(code, message);
  return *failure_;
}

/// The child has closed its end of the pipe: returns the reason.
Failure ChildProcess::Ended() {
  int status = 0;
  rusage used{};
  pid_t ended = 0;
  for (int look = 0; look < 20 && ended == 0; ++look) {
    ended = wait4(process_, &status, WNOHANG, &used);
    if (ended == 0) poll(nullptr, 0, kLookEach);
  }
  if (ended != process_) return End(FailureCode::kChildEnded, "the code closed its output");
  kill(-process_, SIGKILL);
  process_ = -1;
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  const double used_s = seconds(used.ru_utime) + seconds(used.ru_stime);
  if (!WIFSIGNALED(status))
    return End(FailureCode::kChildEnded, fmt::format("the code ended early, with exit status {}", WEXITSTATUS(status)));
  const bool out_of_time = IsOutOfTime(WTERMSIG(status), setup_.limits, used_s);
  return End(out_of_time ? FailureCode::kChildTime : FailureCode::kChildEnded,
             EndedBy(WTERMSIG(status), setup_.limits, used_s));
}

bool ChildProcess::OverFileLimit() {
  namespace fs = std::filesystem;
  std::error_code error;
  double bytes = 0.0;
  int files = 0;
  for (fs::directory_iterator at(setup_.work_folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code gone;
    const auto size = at->symlink_status(gone).type() == fs::file_type::regular ? at->file_size(gone) : 0;
    if (!gone) bytes += static_cast<double>(size);
    ++files;
  }
  return bytes > setup_.limits.file_mb * kMegabyte || files > kMostFiles;
}

std::optional<Failure> ChildProcess::WaitFor(int handle, short what) {
  const Clock::time_point start = Clock::now();
  const double active_s = ActiveSeconds(schedstat_), before_s = slept_s_;
  while (true) {
    if (SecondsSince(looked_) * 1000.0 >= kLookEach) {
      looked_ = Clock::now();
      if (OverFileLimit())
        return End(FailureCode::kChildFiles,
                   fmt::format("the code wrote more than {} MB, or {} files", setup_.limits.file_mb, kMostFiles));
    }
    pollfd ready{handle, what, 0};
    const int found = poll(&ready, 1, kLookEach);
    slept_s_ = before_s + std::max(0.0, SecondsSince(start) - (ActiveSeconds(schedstat_) - active_s));
    if (found > 0) return std::nullopt;
    if (slept_s_ > setup_.limits.longest_sleep_s())
      return End(FailureCode::kChildTime,
                 fmt::format("the code slept for more than {} s in total", setup_.limits.longest_sleep_s()));
  }
}

std::optional<Failure> ChildProcess::Send(const std::string& line) {
  const NoPipeSignal held_back;
  const std::string text = line + "\n";
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t n = write(requests_, text.data() + sent, text.size() - sent);
    if (n >= 0) {
      sent += static_cast<std::size_t>(n);
    } else if (errno == EAGAIN) {
      if (auto failure = WaitFor(requests_, POLLOUT)) return failure;
    } else if (errno != EINTR) {
      return Ended();
    }
  }
  return std::nullopt;
}

Result<std::string> ChildProcess::Receive(std::size_t longest) {
  std::array<char, 65536> piece{};
  std::string line = std::exchange(rest_, "");
  std::size_t searched = 0;
  while (true) {
    const std::size_t end = line.find('\n', searched);
    if (end != std::string::npos) {
      rest_ = line.substr(end + 1);
      line.resize(end);
    }
    if (line.size() > longest)
      return End(FailureCode::kChildAnswer,
                 fmt::format("the answer has more than {} bytes, which no answer needs", longest));
    if (end != std::string::npos) return line;
    searched = line.size();
    if (auto failure = WaitFor(answers_, POLLIN)) return *failure;
    const ssize_t n = read(answers_, piece.data(), piece.size());
    if (n == 0) return Ended();
    if (n > 0) line.append(piece.data(), static_cast<std::size_t>(n));
    if (n < 0 && errno != EINTR && errno != EAGAIN) return Ended();
  }
}

Result<std::string> ChildProcess::Ask(const std::string& line, std::size_t longest_answer) {
  if (failure_) return *failure_;
  if (auto failure = Send(line)) return *failure;
  return Receive(longest_answer);
}

}  // namespace gaitwright
