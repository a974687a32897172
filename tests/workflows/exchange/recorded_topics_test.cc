// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "tests/workflows/exchange/recorded_walk.h"
#include "workflows/exchange/packed_bytes_internal.h"
#include "workflows/exchange/recorded_topics_internal.h"

namespace gaitwright {
namespace {

using namespace synthetic;

const JointStateMessage kHip{0, {"FR_hip_joint"}, {0.1}, {}, {}}, kGripper{0, {"gripper"}, {0.1}, {}, {}};
const JointTrajectoryMessage kHipPath{0, {"FR_hip_joint"}, {}};

RecordedTopics TopicsIn(const std::string& file) {
  RecordedTopics topics;
  ReadRecording(file, topics);
  return topics;
}

/// What is chosen, "joint states|trajectory|odometry", or why nothing is.
std::string ChosenIn(const RecordedTopics& topics, const std::string& asked = "detect") {
  try {
    const ChosenTopics chosen = ChooseTopics(NamedRobot("a1"), topics, asked);
    return chosen.joint_states + "|" + chosen.trajectory + "|" + chosen.odometry;
  } catch (const InvalidArgument& error) {
    return error.what();
  }
}

TEST(RecordedTopics, CollectMessagesByTopic) {
  Recorder recorder;
  recorder.Add("/a", kJointStateType, 5, kHip);
  recorder.Add("/b", kOdometryType, 6, OdometryMessage{});
  recorder.Add("/a", kJointStateType, 7, kGripper);
  recorder.Add("/c", kJointTrajectoryType, 8, kHipPath);
  const RecordedTopics topics = TopicsIn(recorder.Finish());
  ASSERT_EQ(topics.joint_states.size(), 1U);
  EXPECT_EQ(topics.joint_states.at("/a").messages, (std::vector{kHip, kGripper}));
  EXPECT_EQ(topics.joint_states.at("/a").log_time_ns, (std::vector<std::int64_t>{5, 7}));
  EXPECT_EQ(topics.odometry.count("/b") + topics.trajectories.count("/c"), 2U);
  EXPECT_TRUE(topics.whole && topics.others.empty());
}

TEST(RecordedTopics, TypesMayLackTheFolder) {
  const std::string file = McapHead() + SchemaRecord(1, "sensor_msgs/JointState") + ChannelRecord(1, 1, "/a") +
                           MessageRecord(1, 5, CdrOf(kHip));
  EXPECT_EQ(TopicsIn(file).joint_states.count("/a"), 1U);
  EXPECT_FALSE(TopicsIn(file).whole) << "no end";
}

TEST(RecordedTopics, UnpackMessagesOneByOne) {
  const auto read = [](const std::string& data) {
    return TopicsIn(McapHead() + SchemaRecord(1, kJointStateType) + ChannelRecord(1, 1, "/a") +
                    MessageRecord(1, 5, CdrOf(kHip)) + MessageRecord(1, 6, data));
  };
  EXPECT_EQ(read(PackedZstd(CdrOf(kGripper))).joint_states.at("/a").messages, (std::vector{kHip, kGripper}));
  const std::string cut = PackedZstd(CdrOf(kGripper)).substr(0, 20);
  EXPECT_NE(WhatOf<InvalidArgument>([&] { read(cut); }).find("message 2 of topic '/a': its zstd data are damaged"),
            std::string::npos);
}

TEST(RecordedTopics, RefuseOtherEncodingsAndNameTheMessage) {
  const auto why = [](const std::string& encoding, const std::string& data) {
    return WhatOf<InvalidArgument>([&] {
      TopicsIn(McapHead() + SchemaRecord(1, kJointStateType) + ChannelRecord(1, 1, "/a", encoding) +
               MessageRecord(1, 5, CdrOf(kHip)) + MessageRecord(1, 5, data));
    });
  };
  EXPECT_NE(why("ros1", "").find("topic '/a' is encoded as 'ros1'; accepted: 'cdr'"), std::string::npos);
  EXPECT_NE(why("cdr", "ab").find("message 2 of topic '/a': it has 2 bytes"), std::string::npos);
}

TEST(RecordedTopics, JointsOfTheRobotDecide) {
  Recorder recorder;
  recorder.Add("/gripper", kJointStateType, 1, kGripper);
  recorder.Add("/joint_states", kJointStateType, 1, kHip);
  recorder.Add("/path", kJointTrajectoryType, 1, kHipPath);
  RecordedTopics topics = TopicsIn(recorder.Finish());
  EXPECT_EQ(ChosenIn(topics), "/joint_states||") << "states go before trajectories";
  EXPECT_EQ(ChosenIn(topics, "/path"), "|/path|");
  topics.odometry["/odom"].messages.resize(1);
  topics.joint_states.erase("/joint_states");
  EXPECT_EQ(ChosenIn(topics), "|/path|/odom");
  topics.trajectories.clear();
  EXPECT_EQ(ChosenIn(topics),
            "no topic has joint states or a joint trajectory with joints of robot 'a1'; its topics are '/gripper "
            "(sensor_msgs/msg/JointState)', '/odom (nav_msgs/msg/Odometry)'");
}

TEST(RecordedTopics, SeveralAreAskedFor) {
  RecordedTopics topics;
  topics.joint_states["/measured"].messages = topics.joint_states["/wanted"].messages = {kHip};
  topics.odometry["/a"].messages.resize(1), topics.odometry["/b"].messages.resize(1);
  topics.others["/camera"] = "sensor_msgs/msg/Image";
  EXPECT_EQ(ChosenIn(topics), "topics '/measured', '/wanted' have joint states; give the one to read with --topic");
  EXPECT_EQ(ChosenIn(topics, "/wanted"), "topics '/a', '/b' have odometry; give the one to read with --topic");
  EXPECT_EQ(ChosenIn(topics, "/b,/wanted"), "/wanted||/b");
  EXPECT_NE(ChosenIn(topics, "/wantd,/b").find("topic '/wantd' does not exist"), std::string::npos);
  EXPECT_NE(ChosenIn(topics, "/wantd").find("'/wanted'"), std::string::npos) << "the nearest";
  EXPECT_NE(ChosenIn(topics, "/camera").find("has messages of type 'sensor_msgs/msg/Image'; accepted"),
            std::string::npos);
}

}  // namespace
}  // namespace gaitwright
