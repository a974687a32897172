// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>

#include <vector>

#include "playback/bullet/robot_body_internal.h"

namespace gaitwright::bullet {

/// A constraint on the joint velocities of one multibody, made of rows J qd with constant J. The second body of
/// Bullet's rows stays empty, which halves their cost.
class JointSpaceConstraint : public btMultiBodyConstraint {
 public:
  JointSpaceConstraint(btMultiBody& body, int link, int rows);

  void finalizeMultiDof() override {}
  int getIslandIdA() const override;
  int getIslandIdB() const override { return -1; }
  void debugDraw(btIDebugDraw*) override {}

 protected:
  struct Row {
    int index;               ///< of the stored impulse
    double target_velocity;  ///< of J qd [rad/s]
    double softness;         ///< J qd + softness * impulse = target_velocity
    double lowest, highest;  ///< impulse [N m s]
  };
  void AddTerm(int dof_row, double coefficient);
  /// @return J M^-1 J^T: the velocity J qd that a unit impulse gives.
  double AddRow(const Row& row, btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data);

 private:
  std::vector<double> jacobian_;
};

/// The motor of one independent coordinate, with the mechanical stops at its position limits.
///
/// Implicit PD: with h the step, the impulse p = h (kp (q* - q - h qd') + kd (qd* - qd')) of the velocity qd' after the
/// step is the row  qd' + gamma p = gamma h (kp (q* - q) + kd qd*),  gamma = 1 / (h^2 kp + h kd),
/// stable for every gain. Limits are on the sum of feed-forward and PD.
class MotorRow : public JointSpaceConstraint {
 public:
  /// Which of its rows is which: JointSpaceConstraint's index.
  static constexpr int kDrive = 0, kStop = 1;

  struct Limits {
    double lower, upper;  ///< position
    double effort;
  };
  MotorRow(const RobotBody& robot, btMultiBody& body, int dof, const Limits& limits);

  struct Target {
    double q, v;
    double tau_ff;  ///< within the effort limit
    double stiffness, damping;
    double excess = 0.0;  ///< feed-forward beyond the limit: the row has it, so that the sum is what is limited
  };
  void SetTarget(const Target& target) { target_ = target; }

  void createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                            const btContactSolverInfo& info) override;

  /// Torque of the last step: feed-forward plus PD.
  double Torque(double step_s);
  double effort_limit() const { return limits_.effort; }

  /// The coordinate, as the mean of its joints.
  double Position() const;

 private:
  const std::vector<RobotBody::Member>& members_;
  Limits limits_;
  Target target_ = {};
  bool driven_ = false;
};

/// Holds follower = multiplier * leader + offset.
class GearRow : public JointSpaceConstraint {
 public:
  GearRow(const RobotBody& robot, btMultiBody& body, const Joint& joint, int follower, int leader);

  void createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                            const btContactSolverInfo& info) override;
  double Error() const;

 private:
  int follower_, leader_;
  double multiplier_, offset_;
};

}  // namespace gaitwright::bullet
