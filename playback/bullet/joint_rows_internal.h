// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>

#include <vector>

#include "playback/bullet/robot_body_internal.h"
#include "playback/engine/motor_setup_internal.h"

namespace gaitwright::bullet {

using engine::EffortRange;

/// A constraint on the joint velocities of one multibody, made of rows J qd with constant J. The second body of
/// Bullet's rows is unused.
class JointSpaceConstraint : public btMultiBodyConstraint {
 public:
  JointSpaceConstraint(RobotBody& robot, int link, int rows);

  /// A non-zero entry of J: `share` of Bullet's velocity with that index.
  struct Term {
    int coordinate;
    double share;
  };
  const std::vector<Term>& terms() const { return terms_; }

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
  void AddTerm(int dof_row, double share);
  /// Data shared by rows with the same J.
  struct Response {
    int at;           ///< index of J in Bullet's arrays
    double velocity;  ///< J qd under all forces of the step except those of rows
  };
  /// J M^-1 J^T: the velocity J qd due to a unit impulse.
  double InverseInertia() const;
  Response Respond(btMultiBodyJacobianData& data);
  void AddRow(const Row& row, const Response& response, btMultiBodyConstraintArray& rows,
              btMultiBodyJacobianData& data);

 private:
  JointSpaceInertia& inertia_;
  std::vector<Term> terms_;
  VectorX jacobian_;
};

/// The motor of one independent coordinate, with the mechanical stops at its position limits and the losses of its
/// joints.
///
/// Implicit PD: with h the step, the impulse p = h (kp (q* - q - h qd') + kd (qd* - qd')), with qd' the velocity after
/// the step, is the row  qd' + gamma p = gamma h (kp (q* - q) + kd qd*),  gamma = 1 / (h^2 kp + h kd). It is stable for
/// every gain. Limits apply to the sum of feed-forward and PD. A share of this sum reaches the joint.
///
/// Losses are implicit too. Damping d and rotor inertia J give  p = -J (qd' - qd) - h d qd', with qd the velocity at
/// the start of the step (Bullet has added the step's forces to its own velocity before rows are made). The row is
/// qd' + p / (J + h d) = J qd / (J + h d). Dry friction f is the row qd' = 0 with an impulse within +-h f. No loss can
/// add energy.
class MotorRow : public JointSpaceConstraint {
 public:
  /// Indices of the rows, see JointSpaceConstraint.
  static constexpr int kDrive = 0, kStop = 1, kLoss = 2, kDryFriction = 3;

  using Traits = engine::JointTraits;
  MotorRow(RobotBody& robot, int dof, const Traits& traits);

  struct Target {
    double q, v;
    double tau_ff;  ///< within the limits
    double stiffness, damping;
    double over_limit = 0.0;  ///< feed-forward beyond the limits; it is part of the row, so that the sum is limited
    double wanted = 0.0;      ///< torque for the state at the start of the step, without limits
    EffortRange limits = {};
    double from_transmission = 0.0;  ///< largest impulse of a transmission's motors in the step, either direction
  };
  /// Sets the target of the coming step. Call at its start, while the joints have their old velocities.
  void SetTarget(const Target& target);

  void createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                            const btContactSolverInfo& info) override;

  /// Torque of the motor in the last step, feed-forward plus PD, before the share that is lost.
  double Torque(double step_s);
  const Target& target() const { return target_; }

  /// The coordinate and its rate, as means over its joints.
  double Position() const;
  double Rate() const;

 private:
  void AddLosses(double step_s, const Response& response, btMultiBodyConstraintArray& rows,
                 btMultiBodyJacobianData& data);

  const std::vector<RobotBody::Member>& members_;
  Traits traits_;
  Target target_ = {};
  double start_rate_ = 0.0;
  bool driven_ = false;
};

/// Holds follower = multiplier * leader + offset.
class GearRow : public JointSpaceConstraint {
 public:
  GearRow(RobotBody& robot, const Joint& joint, int follower, int leader);

  void createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                            const btContactSolverInfo& info) override;
  double Error() const;

 private:
  int follower_, leader_;
  double multiplier_, offset_;
};

}  // namespace gaitwright::bullet
