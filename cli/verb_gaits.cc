// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "cli/program.h"
#include "planning/gait/find_gait.h"

namespace gaitwright::cli {
namespace {

struct GaitsSettings {
  Common common;
  std::string file;
};

/// "0.00 0.50": when each foot touches down, as shares of the cycle.
std::string PhasesText(const std::vector<double>& phases) {
  std::string text;
  for (const double phase : phases) text += fmt::format("{}{:.2f}", text.empty() ? "" : " ", phase);
  return text;
}

int RunGaits(const GaitsSettings& a) {
  const Result<std::vector<GaitEntry>> gaits = a.file.empty() ? BuiltInGaits() : LoadGaits(a.file);
  if (!gaits) return Report(gaits.failure(), a.common);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  if (!a.common.json && !a.common.quiet) {
    fmt::print(
        "duty: share of the cycle during which a foot is on the ground; phases: when each foot touches down\n\n");
    fmt::print("{:<11} {:>4}  {:>4}  {:<31}  description\n", "gait", "feet", "duty", "phases");
  }
  for (const GaitEntry& entry : *gaits) {
    Gait gait = entry.gait;
    list.push_back(
        {{"name", gait.name},
         {"feet", gait.num_feet()},
         {"description", gait.description},
         {"cycle_s", gait.cycle_s > 0.0 ? nlohmann::ordered_json(gait.cycle_s) : nullptr},
         {"cycle_per_leg_time", entry.cycle_per_leg_time},
         {"stride_per_leg", entry.stride_per_leg > 0.0 ? nlohmann::ordered_json(entry.stride_per_leg) : nullptr},
         {"pitch_turns", gait.pitch_turns},
         {"roll_turns", gait.roll_turns},
         {"travel_per_leg", entry.travel_per_leg ? nlohmann::ordered_json(*entry.travel_per_leg) : nullptr},
         {"phase", gait.phase},
         {"duty_factor", gait.duty_factor},
         {"flight", HasFlight(gait)}});
    if (a.common.json) continue;
    if (a.common.quiet) {
      fmt::print("{}\n", gait.name);
      continue;
    }
    fmt::print("{:<11} {:>4}  {:>4.2f}  {:<31}  {}\n", gait.name, gait.num_feet(), gait.duty_factor.front(),
               PhasesText(gait.phase), gait.description);
  }
  if (a.common.json) PrintJson(nlohmann::ordered_json{{"gaits", list}});
  return kPass;
}

}  // namespace

void AddGaits(Verb program, int& status) {
  auto a = std::make_shared<GaitsSettings>();
  const Verb verb = program.AddVerb("gaits", "List the built-in gaits, or the gaits of a file");
  AddText(verb, "FILE", "", a->file, "A YAML file of gaits; default: the built-in gaits.");
  AddCommon(verb, a->common, {"gaits", "gaits --json"});
  SetWork(verb, a->common, status, [a] { return RunGaits(*a); });
}

}  // namespace gaitwright::cli
