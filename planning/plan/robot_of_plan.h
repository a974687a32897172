// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Sets the robot of a plan: name, hash, texts of its description and hulls of its meshes.
inline void SetRobot(const RobotModel& model, MotionPlan& plan) {
  plan.robot = model.name;
  plan.robot_hash = model.hash;
  plan.urdf_text = model.urdf_text;
  plan.yaml_text = model.yaml_text;
  plan.meshes = model.meshes;
}

}  // namespace gaitwright
