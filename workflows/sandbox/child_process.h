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

/// How much a child may take.
struct ChildLimits {
  double time_s = 30.0;  ///< of processor; it may sleep as long and 10 s more
  int memory_mb = 1024;  ///< of addresses
  int file_mb = 64;      ///< each file of the submission, and all files in the working folder

  OptionFields Fields() {
    return {{"time_s", &time_s, "s", 0.1, 3600.0, "Time of processor that a part's code may take.", {}},
            {"memory_mb", &memory_mb, "MB", 128, 65536, "Addresses that it may have.", {}},
            {"file_mb", &file_mb, "MB", 1, 1024, "Size of a file handed in, and of all that the code writes.", {}}};
  }
  double longest_sleep_s() const { return time_s + 10.0; }
};

/// What is started, and what it may do.
struct ChildSetup {
  std::string program;                   ///< its path
  std::vector<std::string> arguments;    ///< after the program's own
  std::vector<std::string> environment;  ///< NAME=value; it has no other
  std::string work_folder;               ///< where it runs, and all that it may write
  std::vector<std::string> readable;     ///< see FileRights
  ChildLimits limits;
  bool confined = true;  ///< false: limits alone, neither Landlock nor a filter of system calls
};

/// Why no child can be confined on this machine; "" where it can.
std::string WhyNotConfined();

/// The user and group that children have where the program runs as root: those of nobody.
inline constexpr unsigned kNobody = 65534;

/// A process that is not trusted, and that one talks with in lines: it reads file 3 and writes file 4; its standard
/// input and outputs are nothing. It is in a session of its own, has no other open files, starts no others (where it is
/// confined), and ends with this object, or with this process.
///
/// Whatever it does, no call here takes longer than the limits allow, or more memory than the longest answer. Time that
/// it waits for a processor which others have is not held against it, so that marks do not depend on how busy a machine
/// is.
class ChildProcess {
 public:
  /// Failure `child`: it cannot be confined or started.
  static Result<ChildProcess> Start(const ChildSetup& setup);

  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  /// Sends a line and waits for one. After a failure it is ended, and fails all further calls with the same words.
  /// Failure kBadInput with one of these codes: `child_ended` (by itself or by a signal, which is named), `child_time`,
  /// `child_files` (it wrote too much), `child_answer` (too long). Out of memory it fails by itself.
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
  ChildSetup setup_;
  double slept_s_ = 0.0;  ///< while it was waited for
  std::chrono::steady_clock::time_point looked_;
  std::string rest_;  ///< that came after an answer's end
  std::optional<Failure> failure_;
};

}  // namespace gaitwright
