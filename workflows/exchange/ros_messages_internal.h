// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

inline constexpr const char* kJointStateType = "sensor_msgs/msg/JointState";
inline constexpr const char* kOdometryType = "nav_msgs/msg/Odometry";
inline constexpr const char* kJointTrajectoryType = "trajectory_msgs/msg/JointTrajectory";

/// sensor_msgs/JointState. Each list of numbers is empty or has a number for each name.
struct JointStateMessage {
  std::int64_t stamp_ns = 0;  ///< 0: not set
  std::vector<std::string> names;
  std::vector<double> positions, velocities, efforts;

  bool operator==(const JointStateMessage&) const = default;
};

/// nav_msgs/Odometry without covariances.
///
/// = Notation =
///   C  the child frame        v_WC, w_WC  of C in W, in the axes of C
struct OdometryMessage {
  std::int64_t stamp_ns = 0;
  std::string frame, child_frame;
  Vector3 p_WC = Vector3::Zero();
  Eigen::Vector4d turn = Eigen::Vector4d::Zero();  ///< quaternion of R_WC, x y z w
  Vector3 v_WC = Vector3::Zero(), w_WC = Vector3::Zero();

  bool operator==(const OdometryMessage&) const = default;
};

/// trajectory_msgs/JointTrajectory.
struct JointTrajectoryMessage {
  struct Point {
    std::vector<double> positions, velocities, accelerations, efforts;
    std::int64_t from_start_ns = 0;

    bool operator==(const Point&) const = default;
  };
  std::int64_t stamp_ns = 0;
  std::vector<std::string> names;
  std::vector<Point> points;

  bool operator==(const JointTrajectoryMessage&) const = default;
};

/// Read a message in CDR. @throws InvalidArgument for a message that is too short, and for lists of numbers with
/// another length than that of the names.
JointStateMessage ParseJointState(std::string_view cdr);
OdometryMessage ParseOdometry(std::string_view cdr);
JointTrajectoryMessage ParseRosTrajectory(std::string_view cdr);

/// The message in CDR.
std::string CdrOf(const JointStateMessage& message);
std::string CdrOf(const OdometryMessage& message);
std::string CdrOf(const JointTrajectoryMessage& message);

/// Definition of a type and of the types that it uses, in the form of "ros2msg". @pre one of the three types above.
std::string RosSchema(const std::string& type);

}  // namespace gaitwright
