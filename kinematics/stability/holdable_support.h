// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/stability/polygon.h"

namespace gaitwright {

/// The force that a robot standing on one foot puts on it.
struct FootLoad {
  Vector3 p_WC;           ///< centre of mass of the robot [m]
  double normal_n = 0.0;  ///< force on the foot [N]
};

/// The part of one foot's support in which its ankle can hold the robot alone.
///
/// With the contact force f = N z + N (C - Z)_xy / h through the ZMP Z and the centre of mass C, a revolute joint with
/// unit axis a through P, at height z below h / 2, takes  tau = -((Z + (C - Z) z / h - P) x N z) . a, linear in Z; each
/// joint leaves the strip where |tau| <= use * limit. Joints higher up hardly feel where the ZMP is, and are left out.
/// Of a transmission each motor leaves the strip where its own torque, a sum of those of its joints, is in its limit.
///
/// @param support   convex, in plan view, of the ground at the height of the foot's contact frame; W [m].
/// @param load      centre of mass C and force N.
/// @param use       share of the motors' effort limits, > 0.
/// @return the part of `support`; `support` itself when it has no area. A joint that would leave nothing is passed
/// over.
/// Needs ForwardKinematics on the scratch.
Polygon HoldableSupport(const RobotModel& model, const DynamicsScratch& scratch, int foot, const Polygon& support,
                        const FootLoad& load, double use);

}  // namespace gaitwright
