// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/ball_joints.h"

#include <gtest/gtest.h>

#include "kinematics/dynamics/dynamics.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

/// Four legs whose first hip, A_hip, is a ball.
std::string WithBallHip(const std::string& extra = "") {
  const std::string hip = PitchJoint("A_hip", "trunk", "A_thigh", "0.2 0.1 0");
  return Replaced(FourLegs(), hip,
                  "<joint name='A_hip' type='spherical'><parent link='trunk'/><child link='A_thigh'/><origin xyz='0.2 "
                  "0.1 0' rpy='0.1 0.2 0.3'/>" +
                      extra + "</joint>");
}

TEST(BallJoints, ThreeTurnsDoWhatABallDoes) {
  const RobotModel model = LoadRobotFromText(WithBallHip(), "").value();
  VectorX q = StandingConfiguration(model);
  const Vector3 turns(0.4, -0.7, 1.1);
  for (int i = 0; i < 3; ++i) q[7 + model.DofIndex(std::string("A_hip_") + "xyz"[i])] = turns[i];
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  const auto thigh = static_cast<std::size_t>(model.frames[static_cast<std::size_t>(model.FrameIndex("A_thigh"))].body);
  const auto about = [](double angle, const Vector3& axis) {
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  };
  const Matrix3 fixed = about(0.3, Vector3::UnitZ()) * about(0.2, Vector3::UnitY()) * about(0.1, Vector3::UnitX());
  const Matrix3 ball =
      about(turns.x(), Vector3::UnitX()) * about(turns.y(), Vector3::UnitY()) * about(turns.z(), Vector3::UnitZ());
  EXPECT_LT((scratch.R_WB[thigh] - BaseRotation(q) * fixed * ball).norm(), 1e-12);
  EXPECT_LT((scratch.p_WB[thigh] - q.head<3>() - BaseRotation(q) * Vector3(0.2, 0.1, 0.0)).norm(), 1e-12);
  EXPECT_EQ(model.num_dofs(), 10);
}

TEST(BallJoints, AUrdfWithoutThemStaysAsItIs) { EXPECT_EQ(WithoutBallJoints(FourLegs()), FourLegs()); }

TEST(BallJoints, KeepWhatIsKnownOfEffortAndSpeed) {
  const RobotModel model = LoadRobotFromText(WithBallHip("<limit effort='40' velocity='9'/>"), "").value();
  for (const char* name : {"A_hip_x", "A_hip_y", "A_hip_z"}) {
    const Joint& joint = model.LeaderOf(model.DofIndex(name));
    EXPECT_EQ(joint.type, JointType::kContinuous);
    EXPECT_EQ(joint.effort_limit, 40.0);
    EXPECT_EQ(joint.velocity_limit, 9.0);
  }
}

TEST(BallJoints, WhatTheyCannotBeIsRefused) {
  ExpectSays(MessageOf(WithBallHip("<mimic joint='B_hip'/>")), {"joint 'A_hip'", "cannot mimic another joint"});
  ExpectSays(MessageOf(Replaced(WithBallHip(), "B_hip", "A_hip_y")), {"two joints have this name", "'A_hip_y'"});
  ExpectSays(MessageOf(Replaced(WithBallHip(), "<!--B_extra-->", "<mimic joint='A_hip'/>")),
             {"'A_hip', which is not a joint", "'A_hip_x'"});
  ExpectSays(MessageOf(WithBallHip("<limit effort='-1' velocity='9'/>")), {"joint 'A_hip'", "negative"});
}

}  // namespace
}  // namespace gaitwright
