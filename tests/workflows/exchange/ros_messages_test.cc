// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "workflows/exchange/ros_messages_internal.h"

namespace gaitwright {
namespace {

using synthetic::WhatOf;

JointStateMessage SomeState() { return {1'500'000'000, {"hip", "knee"}, {0.5, -1.25}, {0.0, 2.0}, {}}; }

OdometryMessage SomeOdometry() {
  OdometryMessage message;
  message.stamp_ns = -1;
  message.frame = "odom";
  message.child_frame = "base_link";
  message.p_WC = {1.0, 2.0, 3.0};
  message.turn = {0.0, 0.6, 0.0, 0.8};
  message.v_WC = {4.0, 5.0, 6.0};
  message.w_WC = {7.0, 8.0, 9.0};
  return message;
}

JointTrajectoryMessage SomeTrajectory() {
  return {7, {"a"}, {{{1.0}, {}, {}, {2.0}, 0}, {{3.0}, {4.0}, {5.0}, {}, 2'000'000'001}}};
}

TEST(RosMessages, ReadBackWhatWasWritten) {
  EXPECT_EQ(ParseJointState(CdrOf(SomeState())), SomeState());
  EXPECT_EQ(ParseOdometry(CdrOf(SomeOdometry())), SomeOdometry());
  EXPECT_EQ(ParseRosTrajectory(CdrOf(SomeTrajectory())), SomeTrajectory());
}

TEST(RosMessages, HaveTheLayoutOfTheirTypes) {
  const std::string state = CdrOf(SomeState());
  // Head, stamp, an empty frame with padding, two names with padding, and three lists.
  EXPECT_EQ(state.substr(0, 12), std::string("\0\1\0\0\1\0\0\0\0\x65\xcd\x1d", 12));
  EXPECT_EQ(state.size(), 4U + 8U + 5U + 3U + 4U + 8U + 9U + 3U + 4U + 4U + 16U + 4U + 4U + 16U + 4U);
  EXPECT_EQ(CdrOf(SomeOdometry()).size(), 4U + 8U + 9U + 3U + 14U + 6U + 56U + 288U + 48U + 288U);
}

TEST(RosMessages, RefuseListsThatDoNotFit) {
  JointStateMessage state = SomeState();
  state.velocities = {1.0};
  EXPECT_EQ(WhatOf<InvalidArgument>([&] { ParseJointState(CdrOf(state)); }), "it has 1 velocities, but 2 names");
  JointTrajectoryMessage trajectory = SomeTrajectory();
  trajectory.points[1].positions = {1.0, 2.0};
  EXPECT_THROW(ParseRosTrajectory(CdrOf(trajectory)), InvalidArgument);
  const std::string bytes = CdrOf(SomeOdometry());
  for (std::size_t size = 0; size < bytes.size(); size += 7)
    EXPECT_THROW(ParseOdometry(bytes.substr(0, size)), InvalidArgument) << size;
  state = SomeState();
  state.stamp_ns = std::int64_t{1} << 62;
  EXPECT_THROW(CdrOf(state), InvalidArgument) << "seconds have 32 bits";
}

TEST(RosMessages, SchemasHoldAllTypesThatTheyUse) {
  EXPECT_EQ(RosSchema(kJointStateType),
            "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n" +
                std::string(80, '=') + "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" +
                std::string(80, '=') + "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n");
  const std::string odometry = RosSchema(kOdometryType);
  for (const char* const type :
       {"PoseWithCovariance", "Pose", "Point", "Quaternion", "TwistWithCovariance", "Twist", "Vector3"}) {
    const std::string head = std::string("MSG: geometry_msgs/") + type + "\n";
    EXPECT_NE(odometry.find(head), std::string::npos) << type;
    EXPECT_EQ(odometry.find(head), odometry.rfind(head)) << type;
  }
  EXPECT_NE(RosSchema(kJointTrajectoryType).find("MSG: builtin_interfaces/Duration\n"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
