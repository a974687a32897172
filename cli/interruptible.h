// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <csignal>

namespace gaitwright::cli {

/// Exit status of a run that a signal ended: 128 plus the number of SIGINT, as in shells.
inline constexpr int kInterrupted = 128 + SIGINT;

/// Signals that ask a run to end: Ctrl-C, a request of the system, and SIGUSR1, which mpirun forwards to all ranks
/// without ending them.
inline constexpr std::array<int, 3> kEndings = {SIGINT, SIGTERM, SIGUSR1};

/// While an object exists, the first signal of kEndings lets the current work finish, and the same signal a second time
/// ends the program at once. Only one object may exist at a time.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /// Whether a signal of kEndings has arrived.
  static bool asked();

 private:
  std::array<struct sigaction, kEndings.size()> before_ = {};
};

/// While an object exists, the signals of kEndings are ignored. For a rank that helps rank 0, which releases it at its
/// end.
class Undisturbed {
 public:
  Undisturbed();
  ~Undisturbed();
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;

 private:
  std::array<struct sigaction, kEndings.size()> before_ = {};
};

}  // namespace gaitwright::cli
