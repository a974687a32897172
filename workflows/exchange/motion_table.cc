// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_table.h"

#include <fmt/format.h>

#include <utility>

#include "kinematics/base/result.h"

namespace gaitwright {

constexpr double kFinestGrid = 0.0005, kCoarsestGrid = 0.01;  // [s]

double ImportOptions::time_unit_s() const {
  if (time_unit == "ms") return 1e-3;
  if (time_unit == "us") return 1e-6;
  return time_unit == "ns" ? 1e-9 : 1.0;
}

OptionFields ImportOptions::UnitFields() {
  return {
      {"quaternion_order",
       &quaternion_order,
       "",
       0.0,
       0.0,
       "Order of the base's quaternion columns; detect uses their names and checks them against the motion.",
       {"detect", "xyzw", "wxyz"}},
      {"angle_unit",
       &angle_unit,
       "",
       0.0,
       0.0,
       "Unit of angle columns that end in _rad or name no unit, and of their rates; detect assumes rad and checks it "
       "against the motion.",
       {"detect", "rad", "deg"}},
      {"length_unit",
       &length_unit,
       "",
       0.0,
       0.0,
       "Unit of lengths and their rates; detect assumes m and checks it against the motion.",
       {"detect", "m", "mm"}},
      {"time_unit",
       &time_unit,
       "",
       0.0,
       0.0,
       "Unit of times; detect assumes s and checks it against the motion. Rates are always per second.",
       {"detect", "s", "ms", "us", "ns"}}};
}

const char* MotionFormatName(MotionFormat format) {
  switch (format) {
    case MotionFormat::kCsv:
      return "csv";
    case MotionFormat::kOcs2Csv:
      return "ocs2-csv";
    case MotionFormat::kJointTrajectory:
      return "joint-trajectory";
    case MotionFormat::kFramesCsv:
      return "frames-csv";
    case MotionFormat::kFramesJson:
      return "frames-json";
    case MotionFormat::kFramesNpz:
      return "frames-npz";
    case MotionFormat::kFramesBvh:
      return "frames-bvh";
    case MotionFormat::kFramesDeepMimic:
      return "frames-deepmimic";
    case MotionFormat::kNpz:
      return "npz";
    case MotionFormat::kRosBag:
      return "ros-bag";
    case MotionFormat::kRosBagTrajectory:
      return "ros-bag-trajectory";
    case MotionFormat::kFootsteps:
      return "footsteps";
    case MotionFormat::kRepaired:
      return "repaired";
  }
  return "";
}

bool HasFrames(MotionFormat format) {
  return format == MotionFormat::kFramesCsv || format == MotionFormat::kFramesJson ||
         format == MotionFormat::kFramesNpz || format == MotionFormat::kFramesBvh ||
         format == MotionFormat::kFramesDeepMimic;
}

bool HasWaypoints(MotionFormat format) {
  return format == MotionFormat::kJointTrajectory || format == MotionFormat::kRosBagTrajectory;
}

OptionFields ImportOptions::Fields() {
  OptionFields fields = {
      {"velocities",
       &velocities,
       "",
       0.0,
       0.0,
       "Joint velocities: taken from the file (given) or differentiated from the positions (derived).",
       {"given", "derived"}},
      {"missing_joints",
       &missing_joints,
       "",
       0.0,
       0.0,
       "Joints that the file lacks: an error (refuse), or held in the standing posture (standing).",
       {"refuse", "standing"}},
      {"topics", &topics, "", 0.0, 0.0,
       "Topics of a recording to read, separated by commas; detect reads the only topic with joints of this robot and "
       "the only one of odometry."},
      {"rate_hz", &rate_hz, "Hz", 1.0, 10000.0,
       "Frames per second of a file that states neither times nor a frame rate."},
      {"grid_step_s", &grid_step_s, "s", 0.0, kCoarsestGrid,
       "Time step of the plan's uniform grid, at least 0.0005; 0 uses the file's step if it is uniform and 1 to 10 ms, "
       "otherwise 5 ms."},
      {"smoothing_hz", &smoothing_hz, "Hz", 0.0, 1000.0,
       "Cut-off frequency for smoothing positions before differentiation; 0: a fifth of the frame rate for data sets "
       "and "
       "skeletons with frames over 10 ms apart, otherwise none."},
      {"lift_m", &lift_m, "m", -10.0, 10.0, "Height added to the base."},
      {"contact_height", &contact_height, "1", 0.0, 0.5,
       "Largest height of a stance foot above the ground, as a share of the leg length; unused if the file has contact "
       "columns."},
      {"contact_speed", &contact_speed, "1", 0.0, 10.0,
       "Largest speed of a stance foot, as a share of sqrt(g x leg length); unused if the file has contact columns."},
      {"contact_least_s", &contact_least_s, "s", 0.0, 1.0,
       "Shortest contact, and shortest gap between contacts; shorter ones are ignored."},
      {"load_ramp_s", &load_ramp_s, "s", 0.0, 1.0,
       "Longest time over which the load of a foot rises after touch-down and falls before lift-off."},
      {"friction_use", &friction_use, "1", 0.05, 1.0,
       "Share of the friction coefficient that computed contact forces may use."}};
  fields = WithBasics({"velocities", "missing_joints", "topics", "rate_hz", "smoothing_hz", "lift_m", "contact_height"},
                      std::move(fields));
  return Joined({UnitFields(), std::move(fields)});
}

void CheckImportOptions(ImportOptions options) {
  CheckOptions(options.Fields());
  if (options.grid_step_s == 0.0 || options.grid_step_s >= kFinestGrid) return;
  throw InvalidArgument(fmt::format("option 'grid_step_s' is {} s; accepted: 0, and {} to {}", options.grid_step_s,
                                    kFinestGrid, kCoarsestGrid));
}

}  // namespace gaitwright
