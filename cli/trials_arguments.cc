// SPDX-License-Identifier: BSD-3-Clause
#include "cli/trials_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "workflows/study/trial.h"
#include "workflows/walk/idle_options.h"

namespace gaitwright::cli {

namespace {

/// Key of the option that decides whether a disturbance has an effect. The sensors in a file have an effect if any of
/// them is read.
std::string ActsAs(const Disturbance& figure) {
  return figure.key.starts_with("sensor") ? "sensors." : "play." + figure.key;
}

/// Failure if a sampled disturbance has no effect: a study varies the same value, its ground does not exist, or it
/// disturbs sensors that nothing reads.
std::optional<Failure> InVain(const Disturbances& disturbances, const PlayRequest& request,
                              const std::vector<std::string>& varied) {
  const auto failure = [](const std::string& message, const std::string& hint) {
    return Failure{FailureKind::kBadInput, FailureCode::kInVain, "LoadDisturbances", message, {hint}};
  };
  if (const std::vector<std::string> twice = DrawnInPlaceOf(disturbances, varied); !twice.empty()) {
    return failure(fmt::format("the disturbances sample {}, which --over varies", QuotedList(twice)),
                   "leave one of them out");
  }
  std::vector<std::string> open = DrawnOptions(disturbances);
  open.insert(open.end(), varied.begin(), varied.end());
  for (const Disturbance& figure : disturbances.figures) {
    if (const std::optional<IdleOption> idle = FirstIdle(request, {ActsAs(figure)}, open)) {
      return failure(fmt::format("the disturbances sample '{}', which has no effect {}", figure.key, idle->why),
                     idle->hint);
    }
  }
  return std::nullopt;
}

}  // namespace

void DisturbanceArguments::AddTo(Verb verb, const std::string& otherwise) {
  AddText(verb, "--disturbances", "FILE", file,
          "Disturbances to sample, as a YAML file (see docs/trials.md) or 'standard' for the standard set; default: " +
              otherwise + ".");
}

void DisturbanceArguments::AddPathTo(Paths& paths) const {
  if (!file.empty() && file != "standard") paths.Read("--disturbances", file);
}

Result<Disturbances> DisturbanceArguments::Load(const RobotModel& model, PlayRequest request,
                                                const std::vector<std::string>& varied) const {
  if (file.empty() || file == "standard") return StandardBesides(model, request, varied);
  Result<Disturbances> disturbances = LoadDisturbances(file, SensorFields(request));
  if (!disturbances) return disturbances;
  if (auto failure = InVain(*disturbances, request, varied)) return *failure;
  if (auto failure = ReasonNotSampled(model, request, *disturbances)) return *failure;
  return disturbances;
}

}  // namespace gaitwright::cli
