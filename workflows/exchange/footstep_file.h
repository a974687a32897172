// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/base/result.h"
#include "planning/footsteps/plan_footsteps.h"
#include "workflows/exchange/import_motion.h"

namespace gaitwright {

/// Footsteps as a YAML has them, see docs/import.md: `footsteps`, each with foot, x_m, y_m, yaw_rad, z_m where it is
/// to be checked, and lift_off_s with touch_down_s, or swing_s and pause_s; where the feet stand at first in `start`,
/// or else as in the standing posture; initial_stand_s and final_stand_s. Times are rounded to `grid_s`. Failure
/// kBadInput `footsteps` naming the line: a foot that the robot does not have, a foot that lifts before it has stood
/// for two steps of the grid, one that is put where there is no ground, or farther than 1 cm from it, more than 10000
/// steps, and one that leads beyond kLongestMotion.
Result<FootstepSkeleton> ReadFootsteps(const RobotModel& model, const Terrain& terrain, const std::string& text,
                                       const std::string& source, double grid_s);

/// Reads footsteps and plans the motion over them by the pipeline; why there is none, if so.
std::optional<Failure> PlanFootstepFile(const RobotModel& model, const Terrain& terrain, const std::string& text,
                                        const ImportRequest& request, ImportedMotion& imported);

}  // namespace gaitwright
