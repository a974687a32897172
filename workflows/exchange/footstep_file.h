// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/base/result.h"
#include "planning/footsteps/plan_footsteps.h"
#include "workflows/exchange/import_motion.h"

namespace gaitwright {

/// Reads footsteps from YAML, see docs/import.md: `footsteps`, each with foot, x_m, y_m, yaw_rad, an optional z_m to
/// check, and lift_off_s with touch_down_s, or swing_s and pause_s; initial positions of the feet in `start`, default
/// the standing posture; initial_stand_s and final_stand_s. Times are rounded to `grid_s`. Failure kBadInput
/// `footsteps`, which names the line, for: a foot that the robot does not have, a foot that lifts off before it has
/// stood for two steps of the grid, a foothold without ground or more than 1 cm from it, more than 10000 steps, and a
/// step later than kLongestMotion.
Result<FootstepSkeleton> ReadFootsteps(const RobotModel& model, const Terrain& terrain, const std::string& text,
                                       const std::string& source, double grid_s);

/// Reads footsteps and plans the motion over them with the pipeline; returns the failure, if any.
std::optional<Failure> PlanFootstepFile(const RobotModel& model, const Terrain& terrain, const std::string& text,
                                        const ImportRequest& request, ImportedMotion& imported);

}  // namespace gaitwright
