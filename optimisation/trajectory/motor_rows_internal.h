// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/actuator.h"
#include "optimisation/trajectory/body_problem_internal.h"

namespace gaitwright {

/// Efforts of the motors of a robot as linear functions of what its bodies need, and of speeds and accelerations: with
/// the rotors' inertia and viscous friction. Dry friction is taken off the limit, in either direction.
///
/// All efforts and speeds are shares of what a motor may use.
class MotorRows {
 public:
  MotorRows(const RobotModel& model, const BodyLimitUse& use);

  /// A motor with a limit of its speed or a torque-speed curve:
  ///   effort * by_effort + speed / speed_scale within [-1, 1].
  struct Curve {
    int motor;
    double by_effort;    ///< of the share of effort that may be used; 0 for a limit of speed alone
    double speed_scale;  ///< [rad/s]
  };

  int count() const { return static_cast<int>(motors_.size()); }
  /// What a share of 1 is [N m], [N].
  double EffortOf(int motor) const { return scale_[static_cast<std::size_t>(motor)]; }
  const std::vector<Actuator>& motors() const { return motors_; }
  /// Motors whose effort is limited: their share is to be within [-1, 1].
  const std::vector<int>& limited() const { return limited_; }
  const std::vector<Curve>& curves() const { return curves_; }
  /// Whether dry friction alone takes most of the effort of an independent joint's own motor, as in grippers. Such a
  /// joint is to stand still; then its friction takes nothing of the effort.
  bool Sticks(int dof) const { return sticks_[static_cast<std::size_t>(dof)]; }

  /// Shares of efforts. @param torque  that the bodies take, by independent joint; v and a are those of the joints.
  void Efforts(const Eigen::Ref<const VectorX>& torque, const Eigen::Ref<const VectorX>& v,
               const Eigen::Ref<const VectorX>& a, Eigen::Ref<VectorX> shares) const;

  /// The largest shares so far, by motor: of efforts, and of limits of speed and torque-speed curves.
  struct Largest {
    VectorX effort, curve;
  };
  /// Raises the largest shares to those at a time. @param largest  at first without sizes.
  void Raise(const Eigen::Ref<const VectorX>& torque, const Eigen::Ref<const VectorX>& v,
             const Eigen::Ref<const VectorX>& a, Largest& largest) const;

  /// Rows by joint of some derivative of torques, to rows by motor of that of shares.
  void ToMotors(const Eigen::Ref<const MatrixX>& of_torque, Eigen::Ref<MatrixX> of_shares) const;
  /// Adds the direct effect of speeds and accelerations of joints (columns by joint) to the rows of shares.
  void AddLosses(Eigen::Ref<MatrixX> by_v, Eigen::Ref<MatrixX> by_a) const;

 private:
  std::vector<Actuator> motors_;
  std::vector<double> scale_;    // by motor: effort that may be used
  std::vector<double> damping_;  // by joint
  std::vector<double> rotor_;    // by motor, along its own speed
  std::vector<bool> sticks_;     // by joint
  std::vector<int> limited_;
  std::vector<Curve> curves_;
};

}  // namespace gaitwright
