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
  double friction = 0.0;       ///< dry friction [N m]

  bool none() const { return rotor_inertia <= 0.0 && damping <= 0.0 && friction <= 0.0; }
};

/// The losses of coordinate `dof` from robot.yaml and URDF. Damping and friction are sums over all joints that the
/// coordinate moves: of multiplier^2 * damping and of |multiplier| * friction. Rotors of a transmission are not
/// included, because they couple its joints (Transmission::RotorInertia).
JointLosses LossesOf(const RobotModel& model, int dof);

/// The robot without joint losses: no damping, friction or rotor inertia.
RobotModel WithoutLosses(const RobotModel& model);

/// Adds the rotor inertias to a mass matrix M(q), size nv x nv. Motors of a transmission, which drive several joints,
/// also change elements off the diagonal.
void AddRotorInertia(const RobotModel& model, MatrixX& M);

/// Inertia of rotors and gears reflected to coordinate `dof`, with all other coordinates at rest: the diagonal of
/// AddRotorInertia.
double RotorInertiaAt(const RobotModel& model, int dof);

}  // namespace gaitwright
