// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>

#include <vector>

#include "playback/bullet/robot_body_internal.h"
#include "playback/engine/motor_setup_internal.h"

namespace gaitwright::bullet {

using engine::EffortRange;

/// A constraint on the joint velocities of one multibody, made of rows J qd with constant J. The second body of
/// Bullet's rows stays empty.
class JointSpaceConstraint : public btMultiBodyConstraint {
 public:
  JointSpaceConstraint(RobotBody& robot, int link, int rows);

  /// What is not zero in J: `share` of the velocity with that number among Bullet's.
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
  /// What rows with the same J have in common.
  struct Response {
    int at;           ///< of J in Bullet's arrays
    double velocity;  ///< J qd under all forces of the step but those of rows
  };
  /// J M^-1 J^T: the velocity J qd that a unit impulse gives.
  double InverseInertia() const;
  Response Respond(btMultiBodyJacobianData& data);
  void AddRow(const Row& row, const Response& response, btMultiBodyConstraintArray& rows,
              btMultiBodyJacobianData& data);

 private:
  JointSpaceInertia& inertia_;
  std::vector<Term> terms_;
  VectorX jacobian_;
};

/// The motor of one independent coordinate, with the mechanical stops at its position limits and what its joints lose.
///
/// Implicit PD: with h the step, the impulse p = h (kp (q* - q - h qd') + kd (qd* - qd')) of the velocity qd' after the
/// step is the row  qd' + gamma p = gamma h (kp (q* - q) + kd qd*),  gamma = 1 / (h^2 kp + h kd),
/// stable for every gain. Limits are on the sum of feed-forward and PD. Of both a share arrives at the joint.
///
/// Losses are implicit too. Damping d and rotor inertia J, with qd the velocity at the start of the step (Bullet has
/// added the step's forces to its own by the time rows are made):  p = -J (qd' - qd) - h d qd'  is the row
/// qd' + p / (J + h d) = J qd / (J + h d). Dry friction f is the row qd' = 0 with an impulse within +-h f. None of them
/// can add energy.
class MotorRow : public JointSpaceConstraint {
 public:
  /// Which of its rows is which: JointSpaceConstraint's index.
  static constexpr int kDrive = 0, kStop = 1, kLoss = 2, kDryFriction = 3;

  using Traits = engine::JointTraits;
  MotorRow(RobotBody& robot, int dof, const Traits& traits);

  struct Target {
    double q, v;
    double tau_ff;  ///< within the limits
    double stiffness, damping;
    double excess = 0.0;  ///< feed-forward beyond the limits: the row has it, so that the sum is what is limited
    double wanted = 0.0;  ///< by the state at the start of the step, without limits
    EffortRange limits = {};
    double from_transmission = 0.0;  ///< the most that rows of a transmission's motors push in the step, either way
  };
  /// For the coming step; to be called at its start, when the joints have their old velocities still.
  void SetTarget(const Target& target);

  void createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                            const btContactSolverInfo& info) override;

  /// The motor's own torque of the last step, feed-forward plus PD, arriving or not.
  double Torque(double step_s);
  const Target& target() const { return target_; }

  /// The coordinate and its rate, as the mean of its joints.
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
