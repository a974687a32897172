// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/bullet/controller.h"
#include "playback/bullet/world_options.h"

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

/// A robot on a terrain in Bullet, exact to rounding for the free multibody: RobotModel and Terrain in, forces and
/// states out in our own order and frames. Deterministic; make a new one for each playback.
///
/// The state is integrated semi-implicitly (q' = q + h v'). Motors are implicit PD with feed-forward and a limit on the
/// sum, which follows torque-speed curves and warmth (see Motor); motors of a transmission are so in motor space, each
/// within its own limit; damping, dry friction and rotor inertia of the joints
/// act implicitly, and never add energy; position limits are hard stops; mimic joints are geared to their leader (NAO's
/// RHipYawPitch), and the torque of the coordinate drives the whole gear. Contact is hard, friction a cone, restitution
/// zero; the robot does not touch itself.
class BulletWorld {
 public:
  /// @param q  first configuration, size nq; also where locked joints stay, and its x and y the start point of the
  /// ground.
  /// @throws InvalidArgument for an invalid q (CheckState), an option out of range or a locked dof that does not exist.
  BulletWorld(const RobotModel& model, const Terrain& terrain, const VectorX& q, const WorldOptions& options);
  ~BulletWorld();
  BulletWorld(BulletWorld&&) noexcept;
  BulletWorld& operator=(BulletWorld&&) noexcept;

  /// Puts the robot there, sizes nq and nv; forces and contacts are those of the last step still.
  /// @throws InvalidArgument as CheckState
  void SetState(const VectorX& q, const VectorX& v);
  const VectorX& q() const;
  const VectorX& v() const;

  /// Adds a force at a point in W for the coming step, on the base.
  void Push(const Vector3& force_W, const Vector3& p_W);
  /// Adds a force [N] on the base for the coming step, at its own centre of mass.
  void PushBase(const Vector3& force_W);
  /// Pushes at the centre of mass of the whole robot.
  void PushRobot(const Vector3& force_W);
  /// Pushes a body (see RobotModel::bodies) at its centre of mass; for the base as PushBase.
  void PushBody(int body, const Vector3& force_W);

  /// Adds a force at a point in W for the coming step, on a body.
  void PushAt(int body, const Vector3& force_W, const Vector3& p_W);

  /// Lifts the robot until no part is deeper than 0.01 mm in the ground, and no foot lower than with q = `as_planned`.
  /// @return the lift [m].
  double LiftOutOfGround(const VectorX& as_planned);

  /// One step. @throws InvalidArgument when the command has a wrong size or is not finite.
  void Step(const JointCommand& command);

  // Of the last step.
  const VectorX& tau() const;           ///< that motors give, by independent joint; zero where locked
  const VectorX& motor_torque() const;  ///< by motor (ActuatorOf): tau but for motors of transmissions
  const VectorX& effort_use() const;    ///< by motor: share of the effort limit in force, 1 at it; 0 without one
  const std::vector<FootContact>& feet() const;           ///< by foot
  const std::vector<std::string>& body_contacts() const;  ///< links other than feet that touch the ground

  /// Mean square of each motor's effort over its thermal_s, initially 0, for the thermal limit; 0 without a continuous
  /// effort in the model.
  VectorX mean_square_effort() const;

  /// Accelerations (size nv) by Bullet's articulated-body algorithm with no contact and no losses; the state is left at
  /// q, v.
  VectorX Accelerations(const VectorX& q, const VectorX& v, const VectorX& tau);

  double total_mass_kg() const;
  /// Largest deviation of a mimic joint from its leading joint [rad] or [m].
  double gear_error() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// How the unannounced slope turns the ground about the start point: p' = GroundTilt * p, by the slope's angle about
/// the level axis a quarter turn left of its direction. A robot that stands on it turns along.
Pose GroundTilt(const Terrain& terrain, const WorldOptions& options, const Vector2& start_W);

/// Coefficient of friction at a place, with the option's override.
double FrictionOf(const Terrain& terrain, const WorldOptions& options, const Vector2& p_W);

/// Whether state, torques and forces are finite and within bounds (1e6, and 1e12 for forces); otherwise the simulation
/// has diverged.
bool IsPhysical(const BulletWorld& world);

}  // namespace gaitwright
