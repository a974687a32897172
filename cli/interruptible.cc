// SPDX-License-Identifier: BSD-3-Clause
#include "cli/interruptible.h"

namespace gaitwright::cli {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

}  // namespace

Interruptible::Interruptible() {
  struct sigaction action = {};
  action.sa_handler = [](int) { g_interrupted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  ::sigaction(SIGINT, &action, &before_int_);
  ::sigaction(SIGTERM, &action, &before_term_);
}

Interruptible::~Interruptible() {
  ::sigaction(SIGINT, &before_int_, nullptr);
  ::sigaction(SIGTERM, &before_term_, nullptr);
}

bool Interruptible::asked() { return g_interrupted != 0; }

}  // namespace gaitwright::cli
