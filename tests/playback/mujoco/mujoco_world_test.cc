// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo's model equals ours: mass matrix, bias forces and positions at random states, and motor torques.
#include "playback/mujoco/mujoco_world.h"

#include <gtest/gtest.h>

#include <random>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/joint_losses.h"
#include "kinematics/model/load_robot.h"
#include "tests/playback/one_body.h"

namespace gaitwright {
namespace {

class MujocoWorldTest : public ::testing::TestWithParam<const char*> {
 protected:
  MujocoWorldTest() : random_(7) {}

  double Uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }

  VectorX RandomConfiguration() {
    VectorX q = StandingConfiguration(model_);
    for (int i = 0; i < 3; ++i) q[i] += Uniform();
    q.segment<4>(3) = Quaternion(Uniform(), Uniform(), Uniform(), Uniform()).normalized().coeffs();
    for (int i = 0; i < model_.num_dofs(); ++i) q[7 + i] += 0.5 * Uniform();
    return q;
  }

  VectorX RandomRates() {
    VectorX v(model_.nv());
    for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = Uniform();
    return v;
  }

  std::mt19937 random_;
  const RobotModel model_ = WithoutLosses(*LoadNamedRobot(GetParam()));
};

TEST_P(MujocoWorldTest, HasOurMassMatrixAndBiasForces) {
  MujocoWorld world(model_, FlatTerrain(), StandingConfiguration(model_), {});
  DynamicsScratch scratch(model_);
  for (int k = 0; k < 10; ++k) {
    const VectorX q = RandomConfiguration(), v = RandomRates();
    MatrixX M(model_.nv(), model_.nv());
    MassMatrix(model_, q, scratch, M);
    EXPECT_LT((world.MassMatrix(q) - M).cwiseAbs().maxCoeff(), 1e-8);
    VectorX bias;
    InverseDynamics(model_, q, v, VectorX::Zero(model_.nv()), scratch, bias);
    EXPECT_LT((world.BiasForces(q, v) - bias).cwiseAbs().maxCoeff(), 1e-8 * (1.0 + bias.cwiseAbs().maxCoeff()));
  }
}

TEST_P(MujocoWorldTest, ItsTextIsReadAgain) {
  const MujocoWorld world(model_, FlatTerrain(), StandingConfiguration(model_), {});
  EXPECT_NE(world.mjcf().find("<freejoint"), std::string::npos);
  EXPECT_NEAR(world.total_mass_kg(), model_.total_mass_kg, 1e-6 * model_.total_mass_kg);
}

// The sum of the two smaller moments equals the largest one, up to rounding.
TEST(MujocoWorldOfPlates, TakesMomentsOfPlatesInAnyAttitude) {
  for (int k = 0; k < 20; ++k) {
    const Matrix3 R(Eigen::AngleAxisd(0.3 * k, Vector3(1.0, 0.2 * k, -0.5).normalized()));
    RobotModel plate = one_body::Ball();
    plate.bodies[0].I_C = R * Vector3(0.01, 0.02, 0.03 + 1e-12).asDiagonal() * R.transpose();
    EXPECT_NO_THROW(MujocoWorld(plate, FlatTerrain(), one_body::OnSlope(1.0, 0.0), {}));
  }
}

TEST(MujocoWorldOfPlates, WhatMujocoRefusesIsDistinguished) {
  RobotModel twice = one_body::Ball();
  twice.bodies.push_back(twice.bodies[0]);
  Joint joint;
  joint.name = "joint";
  joint.lower = -1.0;
  joint.upper = 1.0;
  twice.joints = {joint};
  twice.dof_names = {"joint"};
  twice.dof_joint = {0};
  VectorX q = VectorX::Zero(8);
  q[6] = 1.0;
  EXPECT_THROW(MujocoWorld(twice, FlatTerrain(), q, {}), EngineRefusal) << "two bodies of one name";
}

INSTANTIATE_TEST_SUITE_P(Robots, MujocoWorldTest, ::testing::Values("a1", "h1", "mini_cheetah", "humanoid"),
                         [](const auto& i) { return std::string(i.param); });

}  // namespace
}  // namespace gaitwright
