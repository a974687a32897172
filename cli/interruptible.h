// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <csignal>

namespace gaitwright::cli {

/// Exit status of a run that a signal ended: 128 and the signal's number, as shells have it.
inline constexpr int kInterrupted = 128 + SIGINT;

/// What asks a run to end: Ctrl-C, a request of the system, and what mpirun hands on to all ranks without ending them
/// itself.
inline constexpr std::array<int, 3> kEndings = {SIGINT, SIGTERM, SIGUSR1};

/// While it lives, the first of those lets the work in hand finish, and the same once more ends at once. One at a time.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /// Whether it was asked to end.
  static bool asked();

 private:
  std::array<struct sigaction, kEndings.size()> before_ = {};
};

/// While it lives, those are passed over: for a rank that helps another one, which lets it go when it ends itself.
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
