// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Extent of a walk, as far as given.
struct WalkExtent {
  std::optional<double> distance_m;
  std::optional<double> duration_s;
  std::optional<PlanarPose> goal;  ///< goal of the base, in its start frame
  std::optional<int> steps;
  std::optional<double> step_length_m;  ///< with `steps`
};

/// Puts the extent into a command that already has its speeds. The default is 1 m, or a quarter turn if only a yaw rate
/// is given; steps without a length or a speed use the robot's default speed.
/// @throws InvalidArgument if the extent is given twice, for a distance of 0, and for a step length without steps or
/// together with a speed. @param before  prefix of names in messages, such as "--" for flags.
void SetExtent(const RobotModel& model, const WalkExtent& extent, WalkCommand& command, const std::string& before = "");

}  // namespace gaitwright
