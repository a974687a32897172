// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/recording_readers.h"

#include <fmt/format.h>

#include "kinematics/base/strict_yaml_internal.h"
#include "tests/fuzz/inputs.h"
#include "tests/fuzz/motion_laws.h"
#include "tests/workflows/exchange/bvh_text.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "workflows/exchange/bvh_motion_internal.h"
#include "workflows/exchange/contact_plan_internal.h"
#include "workflows/exchange/deepmimic_motion_internal.h"
#include "workflows/exchange/export_mcap_internal.h"
#include "workflows/exchange/footstep_file.h"
#include "workflows/exchange/recorded_motion_internal.h"
#include "workflows/exchange/ros_messages_internal.h"
#include "workflows/walk/walk.h"

namespace gaitwright::fuzz {
namespace {

Verdict ReadRecordedMotion(const std::string& input) {
  const std::string file = InFile(input, ".mcap");
  return CheckMotion(ParseRecordedMotion(Quadruped(), input, {}, "input", {}), file);
}

/// The standing robot in messages outside of chunks, so that mutations reach their contents.
std::string OpenRecording() {
  using namespace synthetic;
  std::string bytes = McapHead() + SchemaRecord(1, kJointStateType) + ChannelRecord(1, 1, "/joint_states") +
                      SchemaRecord(2, kOdometryType) + ChannelRecord(2, 2, "/odom");
  const VectorX& joints = Quadruped().standing_joints;
  for (int k = 0; k < 6; ++k) {
    const std::int64_t time_ns = 20'000'000 * (k + 1);
    const JointStateMessage state{
        time_ns, Quadruped().dof_names, {joints.begin(), joints.end()}, std::vector<double>(12, 0.0), {}};
    OdometryMessage pose;
    pose.stamp_ns = time_ns;
    pose.child_frame = "trunk";
    pose.p_WC.z() = Quadruped().standing_base_height_m;
    pose.turn = {0.0, 0.0, 0.0, 1.0};
    bytes += MessageRecord(1, static_cast<std::uint64_t>(time_ns), CdrOf(state)) +
             MessageRecord(2, static_cast<std::uint64_t>(time_ns), CdrOf(pose));
  }
  return bytes + McapTail();
}

std::vector<std::string> MadeRecordings() {
  MotionRows rows;
  for (int k = 0; k < 6; ++k) {
    rows.time_s.push_back(0.02 * k);
    rows.q.push_back(StandingConfiguration(Quadruped()));
    rows.v.push_back(VectorX::Zero(Quadruped().nv()));
  }
  return {OpenRecording(), MotionMcap(Quadruped(), rows)};
}

std::vector<VectorX> StandingMotion() { return std::vector<VectorX>(6, StandingConfiguration(Quadruped())); }

Verdict ReadBvh(const std::string& input) {
  const std::string file = InFile(input, ".bvh");
  return CheckMotion(ParseBvhMotion(Quadruped(), input, "input", {}), file);
}

std::vector<std::string> MadeBvhs() { return {synthetic::SkeletonOf(Quadruped(), false).Text(StandingMotion(), 0.02)}; }

Verdict ReadDeepMimic(const std::string& input) {
  const std::string file = InFile(input, ".json");
  return CheckMotion(ParseDeepMimic(Quadruped(), input, "input", {}), file);
}

std::vector<std::string> MadeDeepMimics() {
  std::string frame = fmt::format("[0.02, 0, 0, {}, 1, 0, 0, 0", Quadruped().standing_base_height_m);
  for (const double q : Quadruped().standing_joints) frame += fmt::format(", {}", q);
  std::string text = "{\"Loop\": \"none\", \"Frames\": [";
  for (int k = 0; k < 6; ++k) text += (k == 0 ? "" : ",\n") + frame + "]";
  return {text + "]}\n"};
}

const RobotModel& Humanoid() {
  static const RobotModel model = *ChooseRobot("h1", "");
  return model;
}

Verdict ReadContactPlan(const std::string& input) {
  std::vector<std::string> unused;
  std::string steps;
  try {
    steps = FootstepsOfContactPlan(Humanoid(), input, unused);
  } catch (const InvalidArgument&) {
    return Verdict::kRefused;
  } catch (const YAML::Exception&) {
    return Verdict::kRefused;
  }
  const Result<FootstepSkeleton> skeleton = ReadFootsteps(Humanoid(), FlatTerrain(), steps, "input", 0.005);
  if (!skeleton) return Verdict::kRefused;
  Require(skeleton->footsteps.footholds.size() > 2, "a plan of contacts has steps");
  return Verdict::kAccepted;
}

std::vector<std::string> MadeContactPlans() {
  return {
      "single_support_duration: 0.8\ndouble_support_duration: 0.2\ncontacts:\n"
      "- {pose: {translation: [0, -0.1, 0]}, surface: RightFootCenter}\n"
      "- {pose: {translation: [0, 0.1, 0], rotation: [1, 0, 0, 0]}, surface: LeftFootCenter}\n"
      "- {pose: {translation: [0.1, -0.1, 0], rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1]}, surface: RightFootCenter}\n"};
}

}  // namespace

std::vector<Reader> RecordingReaders() {
  return {{"recording",
           ReadRecordedMotion,
           {"\x89MCAP0\r\n", "SQLite format 3", "zstd", "lz4", "cdr", "sensor_msgs/msg/JointState",
            "nav_msgs/msg/Odometry", "trajectory_msgs/msg/JointTrajectory"},
           {},
           MadeRecordings,
           500},
          {"bvh",
           ReadBvh,
           {"HIERARCHY", "ROOT", "JOINT", "End Site", "OFFSET", "CHANNELS", "Xposition", "Zrotation", "MOTION",
            "Frames:", "Frame Time:", "{", "}", "1e308", "nan", "-1"},
           {},
           MadeBvhs,
           500},
          {"deepmimic",
           ReadDeepMimic,
           {"null", "{}", "[]", "-1", "1e400", "\"Frames\"", "\"Loop\"", "\"FrameDuration\"", "\\u0000"},
           {},
           MadeDeepMimics,
           500},
          {"contact_plan",
           ReadContactPlan,
           {"contacts", "plans", "pose", "translation", "rotation", "surface", "LeftFootCenter", "RightFootCenter",
            "single_support_duration", "init_dsp_duration", "&a", "*a", "{", "}", "[", "]", ": ", ".nan", "1e400"},
           {},
           MadeContactPlans,
           500}};
}

}  // namespace gaitwright::fuzz
