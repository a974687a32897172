// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Whether a leg has a sole but no ankle roll joint (FootType::kLine).
bool HasTiltingSole(const RobotModel& model);

/// Reason why soles of legs without an ankle roll joint (FootType::kLine) make a plan infeasible, or nothing. Such a
/// sole tilts about its middle as the body sways, and its edge enters the ground. Failure kInfeasible `tipped_sole`
/// names the foot, the time, the depth of the edge and the tilt; up to 0.1 mm is ignored.
std::optional<Failure> TippedSole(const RobotModel& model, const Terrain& terrain, const WholeBodyTrajectory& motion);

}  // namespace gaitwright
