// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "cli/orbit_switch_internal.h"
#include "playback/report/orbit_part_internal.h"

namespace gaitwright::cli {

void OrbitSwitch::AddTo(Verb verb) {
  verb.SetGroup("Stability of the gait");
  verb.AddSwitch("--orbit", asked,
                 "Also play 24 times with small pushes, and report the Floquet multipliers of the steady gait.");
}

Result<std::optional<OrbitStability>> OrbitSwitch::Measure(const RobotModel& model, const MotionPlan& plan,
                                                           const PlayRequest& request) const {
  if (!asked) return std::optional<OrbitStability>();
  Result<OrbitStability> measured = MeasureOrbit(model, plan, request, {.threads = 0});
  if (!measured) return measured.failure();
  return std::optional(std::move(*measured));
}

void AddOrbitTo(Judged& judged, const std::optional<OrbitStability>& orbit) {
  if (orbit) judged.orbit_part = OrbitPart(*orbit);
}

void AddOrbitTo(std::vector<std::pair<std::string, std::string>>& json, const std::optional<OrbitStability>& orbit) {
  if (orbit) json.emplace_back("orbit", OrbitJson(*orbit));
}

void PrintOrbit(const std::optional<OrbitStability>& orbit, const Common& common) {
  if (orbit && !common.json && !common.quiet) fmt::print("orbit: {}\n", OrbitText(*orbit));
}

}  // namespace gaitwright::cli
