// SPDX-License-Identifier: BSD-3-Clause
#include "cli/interruptible.h"

namespace gaitwright::cli {
namespace {

using EndingActions = std::array<struct sigaction, kEndings.size()>;

volatile std::sig_atomic_t g_interrupted = 0;

/// @return the actions that were set before.
EndingActions HandleEndings(const struct sigaction& action) {
  EndingActions before = {};
  for (std::size_t i = 0; i < kEndings.size(); ++i) ::sigaction(kEndings[i], &action, &before[i]);
  return before;
}

void RestoreEndings(const EndingActions& before) {
  for (std::size_t i = 0; i < kEndings.size(); ++i) ::sigaction(kEndings[i], &before[i], nullptr);
}

}  // namespace

Interruptible::Interruptible() {
  struct sigaction action = {};
  action.sa_handler = [](int) { g_interrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  before_ = HandleEndings(action);
}

Interruptible::~Interruptible() { RestoreEndings(before_); }

bool Interruptible::asked() { return g_interrupted != 0; }

Undisturbed::Undisturbed() {
  struct sigaction action = {};
  action.sa_handler = SIG_IGN;
  before_ = HandleEndings(action);
}

Undisturbed::~Undisturbed() { RestoreEndings(before_); }

}  // namespace gaitwright::cli
