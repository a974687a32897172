// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "playback/engine/world.h"

namespace gaitwright {

/// A robot on a terrain in Bullet. Free multibody motion is exact to rounding; contact is hard.
class BulletWorld : public World {
 public:
  /// @param q  initial configuration, size nq; locked joints stay at it, and its x and y are the start point of the
  /// ground.
  /// @param condenses  true: contacts are solved by our condensed solver. False: by Bullet's own solver, without
  /// motors; for tests that compare the two.
  /// @throws InvalidArgument as CheckWorld
  BulletWorld(const RobotModel& model, const Terrain& terrain, const VectorX& q, const WorldOptions& options,
              bool condenses = true);
  ~BulletWorld() override;

  void SetState(const VectorX& q, const VectorX& v) override;
  const VectorX& q() const override;
  const VectorX& v() const override;
  void PushBody(int body, const Vector3& force_W) override;
  void PushAt(int body, const Vector3& force_W, const Vector3& p_W) override;
  void PushRobot(const Vector3& force_W) override;
  double LiftOutOfGround(const VectorX& as_planned) override;
  Penetration DeepestPenetration() override;
  void Step(const JointCommand& command) override;
  const VectorX& tau() const override;
  const VectorX& motor_torque() const override;
  const VectorX& effort_use() const override;
  const std::vector<FootContact>& feet() const override;
  const std::vector<std::string>& body_contacts() const override;
  VectorX mean_square_effort() const override;
  double total_mass_kg() const override;

  /// Accelerations (size nv) by Bullet's articulated-body algorithm, without contacts and losses. Leaves the state at
  /// q, v.
  VectorX Accelerations(const VectorX& q, const VectorX& v, const VectorX& tau);
  /// Largest deviation of a mimic joint from its commanded position [rad] or [m].
  double gear_error() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gaitwright
