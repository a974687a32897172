// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// What a motor has to give for a motion: the torque that the bodies take, and what its joint and its rotor take
/// themselves,
///   tau_motor = tau + d v + c clamp(v / 0.01, -1, 1) + I a,
/// with damping d and dry friction c of the joints that it moves (a joint that mimics by its ratio: d r^2, c |r|) and
/// the rotor's inertia I as felt at the joint. Friction comes on evenly up to a speed of 0.01 rad/s (m/s), since a
/// joint at rest may lean on it either way. All three are zero where nothing is known of them.
class MotorEffort {
 public:
  explicit MotorEffort(const RobotModel& model);

  /// @param tau, v, a  torque that the bodies take, speed and acceleration of the coordinate [N m, rad/s, rad/s^2].
  double Of(int dof, double tau, double v, double a) const;

 private:
  struct Own {
    double damping = 0.0, friction = 0.0, inertia = 0.0;
  };
  std::vector<Own> own_;  // by dof
};

}  // namespace gaitwright
