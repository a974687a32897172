// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/actuator.h"

namespace gaitwright {

/// Motor torque for a motion: the torque on the bodies plus the losses of joint and rotor. Let d and c be the damping
/// and the dry friction of the joints that a coordinate moves (a joint that mimics with ratio r adds d r^2 and c |r|),
/// and I the rotor's inertia reflected to the joint. The motor of one joint then gives
///   tau_motor = tau + d v + c clamp(v / 0.01, -1, 1) + I a.
/// A motor of a transmission gives its part of these torques at all joints that it drives, and J (R a) for its own
/// rotor J. Friction grows linearly up to a speed of 0.01 rad/s (m/s), because friction of a joint at rest can act in
/// either direction. All three are zero if unknown.
class MotorEffort {
 public:
  explicit MotorEffort(const RobotModel& model);

  const std::vector<Actuator>& motors() const { return motors_; }

  /// @param motor      index into motors().
  /// @param tau, v, a  torques on the bodies, speeds and accelerations of all coordinates [N m, rad/s, rad/s^2].
  double Of(int motor, const Eigen::Ref<const VectorX>& tau, const Eigen::Ref<const VectorX>& v,
            const Eigen::Ref<const VectorX>& a) const;

 private:
  double AtJoint(int dof, double tau, double v, double a) const;

  struct Own {
    double damping = 0.0, friction = 0.0, inertia = 0.0;
  };
  std::vector<Own> own_;  // by dof
  std::vector<Actuator> motors_;
};

}  // namespace gaitwright
