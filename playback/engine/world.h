// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/engine/controller.h"
#include "playback/engine/world_options.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

/// One foot's contact with the ground over the last step.
struct FootContact {
  bool touching = false;  ///< the foot carried force
  ContactWrench
      wrench;  ///< on the foot; moment about its contact frame's origin (see ContactFrame) at the step's start
  double normal_n = 0.0, tangential_n = 0.0;  ///< of the contact forces, along and across the ground's normals
  double friction = 0.0;                      ///< coefficient of this contact
  double penetration_m = 0.0;                 ///< at the deepest point
  Vector3 p_W = Vector3::Zero();              ///< contact frame's origin at the step's start, touching or not [m]
  double speed_m_s = 0.0;                     ///< of that origin over the step
  double slide_m = 0.0;  ///< slide of its material along the ground, mean over its points weighted by normal force
};

/// A robot on a terrain in a physics engine: RobotModel and Terrain in, forces and states out, in our own order and
/// frames. Deterministic; create a new world for each playback (MakeWorld).
///
/// The state is integrated semi-implicitly (q' = q + h v'). Motors are implicit PD with feed-forward. A limit on the
/// sum follows torque-speed curves and the thermal limit (see Motor). Motors of a transmission work in motor space,
/// each within its own limit. Damping, dry friction and rotor inertia of the joints are implicit and never add energy.
/// Position limits are hard stops. Mimic joints are geared to their leader (NAO's RHipYawPitch); the torque of the
/// coordinate drives the whole gear. Friction is a cone, restitution is zero; the robot does not touch itself.
class World {
 public:
  virtual ~World() = default;

  /// Sets the state, sizes nq and nv; forces and contacts remain those of the last step.
  /// @throws InvalidArgument as CheckState
  virtual void SetState(const VectorX& q, const VectorX& v) = 0;
  virtual const VectorX& q() const = 0;
  virtual const VectorX& v() const = 0;

  /// Adds a force [N] for the coming step on a body (see RobotModel::bodies), at its own centre of mass.
  virtual void PushBody(int body, const Vector3& force_W) = 0;
  /// Pushes a body at a point in W.
  virtual void PushAt(int body, const Vector3& force_W, const Vector3& p_W) = 0;
  /// Pushes the base at the centre of mass of the whole robot.
  virtual void PushRobot(const Vector3& force_W) = 0;

  /// Lifts the robot until no part is deeper than 0.01 mm in the ground, and no foot is lower than with q =
  /// `as_planned`.
  /// @return the lift [m].
  virtual double LiftOutOfGround(const VectorX& as_planned) = 0;

  /// Deepest contact of the current state. Has no effect on later steps.
  virtual Penetration DeepestPenetration() = 0;

  /// One step. @throws InvalidArgument when the command has a wrong size or is not finite.
  virtual void Step(const JointCommand& command) = 0;

  // Results of the last step.
  virtual const VectorX& tau() const = 0;           ///< torques of the motors, by independent joint; zero where locked
  virtual const VectorX& motor_torque() const = 0;  ///< by motor (ActuatorOf): tau, except in transmissions
  virtual const VectorX& effort_use() const = 0;    ///< by motor: share of the current effort limit; 0 without a limit
  virtual const std::vector<FootContact>& feet() const = 0;           ///< by foot
  virtual const std::vector<std::string>& body_contacts() const = 0;  ///< links other than feet that touch the ground

  /// Mean square of each motor's effort over its thermal_s, initially 0, for the thermal limit; 0 without a continuous
  /// effort in the model.
  virtual VectorX mean_square_effort() const = 0;

  virtual double total_mass_kg() const = 0;

  /// Adds a force at a point in W for the coming step, on the base.
  void Push(const Vector3& force_W, const Vector3& p_W) { PushAt(0, force_W, p_W); }
  /// Adds a force [N] on the base for the coming step, at its own centre of mass.
  void PushBase(const Vector3& force_W) { PushBody(0, force_W); }
};

/// An engine refuses a robot or a ground that is valid for this program.
class EngineRefusal : public InvalidArgument {
 public:
  using InvalidArgument::InvalidArgument;
};

/// @throws InvalidArgument for options out of range, an invalid q (CheckState), or a locked dof that does not
/// exist.
void CheckWorld(const RobotModel& model, const VectorX& q, const WorldOptions& options);
/// @throws InvalidArgument for a command of a wrong size, with numbers that are not finite, or negative gains.
void CheckCommand(const JointCommand& command, int num_dofs);

/// Largest distance of the feet's contact points below their places with `as_planned`; not negative [m].
double HighestDrop(const RobotModel& model, const VectorX& as_planned, const VectorX& now);

/// Pose change of the ground by the unannounced slope about the start point, p' = GroundTilt * p: a turn by the slope's
/// angle about the level axis 90 degrees left of its direction. A robot that stands on the ground turns with it.
Pose GroundTilt(const Terrain& terrain, const WorldOptions& options, const Vector2& start_W);

/// Names of the solids of a world, in the order in which engines make them: obstacles, patches, height fields; with
/// bumps, obstacles and one solid "ground".
std::vector<std::string> SolidNames(const Terrain& terrain, bool with_bumps);

/// Coefficient of friction at a place, including the option's override.
double FrictionOf(const Terrain& terrain, const WorldOptions& options, const Vector2& p_W);

/// Whether state, torques and forces are finite and within bounds (1e6, and 1e12 for forces); otherwise the simulation
/// has diverged.
bool IsPhysical(const World& world);

}  // namespace gaitwright
