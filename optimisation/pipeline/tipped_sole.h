// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Why the soles of legs that cannot roll them (FootType::kLine) forbid a plan, or nothing. Such a sole tips about its
/// middle as the body sways, and its edge goes into the ground. Failure kInfeasible `tipped_sole` names the foot, the
/// time, how deep its edge would be and by how much it tips; up to 0.1 mm is passed over.
std::optional<Failure> TippedSole(const RobotModel& model, const Terrain& terrain, const WholeBodyTrajectory& motion);

}  // namespace gaitwright
