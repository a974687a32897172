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
  int qpos, dof;              ///< where its position and rate are
  double multiplier, offset;  ///< position = multiplier * coordinate + offset
  double share;               ///< of the coordinate's torque, and by which its rate tells the coordinate's
};

/// The motors of a world, and what joints take for themselves.
///
/// With h the step, D = damping + h stiffness and t0 the torque at rest of the targets, a motor's torque at the end of
/// the step is t0 - D v'. So (M + h D) (v' - v) / h = t0 - D v + ...: a step with h D as armature, in which contacts
/// are solved too, so that no gain is too stiff. Damping of joints is in D. A motor at its limit gives that, and D is
/// that of the others; which motors those are is found by solving again. So are the joints that reach a stop.
class Motors {
 public:
  /// Sets the dry friction of the joints in `m`, too. All are kept by reference.
  Motors(const RobotModel& model, const WorldOptions& options, mjModel& m, mjData& d);

  const std::vector<Member>& members(int dof) const { return members_[static_cast<std::size_t>(dof)]; }
  bool locked(int dof) const { return members(dof).empty(); }
  /// Of a coordinate, from rates or accelerations of all joints.
  double RateOf(int dof, const mjtNum* rates) const;

  /// Takes the command for a step that begins at q, v.
  void Command(const JointCommand& command, const VectorX& q, const VectorX& v);
  /// Puts armatures and torques into the model and data, with the motors at limits that are so now.
  void Apply();
  /// Rotors that several joints turn couple these: R^T diag(J) R in the mass matrix. MuJoCo keeps of it what joints of
  /// one chain have in common, as those of an ankle do. To be called between mj_crb and mj_factorM.
  void AddSharedRotors();
  /// Whether the motors that are at limits are those that should be, by the accelerations found; else changes them.
  bool Hold();
  /// Whether no joint passes a limit of its position within the step, by the accelerations found; stops those that do.
  /// A joint that is past a limit goes back by a fifth of that in each step.
  bool HoldStops();
  /// Takes note of the torques of the step, which ended with rates `v`.
  void Read(const VectorX& v);

  // Of the last step, as World has them.
  const VectorX& tau() const { return tau_; }
  const VectorX& motor_torque() const { return motor_torque_; }
  const VectorX& effort_use() const { return effort_use_; }
  VectorX mean_square_effort() const;

 private:
  struct Motor {
    double at_rest = 0.0, by_speed = 0.0;  // torque = at_rest - by_speed * rate at the end of the step,
    double constant = 0.0;                 // or this one
    bool held = false;                     // which of both
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
  std::vector<std::vector<Member>> members_;  // by dof; none where locked
  std::vector<engine::Drive> drives_;         // by motor (ActuatorOf)
  std::vector<double> bounds_;                // by motor; see BoundOf
  std::vector<engine::JointTraits> traits_;   // by dof
  std::vector<Motor> motors_;                 // by dof; `limits` of one of a transmission are those of its motor
  std::vector<std::optional<double>> stops_;  // by dof: the rate that a stop allows, where one holds in this step
  VectorX bare_inertia_;                      // by degree of freedom of m_: felt by a torque there, without motors
  VectorX q_, v_, tau_, motor_torque_, effort_use_;
};

}  // namespace gaitwright::mujoco
