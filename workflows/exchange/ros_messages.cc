// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/exchange/cdr_internal.h"
#include "workflows/exchange/ros_messages_internal.h"

namespace gaitwright {
namespace {

constexpr std::int64_t kSecondNs = 1'000'000'000;
constexpr std::size_t kCovariance = 36;

/// builtin_interfaces/Time or Duration.
std::int64_t ReadTime(CdrReader& cdr, const char* what) {
  const std::int64_t sec = cdr.Int32(), nanosec = cdr.Uint32();
  if (nanosec >= kSecondNs) throw InvalidArgument(fmt::format("its {} has {} nanoseconds", what, nanosec));
  return sec * kSecondNs + nanosec;
}

void WriteTime(std::int64_t time_ns, CdrWriter& cdr) {
  std::int64_t sec = time_ns / kSecondNs;
  if (time_ns < sec * kSecondNs) --sec;
  if (sec > INT32_MAX || sec < INT32_MIN)
    throw InvalidArgument(fmt::format("a time of {} s does not fit a time of ROS, whose seconds have 32 bits", sec));
  cdr.Int32(static_cast<std::int32_t>(sec));
  cdr.Uint32(static_cast<std::uint32_t>(time_ns - sec * kSecondNs));
}

std::vector<double> ReadList(CdrReader& cdr, const char* what, const std::vector<std::string>& names) {
  std::vector<double> numbers = cdr.Numbers();
  if (!numbers.empty() && numbers.size() != names.size())
    throw InvalidArgument(fmt::format("it has {} {}, but {} names", numbers.size(), what, names.size()));
  return numbers;
}

void WriteList(const std::vector<double>& numbers, CdrWriter& cdr) { cdr.Numbers(numbers.data(), numbers.size()); }

template <class Vector>
void ReadInto(CdrReader& cdr, Vector& values) {
  for (double& value : values) value = cdr.Number();
}

template <class Vector>
void WriteFrom(const Vector& values, CdrWriter& cdr) {
  for (const double value : values) cdr.Number(value);
}

/// Fields of the standard types, without comments.
const std::map<std::string, std::string>& Definitions() {
  static const std::map<std::string, std::string> texts = {
      {"sensor_msgs/JointState",
       "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n"},
      {"nav_msgs/Odometry",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
       "geometry_msgs/TwistWithCovariance twist\n"},
      {"trajectory_msgs/JointTrajectory",
       "std_msgs/Header header\nstring[] joint_names\ntrajectory_msgs/JointTrajectoryPoint[] points\n"},
      {"trajectory_msgs/JointTrajectoryPoint",
       "float64[] positions\nfloat64[] velocities\nfloat64[] accelerations\nfloat64[] effort\n"
       "builtin_interfaces/Duration time_from_start\n"},
      {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
      {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
      {"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec\n"},
      {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n"},
      {"geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
      {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
      {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist\nfloat64[36] covariance\n"},
      {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
      {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"}};
  return texts;
}

/// Adds the types of a definition's fields, and the types of their fields.
void AddUsedTypes(const std::string& definition, std::vector<std::string>& used) {
  for (const auto& [type, fields] : Definitions()) {
    const bool found =
        definition.find(type + ' ') != std::string::npos || definition.find(type + '[') != std::string::npos;
    if (!found || std::find(used.begin(), used.end(), type) != used.end()) continue;
    used.push_back(type);
    AddUsedTypes(fields, used);
  }
}

}  // namespace

JointStateMessage ParseJointState(std::string_view bytes) {
  CdrReader cdr(bytes);
  JointStateMessage message;
  message.stamp_ns = ReadTime(cdr, "stamp");
  cdr.Text();
  message.names = cdr.Texts();
  message.positions = ReadList(cdr, "positions", message.names);
  message.velocities = ReadList(cdr, "velocities", message.names);
  message.efforts = ReadList(cdr, "efforts", message.names);
  return message;
}

OdometryMessage ParseOdometry(std::string_view bytes) {
  CdrReader cdr(bytes);
  OdometryMessage message;
  message.stamp_ns = ReadTime(cdr, "stamp");
  message.frame = cdr.Text();
  message.child_frame = cdr.Text();
  ReadInto(cdr, message.p_WC);
  ReadInto(cdr, message.turn);
  cdr.Skip(kCovariance);
  ReadInto(cdr, message.v_WC);
  ReadInto(cdr, message.w_WC);
  cdr.Skip(kCovariance);
  return message;
}

JointTrajectoryMessage ParseRosTrajectory(std::string_view bytes) {
  constexpr std::size_t kLeastPoint = 24;  // four empty lists and a time
  CdrReader cdr(bytes);
  JointTrajectoryMessage message;
  message.stamp_ns = ReadTime(cdr, "stamp");
  cdr.Text();
  message.names = cdr.Texts();
  message.points.resize(cdr.Length(kLeastPoint));
  for (JointTrajectoryMessage::Point& point : message.points) {
    point.positions = ReadList(cdr, "positions", message.names);
    point.velocities = ReadList(cdr, "velocities", message.names);
    point.accelerations = ReadList(cdr, "accelerations", message.names);
    point.efforts = ReadList(cdr, "efforts", message.names);
    point.from_start_ns = ReadTime(cdr, "time from start");
  }
  return message;
}

std::string CdrOf(const JointStateMessage& message) {
  CdrWriter cdr;
  WriteTime(message.stamp_ns, cdr);
  cdr.Text("");
  cdr.Texts(message.names);
  for (const auto* list : {&message.positions, &message.velocities, &message.efforts}) WriteList(*list, cdr);
  return cdr.Take();
}

std::string CdrOf(const OdometryMessage& message) {
  const std::vector<double> unknown(kCovariance, 0.0);
  CdrWriter cdr;
  WriteTime(message.stamp_ns, cdr);
  cdr.Text(message.frame);
  cdr.Text(message.child_frame);
  WriteFrom(message.p_WC, cdr);
  WriteFrom(message.turn, cdr);
  WriteFrom(unknown, cdr);
  WriteFrom(message.v_WC, cdr);
  WriteFrom(message.w_WC, cdr);
  WriteFrom(unknown, cdr);
  return cdr.Take();
}

std::string CdrOf(const JointTrajectoryMessage& message) {
  CdrWriter cdr;
  WriteTime(message.stamp_ns, cdr);
  cdr.Text("");
  cdr.Texts(message.names);
  cdr.Uint32(static_cast<std::uint32_t>(message.points.size()));
  for (const JointTrajectoryMessage::Point& point : message.points) {
    for (const auto* list : {&point.positions, &point.velocities, &point.accelerations, &point.efforts})
      WriteList(*list, cdr);
    WriteTime(point.from_start_ns, cdr);
  }
  return cdr.Take();
}

std::string RosSchema(const std::string& type) {
  std::string name = type;
  name.erase(name.find("/msg/"), 4);
  std::vector<std::string> used = {name};
  AddUsedTypes(Definitions().at(name), used);
  std::string schema;
  for (const std::string& one : used) {
    if (!schema.empty()) schema += std::string(80, '=') + "\nMSG: " + one + "\n";
    schema += Definitions().at(one);
  }
  return schema;
}

}  // namespace gaitwright
