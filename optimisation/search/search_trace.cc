// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/search_trace.h"

#include <fmt/format.h>

namespace gaitwright {

const char* ExtentName(TriedPlan::Extent extent) {
  switch (extent) {
    case TriedPlan::Extent::kFirstLook:
      return "first-look";
    case TriedPlan::Extent::kStart:
      return "start";
    case TriedPlan::Extent::kWhole:
      return "whole";
  }
  return "";
}

std::string TraceText(const SearchTrace& trace) {
  std::string text = fmt::format("tried {} plan{}:\n", trace.size(), trace.size() == 1 ? "" : "s");
  for (const TriedPlan& tried : trace) {
    text += fmt::format("  {:<10}  {} {:.4g} {}, cycle {:.3f} s: {}\n", ExtentName(tried.extent), tried.pace,
                        tried.pace_value, tried.unit, tried.cycle_s,
                        tried.refused ? FailureCodeName(*tried.refused) : "sound");
  }
  return text;
}

}  // namespace gaitwright
