// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "playback/engine/world.h"

namespace gaitwright {

/// A robot on a terrain in MuJoCo. Robot, ground, options and state are those of BulletWorld. The two share no code
/// except the limits of the motors.
class MujocoWorld : public World {
 public:
  /// As BulletWorld. @throws InvalidArgument as CheckWorld, and with MuJoCo's message if MuJoCo refuses the model.
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

  /// The mass matrix without rotors, and the forces b of M a + b = tau, at a state; for robots without mimic joints.
  MatrixX MassMatrix(const VectorX& q);
  VectorX BiasForces(const VectorX& q, const VectorX& v);
  /// The world as a MuJoCo file, without motors and joint losses.
  const std::string& mjcf() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gaitwright
