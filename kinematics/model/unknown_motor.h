// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The most that is taken of a motor of which nothing is said [N m, rad/s; of a joint that slides N, m/s].
struct MotorBounds {
  double effort, speed;
};

/// Bounds of a dof by the robot's mass m and leg length l: of a joint that turns 2 m g l and 20 sqrt(g / l), of one
/// that slides 10 m g and 10 sqrt(g l); infinite for a model without legs. Robots whose motors are known have up to 0.8
/// m g l (Mini Cheetah) and 12 sqrt(g / l) (Laikago). They limit no plan; they keep a robot that falls a machine,
/// whatever it is commanded to do.
MotorBounds BoundsOfUnknownMotor(const RobotModel& model, int dof);

}  // namespace gaitwright
