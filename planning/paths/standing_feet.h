// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Contact frames of the standing posture on the ground, by foot, with the base's origin above the world's origin:
/// X_BF.
std::vector<Pose> StandingFeet(const RobotModel& model);

/// A pose given relative to the base, as a pose in W for a base at a planar pose.
Pose Carried(const PlanarPose& base, const Pose& X_BF);

}  // namespace gaitwright
