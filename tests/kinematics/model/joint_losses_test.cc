// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/joint_losses.h"

#include <gtest/gtest.h>

#include "kinematics/dynamics/dynamics.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

TEST(JointLosses, AreThoseOfTheUrdf) {
  const RobotModel model = *LoadRobotFromText(FourLegs(), "");
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    EXPECT_EQ(LossesOf(model, dof).damping, 0.1);
    EXPECT_EQ(LossesOf(model, dof).friction, 0.0);
    EXPECT_FALSE(LossesOf(model, dof).none());
  }
  EXPECT_TRUE(LossesOf(*LoadNamedRobot("a1"), 0).none());
}

TEST(JointLosses, OfGearedJointsAddUp) {
  RobotModel model = *LoadRobotFromText(FourLegs(), "");
  model.joints[1].dof = 0;  // as if it followed the first joint
  model.joints[1].multiplier = -3.0;
  model.joints[0].friction = 0.5;
  model.joints[1].friction = 0.2;
  EXPECT_NEAR(LossesOf(model, 0).damping, 0.1 + 9.0 * 0.1, 1e-15);
  EXPECT_NEAR(LossesOf(model, 0).friction, 0.5 + 3.0 * 0.2, 1e-15);
}

TEST(JointLosses, CanBeTakenOut) {
  RobotModel model = *LoadRobotFromText(FourLegs(), "");
  model.motors.resize(model.dof_names.size());
  model.motors[3].rotor_inertia = 0.02;
  model.motors[3].continuous_effort = 7.0;
  model.joints[1].friction = 0.2;
  const RobotModel without = WithoutLosses(model);
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    EXPECT_FALSE(LossesOf(model, dof).none());
    EXPECT_TRUE(LossesOf(without, dof).none());
  }
  EXPECT_EQ(without.motors[3].continuous_effort, 7.0) << "limits stay";
  EXPECT_EQ(without.hash, model.hash);
}

TEST(JointLosses, RotorsAreOnTheDiagonalOfTheMassMatrix) {
  RobotModel model = *LoadRobotFromText(FourLegs(), "");
  model.motors.resize(model.dof_names.size());
  model.motors[3].rotor_inertia = 0.02;
  EXPECT_EQ(LossesOf(model, 3).rotor_inertia, 0.02);
  DynamicsScratch scratch(model);
  MatrixX M(model.nv(), model.nv());
  MassMatrix(model, StandingConfiguration(model), scratch, M);
  MatrixX with = M;
  AddRotorInertia(model, with);
  EXPECT_EQ((with - M).norm(), with(9, 9) - M(9, 9));
  EXPECT_NEAR(with(9, 9) - M(9, 9), 0.02, 1e-15);
}

}  // namespace
}  // namespace gaitwright
