// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/robot_model.h"

#include <limits>

#include "kinematics/base/result.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// A leader with limits of -1 to 2, and a follower with the given multiplier, offset and limits.
RobotModel LeaderAndFollower(double multiplier, double offset, double lower, double upper) {
  RobotModel model;
  model.name = "made";
  Joint leader, follower;
  leader.name = "lead";
  leader.lower = -1.0;
  leader.upper = 2.0;
  leader.velocity_limit = 4.0;
  leader.effort_limit = 30.0;
  follower = leader;
  follower.name = "follow";
  follower.is_mimic = true;
  follower.multiplier = multiplier;
  follower.offset = offset;
  follower.lower = lower;
  follower.upper = upper;
  model.joints = {leader, follower};
  model.dof_names = {"lead"};
  model.dof_joint = {0};
  return model;
}

TEST(RobotModel, ACoordinateHasTheTightestLimitsOfAllJointsThatItMoves) {
  const RobotModel same = LeaderAndFollower(2.0, 0.5, -1.0, 2.0);  // -0.75 to 0.75
  EXPECT_EQ(same.dof_lower(0), -0.75);
  EXPECT_EQ(same.dof_upper(0), 0.75);
  EXPECT_EQ(same.dof_velocity_limit(0), 2.0);
  const RobotModel wide = LeaderAndFollower(0.5, 0.0, -1.0, 1.0);
  EXPECT_EQ(wide.dof_lower(0), -1.0);
  EXPECT_EQ(wide.dof_upper(0), 2.0);
  EXPECT_EQ(wide.dof_velocity_limit(0), 4.0);
}

TEST(RobotModel, AReversedFollowerSwapsItsLimits) {
  const RobotModel model = LeaderAndFollower(-2.0, 1.0, -1.0, 2.0);  // 1 - 2 q within -1 to 2: -0.5 to 1
  EXPECT_EQ(model.dof_lower(0), -0.5);
  EXPECT_EQ(model.dof_upper(0), 1.0);
  EXPECT_EQ(model.dof_velocity_limit(0), 2.0);
}

TEST(RobotModel, PlaceholdersLimitNothing) {
  RobotModel model = LeaderAndFollower(2.0, 0.0, -kUnlimited, kUnlimited);
  model.joints[1].velocity_limit_is_placeholder = true;
  EXPECT_EQ(model.dof_velocity_limit(0), 4.0);
  EXPECT_EQ(model.dof_lower(0), -1.0);
  EXPECT_EQ(model.dof_effort_limit(0), 30.0);
  model.joints[0].effort_limit_is_placeholder = model.joints[0].velocity_limit_is_placeholder = true;
  EXPECT_EQ(model.dof_velocity_limit(0), kUnlimited);
  EXPECT_EQ(model.dof_effort_limit(0), kUnlimited);
}

TEST(RobotModel, NamesLeadToIndicesAndBack) {
  const Result<RobotModel> model = LoadRobotFromText(FourLegs(), "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  for (int d = 0; d < model->num_dofs(); ++d) {
    const std::string& name = model->dof_names[static_cast<std::size_t>(d)];
    EXPECT_EQ(model->DofIndex(name), d);
    EXPECT_EQ(model->LeaderOf(d).name, name);
    EXPECT_EQ(model->TransmissionOf(d), nullptr);
  }
  for (std::size_t f = 0; f < model->frames.size(); ++f)
    EXPECT_EQ(model->FrameIndex(model->frames[f].name), static_cast<int>(f));
  EXPECT_EQ(model->nq(), 7 + 8);
  EXPECT_EQ(model->nv(), 6 + 8);
  EXPECT_NEAR(model->weight_n(), 13.0 * kGravity, 1e-9);
  EXPECT_NEAR(model->leg_length_m(), 0.42, 0.021);
}

TEST(RobotModel, UnknownNamesAreRefusedWithTheNearest) {
  const RobotModel model = LeaderAndFollower(1.0, 0.0, 0.0, 0.0);
  const auto message = [&](auto call) -> std::string {
    try {
      call();
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  ExpectSays(message([&] { model.DofIndex("leed"); }), {"'made'", "'leed'", "'lead'"});
  ExpectSays(message([&] { model.DofIndex("follow"); }), {"no moving joint 'follow'"});
  ExpectSays(message([&] { model.FrameIndex("base"); }), {"no link 'base'"});
}

TEST(RobotModel, WithoutMotorsAMotorHasNoLimits) {
  RobotModel model = LeaderAndFollower(1.0, 0.0, -1.0, 1.0);
  EXPECT_FALSE(model.MotorOf(0).has_curve());
  EXPECT_EQ(model.MotorOf(0).continuous_effort, kUnlimited);
  model.motors.resize(1);
  model.motors[0].rotor_inertia = 0.5;
  EXPECT_EQ(model.MotorOf(0).rotor_inertia, 0.5);
}

TEST(StandingConfiguration, IsUprightAtItsHeight) {
  RobotModel model = LeaderAndFollower(1.0, 0.0, -1.0, 1.0);
  model.standing_joints = VectorX::Constant(1, 0.25);
  model.standing_base_height_m = 0.7;
  const VectorX q = StandingConfiguration(model);
  ASSERT_EQ(q.size(), 8);
  EXPECT_EQ(q.head<3>(), Vector3(0.0, 0.0, 0.7));
  EXPECT_EQ(BaseRotation(q), Matrix3::Identity());
  EXPECT_EQ(q[7], 0.25);
}

TEST(BaseRotation, TakesTheQuaternionAsXyzwOfAnyLength) {
  VectorX q = VectorX::Zero(7);
  q.segment<4>(3) << 0.0, 0.0, 3.0, 3.0;  // a right angle about z
  Matrix3 R;
  R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_LT((BaseRotation(q) - R).norm(), 1e-12);
}

}  // namespace
}  // namespace gaitwright
