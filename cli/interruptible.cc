// SPDX-License-Identifier: BSD-3-Clause
#include "cli/interruptible.h"

namespace gaitwright::cli {
namespace {

using Actions = std::array<struct sigaction, kEndings.size()>;

volatile std::sig_atomic_t g_interrupted = 0;

/// @return what was done until now.
Actions Handle(const struct sigaction& action) {
  Actions before = {};
  for (std::size_t i = 0; i < kEndings.size(); ++i) ::sigaction(kEndings[i], &action, &before[i]);
  return before;
}

void Restore(const Actions& before) {
  for (std::size_t i = 0; i < kEndings.size(); ++i) ::sigaction(kEndings[i], &before[i], nullptr);
}

}  // namespace

Interruptible::Interruptible() {
  struct sigaction action = {};
  action.sa_handler = [](int) { g_interrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  before_ = Handle(action);
}

Interruptible::~Interruptible() { Restore(before_); }

bool Interruptible::asked() { return g_interrupted != 0; }

Undisturbed::Undisturbed() {
  struct sigaction action = {};
  action.sa_handler = SIG_IGN;
  before_ = Handle(action);
}

Undisturbed::~Undisturbed() { Restore(before_); }

}  // namespace gaitwright::cli
