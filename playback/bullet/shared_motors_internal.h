// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "kinematics/model/transmission.h"
#include "playback/bullet/joint_rows_internal.h"
#include "playback/engine/world_options.h"

namespace gaitwright::bullet {

class SharedMotors;

/// The row of one motor of a transmission in motor coordinates. J is its row of R, so that a motor impulse p acts on
/// the joints as R^T p. Its rotor is a second row with the same J.
class SharedMotorRow : public JointSpaceConstraint {
 public:
  /// Indices of its rows; they differ from those of MotorRow.
  static constexpr int kSharedDrive = 4, kSharedRotor = 5;

  SharedMotorRow(RobotBody& robot, const Transmission& transmission, Eigen::Index motor, const SharedMotors& motors);

  void createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                            const btContactSolverInfo& info) override;

  const SharedMotors& motors() const { return motors_; }
  Eigen::Index index() const { return motor_; }

 private:
  const SharedMotors& motors_;
  Eigen::Index motor_;
};

/// The motors of one transmission and the implicit PD of its joints.
///
/// = Notation =
///   R  the transmission's matrix; w' = R v' motor speeds after the step, p impulses of the motors
///   G  diag(1 / (h^2 kp + h kd)) of the joints, h the step
/// The joints' PD requires joint impulses P = h (kp (q* - q - h v') + kd (v* - v')), i.e. v' + G P = h G c with
/// c = kp (q* - q) + kd v*. With P = R^T p this is, in motor coordinates,
///   w' + S p = h R G c,   S = R G R^T,
/// with limits on each p. S couples the motors (SofteningOf); CondensedSolver takes this coupling into account. If a
/// motor is at its limit, the others bring the joint impulses nearest to the required ones, with each joint's deviation
/// weighted by G. If S is diagonal, as for a symmetric differential with equal gains, the others give their required
/// impulses. If some joints have gains and a joint has none, a millionth of the largest gain is used for it.
///
/// The inertia J of each rotor is implicit, as in MotorRow: w' + p / J = w with w the speed at the start of the step.
class SharedMotors {
 public:
  struct Traits {
    VectorX rotor_inertia;  ///< by motor [kg m^2]
    double torque_scale = 1.0;
    double step_s = 1e-3;
    bool has_rows = true;  ///< false where torques are explicit
  };
  /// @param joints  rows of the losses and stops of the joints, by joint of the transmission; null where locked.
  SharedMotors(RobotBody& robot, const Transmission& transmission, const std::vector<MotorRow*>& joints,
               const Traits& traits);

  /// Command of the joints, by joint of the transmission.
  struct Command {
    VectorX q, v, tau_ff, stiffness, damping;
  };
  /// Sets the target of the coming step, at its start. @param limits  of each motor in it.
  /// @return feed-forward torques of the joints that act in addition to the rows.
  VectorX SetTarget(const Command& command, const std::vector<EffortRange>& limits);

  /// Torques of the motors in the last step before losses, and the torques required of them at its start.
  VectorX Torques() const;
  const VectorX& wanted() const { return wanted_; }
  const std::vector<EffortRange>& limits() const { return limits_; }
  /// Joint torques of the transmission for given motor torques; zero where locked.
  VectorX JointTorques(const VectorX& torques) const;
  /// Current speeds of the motors.
  VectorX Speeds() const;

  const Transmission& transmission() const { return transmission_; }
  std::vector<std::unique_ptr<SharedMotorRow>>& rows() { return rows_; }

  // For the rows.
  bool driven() const { return driven_; }
  const Traits& traits() const { return traits_; }
  double SofteningOf(Eigen::Index a, Eigen::Index b) const { return softness_(a, b); }
  double target_velocity(Eigen::Index motor) const { return target_[motor]; }
  double start_speed(Eigen::Index motor) const { return start_[motor]; }
  EffortRange ImpulseRange(Eigen::Index motor) const;

 private:
  void SetRows(const Command& command, const VectorX& asked, const VectorX& over_limit);
  void SetReach(const Command& command, const VectorX& asked);

  const Transmission& transmission_;
  std::vector<MotorRow*> joints_;
  Traits traits_;
  std::vector<std::unique_ptr<SharedMotorRow>> rows_;  ///< by motor
  std::vector<EffortRange> limits_;
  VectorX inside_, wanted_, target_, start_;
  MatrixX softness_;
  bool driven_ = false;
};

/// The motors of a transmission, including rotor inertias.
SharedMotors::Traits TraitsOf(const Transmission& transmission, const WorldOptions& options);

}  // namespace gaitwright::bullet
