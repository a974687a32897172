// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/hang_limbs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

/// NAO without its robot.yaml.
RobotModel NaoFromUrdfAlone() { return *LoadRobotFromText(LoadNamedRobot("nao")->urdf_text, "", "nao"); }

double Standing(const RobotModel& model, const std::string& joint) {
  return model.standing_joints[model.DofIndex(joint)];
}

/// Torque that holds a joint against gravity with an upright base [N m].
double HoldingTorque(const RobotModel& model, const VectorX& joints, const std::string& joint) {
  DynamicsScratch scratch(model);
  VectorX q = StandingConfiguration(model), tau(model.nv());
  q.tail(model.num_dofs()) = joints;
  const VectorX still = VectorX::Zero(model.nv());
  ForwardKinematics(model, q, scratch);
  InverseDynamics(model, q, still, still, scratch, tau);
  return tau[6 + model.DofIndex(joint)];
}

TEST(HangLimbs, ArmsHangWhereTheirWeightIsLeastAndHeadsStayUp) {
  const RobotModel model = NaoFromUrdfAlone();
  EXPECT_NEAR(Standing(model, "LShoulderPitch"), 0.5 * M_PI, 0.1);
  EXPECT_EQ(Standing(model, "HeadPitch"), 0.0);
  EXPECT_EQ(Standing(model, "HeadYaw"), 0.0);
  // With hanging arms, the shoulder needs no torque; with the arms forward, it does.
  VectorX forward = model.standing_joints;
  forward[model.DofIndex("LShoulderPitch")] = 0.0;
  EXPECT_GT(std::abs(HoldingTorque(model, forward, "LShoulderPitch")), 0.3);
  EXPECT_LT(std::abs(HoldingTorque(model, model.standing_joints, "LShoulderPitch")), 0.02);
}

TEST(HangLimbs, BothSidesMirrorAndStandOffTheBody) {
  const RobotModel model = NaoFromUrdfAlone();
  EXPECT_NEAR(Standing(model, "LShoulderPitch"), Standing(model, "RShoulderPitch"), 1e-6);
  EXPECT_NEAR(Standing(model, "LShoulderRoll"), -Standing(model, "RShoulderRoll"), 1e-6);
  EXPECT_GT(Standing(model, "LShoulderRoll"), 0.0);
}

TEST(HangLimbs, WhatIsGivenStays) {
  const RobotModel model = NaoFromUrdfAlone();
  VectorX given = VectorX::Constant(model.num_dofs(), kNotGiven);
  VectorX joints = VectorX::Zero(model.num_dofs());
  const int left = model.DofIndex("LShoulderPitch");
  given[left] = joints[left] = 0.3;
  const auto notes = HangLimbs(model, given, joints);
  EXPECT_EQ(joints[left], 0.3);
  EXPECT_GT(joints[model.DofIndex("RShoulderPitch")], 1.0);
  EXPECT_FALSE(notes.empty());
}

TEST(HangLimbs, LegsAndQuadrupedsAreLeftAlone) {
  const RobotModel a1 = *LoadNamedRobot("a1"), nao = NaoFromUrdfAlone();
  VectorX joints = VectorX::Zero(a1.num_dofs());
  EXPECT_TRUE(HangLimbs(a1, VectorX::Constant(a1.num_dofs(), kNotGiven), joints).empty());
  EXPECT_EQ(joints, VectorX::Zero(a1.num_dofs()));
  VectorX legs = VectorX::Zero(nao.num_dofs());
  HangLimbs(nao, VectorX::Constant(nao.num_dofs(), kNotGiven), legs);
  for (const Leg& leg : nao.legs) {
    for (const int joint : leg.joints) EXPECT_EQ(legs[nao.joints[static_cast<std::size_t>(joint)].dof], 0.0);
  }
}

}  // namespace
}  // namespace gaitwright
