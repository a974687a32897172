// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Assumed limits of an unknown motor [N m, rad/s; for a prismatic joint N, m/s].
struct MotorBounds {
  double effort, speed;
};

/// Bounds of a dof from the robot's mass m and leg length l: for a revolute joint 2 m g l and 20 sqrt(g / l), for a
/// prismatic joint 10 m g and 10 sqrt(g l); infinite for a model without legs. Robots with known motors have up to
/// 0.8 m g l (Mini Cheetah) and 12 sqrt(g / l) (Laikago). Plans are not limited by these bounds. They bound the torque
/// of a falling robot, so that it is not thrown upward.
MotorBounds BoundsOfUnknownMotor(const RobotModel& model, int dof);

}  // namespace gaitwright
