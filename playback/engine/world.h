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
  bool touching = false;  ///< it carried force
  ContactWrench
      wrench;  ///< on the foot; moment about its contact frame's origin (see ContactFrame) at the step's start
  double normal_n = 0.0, tangential_n = 0.0;  ///< of the contact forces, along and across the ground's normals
  double friction = 0.0;                      ///< coefficient of this contact
  double penetration_m = 0.0;                 ///< deepest point
  Vector3 p_W = Vector3::Zero();              ///< contact frame's origin at the step's start, touching or not [m]
  double speed_m_s = 0.0;                     ///< of that origin over the step
  double slide_m = 0.0;  ///< how far its material moved along the ground, mean of its points weighted by normal force
};

/// A robot on a terrain in a physics engine: RobotModel and Terrain in, forces and states out in our own order and
/// frames. Deterministic; make a new one for each playback (MakeWorld).
///
/// The state is integrated semi-implicitly (q' = q + h v'). Motors are implicit PD with feed-forward and a limit on the
/// sum, which follows torque-speed curves and warmth (see Motor); motors of a transmission are so in motor space, each
/// within its own limit; damping, dry friction and rotor inertia of the joints act implicitly, and never add energy;
/// position limits are hard stops; mimic joints are geared to their leader (NAO's RHipYawPitch), and the torque of the
/// coordinate drives the whole gear. Friction is a cone, restitution zero; the robot does not touch itself.
class World {
 public:
  virtual ~World() = default;

  /// Puts the robot there, sizes nq and nv; forces and contacts are those of the last step still.
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

  /// Lifts the robot until no part is deeper than 0.01 mm in the ground, and no foot lower than with q = `as_planned`.
  /// @return the lift [m].
  virtual double LiftOutOfGround(const VectorX& as_planned) = 0;

  /// Deepest contact of the present state. Has no effect on the steps that follow.
  virtual Penetration DeepestPenetration() = 0;

  /// One step. @throws InvalidArgument when the command has a wrong size or is not finite.
  virtual void Step(const JointCommand& command) = 0;

  // Of the last step.
  virtual const VectorX& tau() const = 0;           ///< that motors give, by independent joint; zero where locked
  virtual const VectorX& motor_torque() const = 0;  ///< by motor (ActuatorOf): tau but for motors of transmissions
  virtual const VectorX& effort_use() const = 0;    ///< by motor: share of the effort limit in force; 0 without one
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

/// An engine that refuses a robot or a ground which are valid for this program.
class EngineRefusal : public InvalidArgument {
 public:
  using InvalidArgument::InvalidArgument;
};

/// @throws InvalidArgument for options out of range, an invalid q (CheckState), or a locked dof that does not
/// exist.
void CheckWorld(const RobotModel& model, const VectorX& q, const WorldOptions& options);
/// @throws InvalidArgument for a command of a wrong size, with numbers that are not finite, or negative gains.
void CheckCommand(const JointCommand& command, int num_dofs);

/// How much the lowest-fallen contact point of the feet is below where it is with `as_planned`; not negative [m].
double HighestDrop(const RobotModel& model, const VectorX& as_planned, const VectorX& now);

/// How the unannounced slope turns the ground about the start point: p' = GroundTilt * p, by the slope's angle about
/// the level axis a quarter turn left of its direction. A robot that stands on it turns along.
Pose GroundTilt(const Terrain& terrain, const WorldOptions& options, const Vector2& start_W);

/// Names of the solids that a world is made of, in the order in which engines make them: obstacles, patches, height
/// fields; with bumps obstacles and one solid "ground".
std::vector<std::string> SolidNames(const Terrain& terrain, bool with_bumps);

/// Coefficient of friction at a place, with the option's override.
double FrictionOf(const Terrain& terrain, const WorldOptions& options, const Vector2& p_W);

/// Whether state, torques and forces are finite and within bounds (1e6, and 1e12 for forces); otherwise the simulation
/// has diverged.
bool IsPhysical(const World& world);

}  // namespace gaitwright
