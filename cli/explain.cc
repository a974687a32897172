// SPDX-License-Identifier: BSD-3-Clause
#include "cli/explain.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

namespace gaitwright::cli {

void Explain::AddTo(Verb verb) {
  verb.AddSwitch(
      "--explain", asked,
      "Print each plan that the search tried, with its speed, its cycle time and the reason for its refusal.");
}

std::string Explain::Json() const {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const TriedPlan& tried : trace) {
    nlohmann::ordered_json refused = nullptr;
    if (tried.refused) refused = FailureCodeName(*tried.refused);
    list.push_back({{"extent", EffortName(tried.effort)},
                    {"pace", tried.pace},
                    {"value", tried.pace_value},
                    {"unit", tried.unit},
                    {"cycle_s", tried.cycle_s},
                    {"refused", refused},
                    {"free_footholds", tried.free_footholds},
                    {"whole_body", tried.whole_body},
                    {"heel_off_rad", tried.heel_off_rad}});
  }
  return list.dump();
}

void Explain::Print(const Common& common) const {
  if (asked && !common.json && !common.quiet) fmt::print("{}", TraceText(trace));
}

void Explain::PrintRefused() const {
  if (asked) fmt::print(stderr, "{}", TraceText(trace));
}

}  // namespace gaitwright::cli
