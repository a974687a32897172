// SPDX-License-Identifier: BSD-3-Clause
#include "cli/trials_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "workflows/study/trial.h"

namespace gaitwright::cli {

namespace {

/// A figure that acts through the one of an option alone, as the direction of a slope does through the slope.
struct ActsThrough {
  const char *key, *through;
  double set;  ///< what the option of the latter is set to
};

/// A figure that is drawn where the one through which it acts is zero throughout.
std::optional<ActsThrough> WithoutEffect(const Disturbances& disturbances, const PlayRequest& request,
                                         const std::vector<std::string>& varied) {
  const WorldOptions& world = request.play.world;
  const auto drawn = [&](const std::string& key) -> const Distribution* {
    for (const Disturbance& figure : disturbances.figures) {
      if (figure.key == key) return &figure.distribution;
    }
    return nullptr;
  };
  for (const ActsThrough& figure :
       {ActsThrough{"ground_slope_direction_deg", "ground_slope_deg", world.ground_slope_deg},
        {"bump_wavelength_m", "ground_bumps_m", world.ground_bumps_m},
        {"bump_seed", "ground_bumps_m", world.ground_bumps_m}}) {
    const Distribution* through = drawn(figure.through);
    const bool acts = (through != nullptr && (through->lowest != 0.0 || through->highest != 0.0)) ||
                      figure.set != 0.0 ||
                      std::find(varied.begin(), varied.end(), std::string("play.") + figure.through) != varied.end();
    if (drawn(figure.key) != nullptr && !acts) return figure;
  }
  return std::nullopt;
}

/// What is drawn and has no effect: a figure in place of which a study has its own, one whose own ground is not there,
/// and sensors that nobody reads.
std::optional<Failure> InVain(const Disturbances& disturbances, const PlayRequest& request,
                              const std::vector<std::string>& varied) {
  const auto failure = [](const std::string& message, const std::string& hint) {
    return Failure{FailureKind::kBadInput, "in_vain", "LoadDisturbances", message, {hint}};
  };
  if (const std::vector<std::string> twice = DrawnInPlaceOf(disturbances, varied); !twice.empty()) {
    return failure(fmt::format("the disturbances draw {}, which --over varies", QuotedList(twice)),
                   "leave one of them out");
  }
  if (const std::optional<ActsThrough> idle = WithoutEffect(disturbances, request, varied)) {
    return failure(
        fmt::format("the disturbances draw '{}', which has no effect without '{}'", idle->key, idle->through),
        fmt::format("draw '{}' too, or leave '{}' out", idle->through, idle->key));
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
