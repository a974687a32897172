// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cli/program.h"
#include "optimisation/search/search_trace.h"

namespace gaitwright::cli {

/// The flag `--explain` of verbs that plan a walk: prints which plans the search tried and why each was refused.
struct Explain {
  bool asked = false;
  SearchTrace trace;

  void AddTo(Verb verb);
  SearchTrace* target() { return asked ? &trace : nullptr; }
  /// JSON text: [{"extent", "pace", "value", "unit", "cycle_s", "refused"}]
  std::string Json() const;
  /// Prints it as text. Prints nothing without --explain, with --json and with --quiet.
  void Print(const Common& common) const;
  /// Prints it on standard error, after a refusal.
  void PrintRefused() const;
};

}  // namespace gaitwright::cli
