// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/search_trace.h"

#include <fmt/format.h>

namespace gaitwright {

const char* EffortName(Effort effort) {
  switch (effort) {
    case Effort::kStartLook:
      return "start-look";
    case Effort::kFirstLook:
      return "first-look";
    case Effort::kStart:
      return "start";
    case Effort::kWhole:
      return "whole";
  }
  return "";
}

std::string TraceText(const SearchTrace& trace) {
  std::string text = fmt::format("tried {} plan{}:\n", trace.size(), trace.size() == 1 ? "" : "s");
  for (const TriedPlan& tried : trace) {
    text += fmt::format("  {:<10}  {} {:.4g} {}, cycle {:.3f} s{}{}{}: {}\n", EffortName(tried.effort), tried.pace,
                        tried.pace_value, tried.unit, tried.cycle_s, tried.free_footholds ? ", free footholds" : "",
                        tried.whole_body ? ", whole body" : "",
                        tried.heel_off_rad > 0.0 ? fmt::format(", heel-off {:.2f} rad", tried.heel_off_rad) : "",
                        tried.refused ? FailureCodeName(*tried.refused) : "sound");
  }
  return text;
}

}  // namespace gaitwright
