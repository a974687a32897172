// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Motor torque of an independent coordinate that is lost in the joint:
///   tau_lost = rotor_inertia * a + damping * v + friction * sign(v).
/// Units are those of a revolute joint; for a prismatic joint kg, N s/m and N.
struct JointLosses {
  double rotor_inertia = 0.0;  ///< of rotor and gear, as felt at the joint [kg m^2]
  double damping = 0.0;        ///< [N m s/rad]
  double friction = 0.0;       ///< dry [N m]

  bool none() const { return rotor_inertia <= 0.0 && damping <= 0.0 && friction <= 0.0; }
};

/// The losses that robot.yaml and URDF tell of coordinate `dof`. Damping and friction are those of all joints that it
/// moves: sums of multiplier^2 * damping and of |multiplier| * friction.
/// Rotors of a transmission are not in it: they couple its joints (Transmission::RotorInertia).
JointLosses LossesOf(const RobotModel& model, int dof);

/// The robot as it would be if its joints took nothing for themselves: no damping, friction or rotor inertia.
RobotModel WithoutLosses(const RobotModel& model);

/// Adds the rotors' inertia to a mass matrix M(q), size nv x nv: to its diagonal, and beside it where motors of a
/// transmission drive several joints.
void AddRotorInertia(const RobotModel& model, MatrixX& M);

/// Inertia of rotors and gears as felt at coordinate `dof` while all others are still: the diagonal of AddRotorInertia.
double RotorInertiaAt(const RobotModel& model, int dof);

}  // namespace gaitwright
