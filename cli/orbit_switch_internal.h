// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/program.h"
#include "workflows/study/measure_orbit_internal.h"
#include "workflows/walk/walk_report.h"

namespace gaitwright::cli {

/// The switch --orbit of `walk` and `play`, which measures the orbit stability of the steady gait.
struct OrbitSwitch {
  bool asked = false;

  void AddTo(Verb verb);

  /// Nothing if it was not asked for. @return a failure as MeasureOrbit.
  Result<std::optional<OrbitStability>> Measure(const RobotModel& model, const MotionPlan& plan,
                                                const PlayRequest& request) const;
};

/// Adds the report's part.
void AddOrbitTo(Judged& judged, const std::optional<OrbitStability>& orbit);
/// Adds the key `orbit` to the JSON.
void AddOrbitTo(std::vector<std::pair<std::string, std::string>>& json, const std::optional<OrbitStability>& orbit);
/// Prints the verdict for a person.
void PrintOrbit(const std::optional<OrbitStability>& orbit, const Common& common);

}  // namespace gaitwright::cli
