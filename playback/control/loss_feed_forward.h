// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/joint_losses.h"
#include "playback/control/gains.h"

namespace gaitwright {

/// Motor torque for joint losses, in addition to a plan's torques, which cover rigid bodies only:  tau += share (J a +
/// d v + f tanh(v / v_s)), with J the rotor's inertia (of a transmission R^T J R), d the damping and f the dry friction
/// of robot.yaml or URDF, v and a of the plan, and v_s `friction_speed_rad_s` (times the leg length for a prismatic
/// joint). The tanh keeps the changing sign of a tiny velocity from shaking a joint at rest. Without known losses it
/// adds no torque and takes no time.
class LossFeedForward {
 public:
  /// @throws InvalidArgument for an option out of its range.
  LossFeedForward(const RobotModel& model, const GainOptions& options);

  /// Adds the rotors' part for planned accelerations, size n [rad/s^2].
  void AddInertia(const Eigen::Ref<const VectorX>& a, VectorX& tau) const;
  /// Adds the part of damping and dry friction for planned rates, size n [rad/s].
  void AddDrag(const VectorX& v, VectorX& tau) const;

 private:
  struct Loss {
    int dof;
    JointLosses losses;     ///< times the share
    double friction_speed;  ///< [rad/s] or [m/s]
  };
  /// Rotors of the motors of a transmission: their inertia R^T J R at its joints, times the share.
  struct SharedRotors {
    std::vector<int> dofs;
    MatrixX inertia;
  };
  std::vector<Loss> losses_;  ///< of the joints with losses
  std::vector<SharedRotors> shared_;
};

}  // namespace gaitwright
