// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/walk_extent.h"

#include <fmt/format.h>

#include "kinematics/base/result.h"

namespace gaitwright {

void SetExtent(const RobotModel& model, const WalkExtent& extent, WalkCommand& command, const std::string& before) {
  const int said = static_cast<int>(extent.distance_m.has_value()) + static_cast<int>(extent.duration_s.has_value()) +
                   static_cast<int>(extent.goal.has_value()) + static_cast<int>(extent.steps.has_value());
  if (said > 1) {
    throw InvalidArgument(fmt::format(
        "{0}distance, {0}duration, {0}goal and {0}steps each set the distance; give only one of them", before));
  }
  if (extent.distance_m == 0.0) throw InvalidArgument(fmt::format("{}distance is 0; it must be more than 0", before));
  if (extent.step_length_m && (!extent.steps || command.speed_m_s != 0.0))
    throw InvalidArgument("the step length is for use with steps, instead of a speed");
  const bool walks = command.speed_m_s != 0.0 || command.lateral_speed_m_s != 0.0;
  const bool turns_only = command.yaw_rate_rad_s != 0.0 && !walks;
  command.distance_m = extent.distance_m.value_or(turns_only ? 0.0 : 1.0);
  if (extent.duration_s) {
    command.extent = WalkCommand::Extent::kDuration;
    command.duration_s = *extent.duration_s;
  }
  if (extent.goal) {
    command.extent = WalkCommand::Extent::kGoal;
    command.goal_x_m = extent.goal->x_m;
    command.goal_y_m = extent.goal->y_m;
    command.goal_yaw_rad = extent.goal->yaw_rad;
  }
  if (extent.steps) {
    command.extent = WalkCommand::Extent::kSteps;
    command.steps = *extent.steps;
    command.step_length_m = extent.step_length_m.value_or(0.0);
    if (!extent.step_length_m && !walks && !turns_only) command.speed_m_s = model.nominal_speed_m_s;
  }
}

}  // namespace gaitwright
