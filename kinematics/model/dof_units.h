// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Whether an independent joint is prismatic.
inline bool Slides(const RobotModel& model, int dof) {
  const int joint = model.dof_joint[static_cast<std::size_t>(dof)];
  return model.joints[static_cast<std::size_t>(joint)].type == JointType::kPrismatic;
}

/// Units of an independent joint's position, speed and effort, for messages.
inline const char* PositionUnit(const RobotModel& model, int dof) { return Slides(model, dof) ? "m" : "rad"; }
inline const char* SpeedUnit(const RobotModel& model, int dof) { return Slides(model, dof) ? "m/s" : "rad/s"; }
inline const char* EffortUnit(const RobotModel& model, int dof) { return Slides(model, dof) ? "N" : "N m"; }

}  // namespace gaitwright
