// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "playback/engine/world.h"

namespace gaitwright {

/// A robot on a terrain in MuJoCo: the same robot, ground, options and state as BulletWorld, and no code in common with
/// it but for what motors may give.
class MujocoWorld : public World {
 public:
  /// As BulletWorld. @throws InvalidArgument as CheckWorld, and where MuJoCo refuses the model, with its message.
  MujocoWorld(const RobotModel& model, const Terrain& terrain, const VectorX& q, const WorldOptions& options);
  ~MujocoWorld() override;

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

  /// The mass matrix without rotors, and the forces b of M a + b = tau, at a state; of robots without mimicking joints.
  MatrixX MassMatrix(const VectorX& q);
  VectorX BiasForces(const VectorX& q, const VectorX& v);
  /// The world as a file of MuJoCo, but for what motors and joints do.
  const std::string& mjcf() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gaitwright
