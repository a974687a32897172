// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/stability/polygon.h"

namespace gaitwright {

/// The load on one foot of a standing robot.
struct FootLoad {
  Vector3 p_WC;           ///< centre of mass of the robot [m]
  double normal_n = 0.0;  ///< force on the foot [N]
};

/// The part of one foot's support in which its ankle can hold the robot alone.
///
/// The contact force is f = N z + N (C - Z)_xy / h, through the ZMP Z and the centre of mass C. A revolute joint with
/// unit axis a through P, at a height z below h / 2, needs  tau = -((Z + (C - Z) z / h - P) x N z) . a, which is linear
/// in Z. So each joint limits the support to a strip where |tau| <= use * limit. Joints at a larger height are left
/// out, because the ZMP hardly changes their torque. For a transmission, each motor limits the support to the strip
/// where its torque, a sum over its joints, is within its limit.
///
/// @param support   convex polygon of the ground in plan view, at the height of the foot's contact frame; W [m].
/// @param load      centre of mass C and force N.
/// @param use       share of the motors' effort limits, > 0.
/// @return the part of `support`; `support` itself if it has no area. A joint that would exclude the whole support is
/// skipped. Needs ForwardKinematics on the scratch.
Polygon HoldableSupport(const RobotModel& model, const DynamicsScratch& scratch, int foot, const Polygon& support,
                        const FootLoad& load, double use);

}  // namespace gaitwright
