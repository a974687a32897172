// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace gaitwright::cli {

/// Exit status of a run that a signal ended: 128 and the signal's number, as shells have it.
inline constexpr int kInterrupted = 128 + SIGINT;

/// While it lives, the first Ctrl-C (or a request to end) lets the work in hand finish, and a second one ends at once.
/// One at a time.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /// Whether it was asked to end.
  static bool asked();

 private:
  struct sigaction before_int_ = {}, before_term_ = {};
};

}  // namespace gaitwright::cli
