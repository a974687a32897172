// SPDX-License-Identifier: BSD-3-Clause
#include "cli/trials_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "workflows/study/trial.h"

namespace gaitwright::cli {

namespace {

/// What is drawn and has no effect: a figure in place of which a study has its own, and sensors that nobody reads.
std::optional<Failure> InVain(const Disturbances& disturbances, const PlayRequest& request,
                              const std::vector<std::string>& varied) {
  const auto failure = [](const std::string& message, const std::string& hint) {
    return Failure{FailureKind::kBadInput, "in_vain", "LoadDisturbances", message, {hint}};
  };
  if (const std::vector<std::string> twice = DrawnInPlaceOf(disturbances, varied); !twice.empty()) {
    return failure(fmt::format("the disturbances draw {}, which --over varies", QuotedList(twice)),
                   "leave one of them out");
  }
  const bool reads_state = request.sensing.state == StateSourceNames().front() &&
                           std::find(varied.begin(), varied.end(), "state") == varied.end();
  for (const Disturbance& figure : disturbances.figures) {
    if (!reads_state || !figure.key.starts_with("sensor")) continue;
    return failure(
        fmt::format("the disturbances draw '{}', and the controller has the true state: no sensor is read", figure.key),
        "--state estimated, or measured; or leave it out");
  }
  return std::nullopt;
}

}  // namespace

void DisturbanceArguments::AddTo(CLI::App& verb, const std::string& otherwise) {
  AddText(verb, "--disturbances", "FILE", file,
          "What is sampled, as YAML, see docs/trials.md; 'standard' for the standard set; default: " + otherwise + ".");
}

void DisturbanceArguments::AddPathTo(Paths& paths) const {
  if (!file.empty() && file != "standard") paths.read.push_back({"--disturbances", file});
}

Result<Disturbances> DisturbanceArguments::Load(const RobotModel& model, PlayRequest request,
                                                const std::vector<std::string>& varied) const {
  if (file.empty() || file == "standard") return StandardBesides(model, request, varied);
  Result<Disturbances> disturbances = LoadDisturbances(file, SensorFields(request));
  if (!disturbances) return disturbances;
  if (auto failure = InVain(*disturbances, request, varied)) return *failure;
  if (auto failure = WhyNotSampled(model, request, *disturbances)) return *failure;
  return disturbances;
}

}  // namespace gaitwright::cli
