// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/gains.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "playback/bullet/bullet_world.h"
#include "tests/playback/standing_plan.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

TEST(Gains, FollowTheStatedRule) {
  const RobotModel model = standing::Load("a1");
  RobotModel plain = model;
  plain.stiffness.setZero();
  plain.damping.setZero();
  GainOptions options;
  options.stance_frequency = 3.0;
  options.stance_damping = 0.2;
  const Gains gains = DeriveGains(plain, options);
  const double length = model.legs[0].length_m;
  const double inertia = model.total_mass_kg / 4.0 * length * length, w = 3.0 * std::sqrt(kGravity / length);
  EXPECT_NEAR(gains.stiffness[0], inertia * w * w, 1e-9);
  EXPECT_NEAR(gains.damping[0], 0.4 * inertia * w, 1e-9);
}

/// An upright arm of two links on a trunk falls over if gravity turns its joints by more than their gains hold.
TEST(Gains, HoldWhatStandsUpright) {
  unusual::UrdfText urdf;
  urdf.Link("body", 8.0, 0.4, urdf.Block(0.4, 0.2, 0.1));
  for (const unusual::Hip& hip : unusual::Four()) unusual::MammalLeg(urdf, hip, unusual::Abduction(), unusual::Knee());
  urdf.Link("arm", 0.01, 0.01);
  urdf.Link("forearm", 0.01, 0.01);
  urdf.Link("hand", 1.0, 0.02);
  urdf.Joint("body", "arm", {0.1, 0.0, 0.05}, {});
  urdf.Joint("arm", "forearm", {0.0, 0.0, 0.3}, {});
  urdf.Joint("forearm", "hand", {0.0, 0.0, 0.3}, {.type = "fixed"});
  const RobotModel model =
      LoadRobotFromText(urdf.Done("upright"), "standing: {arm_joint: 0, forearm_joint: 0}").value();
  const Gains gains = DeriveGains(model);
  EXPECT_GT(gains.stiffness[model.DofIndex("arm_joint")], 3.0 * kGravity * 0.6);
  EXPECT_GT(gains.stiffness[model.DofIndex("forearm_joint")], 3.0 * kGravity * 0.3);
}

TEST(Gains, OfTheRobotTakePrecedence) {
  RobotModel model = standing::Load("a1");
  model.stiffness.setZero();
  model.stiffness[2] = 42.0;
  model.damping[2] = 1.5;
  const Gains gains = DeriveGains(model);
  EXPECT_EQ(gains.stiffness[2], 42.0);
  EXPECT_EQ(gains.damping[2], 1.5);
  EXPECT_NE(gains.stiffness[1], 42.0);
}

TEST(Gains, JointsOutsideLegsAreSofter) {
  const RobotModel model = standing::Load("nao");
  const Gains gains = DeriveGains(model);
  EXPECT_LT(gains.stiffness[model.DofIndex("HeadYaw")], gains.stiffness[model.DofIndex("LKneePitch")]);
  EXPECT_GT(gains.stiffness.minCoeff(), 0.0);
  EXPECT_GT(gains.damping.minCoeff(), 0.0);
}

TEST(Gains, BoundedOnesAreStableExplicitlyInTheAir) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = standing::Load(name);
    GainOptions options;
    options.explicit_step_s = 1e-3;
    const Gains gains = DeriveGains(model, options);
    WorldOptions explicit_torque;
    explicit_torque.actuation = "torque";
    VectorX q = StandingConfiguration(model);
    q[2] += 2.0;
    BulletWorld world(model, FlatTerrain(), q, explicit_torque);
    const VectorX zero = VectorX::Zero(model.num_dofs());
    VectorX v = VectorX::Zero(model.nv());
    v.tail(model.num_dofs()).setConstant(0.1);
    world.SetState(q, v);
    for (int k = 0; k < 500; ++k) world.Step({model.standing_joints, zero, zero, gains.stiffness, gains.damping});
    EXPECT_LT(world.v().tail(model.num_dofs()).norm(), 0.2) << name;
  }
}

}  // namespace
}  // namespace gaitwright
