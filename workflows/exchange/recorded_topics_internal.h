// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "workflows/exchange/mcap_file_internal.h"
#include "workflows/exchange/ros_messages_internal.h"

namespace gaitwright {

/// Messages with the times at which they were recorded, in the order of the file.
template <class Message>
struct RecordedSeries {
  std::vector<Message> messages;
  std::vector<std::int64_t> log_time_ns;
};

/// The messages of a recording that describe a motion, by topic, and its other topics.
struct RecordedTopics {
  std::map<std::string, RecordedSeries<JointStateMessage>> joint_states;
  std::map<std::string, RecordedSeries<OdometryMessage>> odometry;
  std::map<std::string, RecordedSeries<JointTrajectoryMessage>> trajectories;
  std::map<std::string, std::string> others;  ///< type, by topic
  bool whole = true;                          ///< false if a file of the recording was not ended
};

/// Adds the messages of a file: MCAP, or a database of SQLite as ROS 2 writes it. @throws InvalidArgument with the
/// topic and the number of the message.
void ReadRecording(const std::string& bytes, RecordedTopics& topics);

/// The topics that give the motion; "" for none.
struct ChosenTopics {
  std::string joint_states, trajectory, odometry;
};

/// Chooses joint states, or else a trajectory, that have joints of the robot, and odometry if there is any.
/// @param asked  names of topics separated by commas, which go before all others of their type; or "detect".
/// @throws InvalidArgument if several topics are possible, if none is, and for an unknown name.
ChosenTopics ChooseTopics(const RobotModel& model, const RecordedTopics& topics, const std::string& asked);

}  // namespace gaitwright
