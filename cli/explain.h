// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cli/program.h"
#include "optimisation/search/search_trace.h"

namespace gaitwright::cli {

/// `--explain` of the verbs that plan a walk: which plans the search tried, and why each was refused.
struct Explain {
  bool asked = false;
  SearchTrace trace;

  void AddTo(Verb verb);
  SearchTrace* target() { return asked ? &trace : nullptr; }
  /// JSON text: [{"extent", "pace", "value", "unit", "cycle_s", "refused"}]
  std::string Json() const;
  /// Prints it as text, unless it was not asked for or a JSON object or a verdict alone is printed.
  void Print(const Common& common) const;
  /// Prints it to standard error, as a refusal.
  void PrintRefused() const;
};

}  // namespace gaitwright::cli
