// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <fmt/format.h>
#include <grp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "workflows/sandbox/start_child_internal.h"
#include "workflows/sandbox/system_call_filter.h"

namespace gaitwright {
namespace {

constexpr int kReads = 3, kWrites = 4, kTells = 5, kFilter = 6;  // file descriptors in the child
constexpr int kMostHandles = 64;

/// The steps between fork and the program's start, for messages.
enum Step { kFiles, kFolder, kLimits, kUser, kPrivileges, kLandlock, kCalls, kProgram };
constexpr const char* kStepWords[] = {"cannot set up its files",
                                      "cannot enter its working folder",
                                      "cannot set its resource limits",
                                      "cannot switch to user 'nobody'",
                                      "cannot drop its privileges",
                                      "cannot restrict its file access (Landlock)",
                                      "cannot filter its system calls (seccomp)",
                                      "cannot run its program"};

/// Report of the child about a failed step; empty if the program has started.
struct Report {
  int step = 0, error = 0;
};

Failure NotStarted(const std::string& why) {
  return {FailureKind::kBadInput,
          FailureCode::kChild,
          "StartChild",
          "a submission's process cannot be started: " + why,
          {}};
}

/// Pointers to texts for exec; made before fork, since nothing may be allocated after it.
std::vector<char*> Pointers(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

bool Limit(int resource, rlim_t soft, rlim_t hard) {
  const rlimit limit{soft, hard};
  return setrlimit(static_cast<__rlimit_resource>(resource), &limit) == 0;
}

bool SetLimits(const ChildLimits& limits) {
  const auto seconds = static_cast<rlim_t>(std::ceil(limits.time_s));
  const rlim_t memory = static_cast<rlim_t>(limits.memory_mb) << 20, file = static_cast<rlim_t>(limits.file_mb) << 20;
  return Limit(RLIMIT_CPU, seconds, seconds + 1) && Limit(RLIMIT_AS, memory, memory) &&
         Limit(RLIMIT_FSIZE, file, file) && Limit(RLIMIT_NOFILE, kMostHandles, kMostHandles) &&
         Limit(RLIMIT_CORE, 0, 0) && Limit(RLIMIT_MEMLOCK, 0, 0) && Limit(RLIMIT_MSGQUEUE, 0, 0);
}

/// Data that the child needs, prepared before fork.
struct Prepared {
  const ChildSetup& setup;
  const LandlockRules* rules;  ///< nullptr: the child is not confined
  std::vector<char*> arguments, environment;
  int reads, writes, tells;
  int filter;  ///< the child reads its filter of system calls from it; -1: the child is not confined
  pid_t parent;
};

/// Sets the child's files: 0 to 2 are /dev/null, 3 and 4 the pipes, 5 the pipe for reports and 6 the filter (5 and 6
/// until exec). No other files are open.
bool SetFiles(Prepared& p) {
  const int nothing = open("/dev/null", O_RDWR);
  // First move the files away from their final numbers.
  const int r = fcntl(p.reads, F_DUPFD, 16), w = fcntl(p.writes, F_DUPFD, 16), t = fcntl(p.tells, F_DUPFD, 16);
  if (nothing < 0 || r < 0 || w < 0 || t < 0) return false;
  p.tells = t;
  const bool confined = p.filter >= 0;
  const int f = confined ? fcntl(p.filter, F_DUPFD, 16) : -1;
  if (confined && f < 0) return false;
  for (int at = 0; at < kReads; ++at) {
    if (dup2(nothing, at) != at) return false;
  }
  if (dup2(r, kReads) != kReads || dup2(w, kWrites) != kWrites || dup3(t, kTells, O_CLOEXEC) != kTells) return false;
  p.tells = kTells;
  if (confined && dup3(f, kFilter, O_CLOEXEC) != kFilter) return false;
  const int first_unused = confined ? kFilter + 1 : kFilter;
  if (syscall(SYS_close_range, first_unused, ~0U, 0) == 0) return true;
  for (int at = first_unused; at < 65536; ++at) close(at);
  return true;
}

bool BecomeNobody() {
  if (geteuid() != 0) return true;
  return setgroups(0, nullptr) == 0 && setresgid(kNobody, kNobody, kNobody) == 0 &&
         setresuid(kNobody, kNobody, kNobody) == 0;
}

/// Resets signals to their defaults.
void ResetSignals() {
  for (int number = 1; number < NSIG; ++number) signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// Runs in the child until its program starts. @return the step that failed.
Report Become(Prepared& p) {
  ResetSignals();
  setsid();
  if (chdir(p.setup.work_folder.c_str()) != 0) return {kFolder, errno};
  if (!BecomeNobody()) return {kUser, errno};
  // After the change of user, which would undo it.
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return {kPrivileges, errno};
  if (getppid() != p.parent) return {kPrivileges, ESRCH};
  if (p.rules != nullptr) {
    if (const int error = p.rules->RestrictSelf()) return {kLandlock, error};
  }
  if (!SetFiles(p)) return {kFiles, errno};
  if (!SetLimits(p.setup.limits)) return {kLimits, errno};
  if (p.rules != nullptr) {
    if (const int error = ApplyCallFilter(kFilter)) return {kCalls, error};
  }
  execve(p.setup.program.c_str(), p.arguments.data(), p.environment.data());
  return {kProgram, errno};
}

/// Waits until the child's program has started, or the child has reported a failure.
std::optional<Failure> ReasonNotStarted(int report_fd, pid_t process, const ChildSetup& setup) {
  Report report;
  ssize_t n = 0;
  while ((n = read(report_fd, &report, sizeof report)) < 0 && errno == EINTR) {
  }
  if (n == 0) return std::nullopt;
  while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
  }
  return NotStarted(fmt::format("{}: {} ('{}')", kStepWords[report.step], std::strerror(report.error),
                                report.step == kFolder ? setup.work_folder : setup.program));
}

/// A pipe that closes its ends when it is destroyed.
struct Pipe {
  std::array<int, 2> ends{-1, -1};

  Pipe() = default;
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    Close(0);
    Close(1);
  }
  bool Open() { return pipe2(ends.data(), O_CLOEXEC) == 0; }
  void Close(std::size_t end) {
    if (ends[end] >= 0) close(std::exchange(ends[end], -1));
  }
};

/// @param tells   pipe on which the child reports a failed step.
/// @param filter  pipe on which the child gets its filter. The filter depends on the process number, so it is made
///                after fork; in this process, since nothing may be allocated in the child. A child without a filter
///                reports a failure.
Result<pid_t> Fork(Prepared& prepared, Pipe& tells, Pipe& filter) {
  const pid_t process = fork();
  if (process == 0) {
    const Report report = Become(prepared);
    if (write(prepared.tells, &report, sizeof report) < 0) _exit(126);
    _exit(127);
  }
  const int error = errno;
  tells.Close(1);
  if (process < 0) return NotStarted(std::strerror(error));
  if (prepared.filter >= 0) WriteCallFilter(process, filter.ends[1]);
  filter.Close(1);
  if (auto failure = ReasonNotStarted(tells.ends[0], process, prepared.setup)) return *failure;
  return process;
}

}  // namespace

Result<pid_t> StartChild(const ChildSetup& setup, int reads, int writes) {
  std::optional<LandlockRules> rules;
  if (setup.confined) {
    if (const std::string why = ReasonNotConfined(); !why.empty()) return NotStarted(why);
    Result<LandlockRules> made = LandlockRules::Make({setup.readable, setup.work_folder});
    if (!made) return made.failure();
    rules.emplace(std::move(*made));
  }
  Pipe tells, filter;
  if (!tells.Open() || (setup.confined && !filter.Open())) return NotStarted(std::strerror(errno));
  std::vector<std::string> arguments = {setup.program};
  arguments.insert(arguments.end(), setup.arguments.begin(), setup.arguments.end());
  Prepared prepared{setup,
                    rules ? &*rules : nullptr,
                    Pointers(arguments),
                    Pointers(setup.environment),
                    reads,
                    writes,
                    tells.ends[1],
                    filter.ends[0],
                    getpid()};
  return Fork(prepared, tells, filter);
}

}  // namespace gaitwright
