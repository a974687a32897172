// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "playback/engine/controller.h"
#include "playback/engine/motor_setup_internal.h"
#include "playback/mujoco/compiled_internal.h"

namespace gaitwright::mujoco {

/// A joint of MuJoCo that belongs to an independent coordinate.
struct Member {
  int qpos, dof;              ///< indices of its position and rate
  double multiplier, offset;  ///< position = multiplier * coordinate + offset
  double share;               ///< of the coordinate's torque; also the weight of its rate in the coordinate's rate
};

/// The motors of a world, and the losses of the joints.
///
/// With h the step, D = damping + h stiffness and t0 the torque of the targets at zero rate, a motor's torque at the
/// end of the step is t0 - D v'. So (M + h D) (v' - v) / h = t0 - D v + ...: a step with h D as armature. Contacts are
/// solved in the same step, so that every gain is stable. Damping of joints is part of D. A motor at its limit gives a
/// constant torque, and D contains only the other motors. Solving again finds the motors at limits. Joints that reach a
/// stop are found in the same way.
class Motors {
 public:
  /// Also sets the dry friction of the joints in `m`. Keeps all arguments by reference.
  Motors(const RobotModel& model, const WorldOptions& options, mjModel& m, mjData& d);

  const std::vector<Member>& members(int dof) const { return members_[static_cast<std::size_t>(dof)]; }
  bool locked(int dof) const { return members(dof).empty(); }
  /// Rate or acceleration of a coordinate, from those of all joints.
  double RateOf(int dof, const mjtNum* rates) const;

  /// Sets the command for a step that begins at q, v.
  void Command(const JointCommand& command, const VectorX& q, const VectorX& v);
  /// Writes armatures and torques to the model and data, for the motors that are currently at limits.
  void Apply();
  /// Rotors that several joints turn couple these joints: R^T diag(J) R in the mass matrix. MuJoCo stores only entries
  /// of joints of one chain, such as those of an ankle. Call between mj_crb and mj_factorM.
  void AddSharedRotors();
  /// Whether the right motors are at limits, for the computed accelerations; if not, changes them.
  bool Hold();
  /// Whether no joint passes a position limit within the step, for the computed accelerations; stops the joints that
  /// do. A joint beyond a limit moves back by a fifth of the violation in each step.
  bool HoldStops();
  /// Records the torques of the step, which ended with rates `v`.
  void Read(const VectorX& v);

  // Results of the last step, as in World.
  const VectorX& tau() const { return tau_; }
  const VectorX& motor_torque() const { return motor_torque_; }
  const VectorX& effort_use() const { return effort_use_; }
  VectorX mean_square_effort() const;

 private:
  struct Motor {
    double at_rest = 0.0, by_speed = 0.0;  // torque = at_rest - by_speed * rate at the end of the step,
    double constant = 0.0;                 // or this torque if `held`
    bool held = false;                     // at a limit
    double wanted = 0.0;                   // at the start of the step, without limits
    engine::EffortRange limits{0.0, 0.0};
  };
  int IdOfLeader(int dof) const;
  void SetUpJoint(int dof);
  double StopInertia(int dof) const;
  engine::EffortRange RangeOf(int motor, double speed) const;
  bool IsImplicit(const Motor& motor) const { return motor.by_speed > 0.0 && options_.actuation != "torque"; }
  double WantedAtEnd(int dof) const;
  bool HoldOwn();
  bool HoldShared(const Transmission& transmission);
  void AddSharedRotors(const Transmission& transmission);

  const RobotModel& model_;
  const WorldOptions& options_;
  mjModel& m_;
  mjData& d_;
  std::vector<std::vector<Member>> members_;  // by dof; empty where locked
  std::vector<engine::Drive> drives_;         // by motor (ActuatorOf)
  std::vector<double> bounds_;                // by motor; see BoundOf
  std::vector<engine::JointTraits> traits_;   // by dof
  std::vector<Motor> motors_;                 // by dof; `limits` of a joint of a transmission are those of its motor
  std::vector<std::optional<double>> stops_;  // by dof: rate that a stop allows, if it acts in this step
  VectorX bare_inertia_;                      // by degree of freedom of m_: inertia at the joint, without motors
  VectorX q_, v_, tau_, motor_torque_, effort_use_;
};

}  // namespace gaitwright::mujoco
