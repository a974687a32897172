// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How far a walk is to go, as far as somebody said it.
struct WalkExtent {
  std::optional<double> distance_m;
  std::optional<double> duration_s;
  std::optional<PlanarPose> goal;  ///< of the base, in its start frame
  std::optional<int> steps;
  std::optional<double> step_length_m;  ///< with `steps`
};

/// Puts it into a command, whose speeds are there already. What nobody said is 1 m, or where only a yaw rate is given a
/// quarter turn; steps without a length or a speed go at the robot's own speed.
/// @throws InvalidArgument where it is said twice, for a distance of 0, and for a step's length without steps or beside
/// a speed. @param before  what stands before names in its message, as "--" before flags.
void SetExtent(const RobotModel& model, const WalkExtent& extent, WalkCommand& command, const std::string& before = "");

}  // namespace gaitwright
