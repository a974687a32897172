// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "workflows/sandbox/landlock_rules.h"

namespace gaitwright {

/// Resource limits of a child process.
struct ChildLimits {
  double time_s = 30.0;  ///< CPU time; it may also sleep for this time plus 10 s
  int memory_mb = 1024;  ///< address space
  int file_mb = 64;      ///< each file of the submission, and all files in the working folder

  OptionFields Fields() {
    return {{"time_s", &time_s, "s", 0.1, 3600.0, "CPU time limit for the code of one part."},
            {"memory_mb", &memory_mb, "MiB", 128, 65536, "Address-space limit for the code of one part."},
            {"file_mb", &file_mb, "MiB", 1, 1024,
             "Size limit of a submitted file, and of all files that the code writes."}};
  }
  double longest_sleep_s() const { return time_s + 10.0; }
};

/// The program to start, and its rights.
struct ChildSetup {
  std::string program;                   ///< its path
  std::vector<std::string> arguments;    ///< arguments after the program's name
  std::vector<std::string> environment;  ///< all its variables, NAME=value
  std::string work_folder;               ///< working folder, and the only writable place
  std::vector<std::string> readable;     ///< see FileRights
  ChildLimits limits;
  bool confined = true;  ///< false: only limits, without Landlock and system-call filter
};

/// Why no child can be confined on this machine; "" if they can.
std::string ReasonNotConfined();

/// User and group of children if the program runs as root: those of nobody.
inline constexpr unsigned kNobody = 65534;

/// An untrusted process with a line-based protocol: it reads file descriptor 3 and writes 4; its standard streams are
/// closed off. It has its own session and no other open files, cannot start processes (if confined), and ends with this
/// object or with this process.
///
/// No call of this class takes longer than the limits allow, or more memory than the longest answer. Time for which the
/// process waits for a busy processor does not count, so marks do not depend on the machine's load.
class ChildProcess {
 public:
  /// Failure `child`: it cannot be confined or started.
  static Result<ChildProcess> Start(const ChildSetup& setup);

  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  /// Sends a line and waits for one. After a failure the process is ended, and all further calls fail with the same
  /// message. Failure kBadInput with one of these codes: `child_ended` (it exited, or a signal ended it, which is
  /// named), `child_time`, `child_files` (it wrote too much), `child_answer` (too long). If it runs out of memory, its
  /// own error ends it.
  Result<std::string> Ask(const std::string& line, std::size_t longest_answer);

 private:
  ChildProcess(int process, int requests, int answers, ChildSetup setup);

  std::optional<Failure> Send(const std::string& line);
  Result<std::string> Receive(std::size_t longest);
  std::optional<Failure> WaitFor(int handle, short what);
  Failure Ended();
  Failure End(FailureCode code, const std::string& message);
  void Kill();
  bool OverFileLimit();

  int process_ = -1;
  int requests_ = -1, answers_ = -1;
  int schedstat_ = -1;  ///< /proc/PID/schedstat; -1 if not available
  ChildSetup setup_;
  double slept_s_ = 0.0;  ///< time that it slept while this process waited for it
  std::chrono::steady_clock::time_point looked_;
  std::string rest_;  ///< text after an answer's end
  std::optional<Failure> failure_;
};

}  // namespace gaitwright
