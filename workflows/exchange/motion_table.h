// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// Bounds of a motion that is imported or compared: its duration and the start of its clock [s] (a clock that counts
/// from 1970 is at 2e9), speeds, accelerations and torques derived from positions, and rows on a grid.
inline constexpr double kLongestMotion = 3600.0, kLatestStart = 1e10, kLargestDerived = 1e9;
inline constexpr int kMostGridRows = 1'000'000;

/// Data that a file does not contain and that were derived, with their source.
struct DerivedPart {
  std::string what, how;

  bool operator==(const DerivedPart&) const = default;
};

/// Format of a motion that was read.
enum class MotionFormat {
  kCsv,
  kOcs2Csv,
  kJointTrajectory,
  kFramesCsv,
  kFramesJson,
  kFramesNpz,
  kFramesBvh,
  kFramesDeepMimic,
  kNpz,
  kRosBag,
  kRosBagTrajectory,
  kFootsteps,
  kRepaired,
};
/// The name in JSON and Python, such as `frames-csv`.
const char* MotionFormatName(MotionFormat format);
/// Whether its rows are frames of positions, mostly few in a second.
bool HasFrames(MotionFormat format);
/// Whether its rows may be far apart, because a controller interpolates between them.
bool HasWaypoints(MotionFormat format);

/// A motion as in a file, in SI units and in this robot's order. An optional list is empty if the file lacks the data;
/// otherwise it has one entry per row. Rows may be at any increasing times.
struct MotionTable {
  MotionFormat format = MotionFormat::kCsv;
  std::vector<double> time_s;
  std::vector<Vector3> base_m;                ///< p_WB, of the URDF's root link
  std::vector<Eigen::Vector4d> quaternion;    ///< quaternion of R_WB, x y z w
  bool turned_by_angles = false;              ///< quaternions were computed, so their order is known
  std::vector<Vector6> base_rate;             ///< v_WB, w_WB: linear, then angular, in W [m/s, rad/s]
  std::vector<Vector6> base_acceleration;     ///< their rates [m/s^2, rad/s^2]
  std::vector<VectorX> q, v, a, tau;          ///< by dof: [rad, m], [rad/s, m/s], [rad/s^2, m/s^2], [N m, N]
  std::vector<FootSet> contact;               ///< feet on the ground
  std::vector<std::vector<Vector3>> force_W;  ///< by foot: force of the ground on it [N]
  std::vector<DerivedPart> derived;           ///< data derived so far
  std::vector<std::string> unused_columns;    ///< columns of the file that are not used

  int rows() const { return static_cast<int>(time_s.size()); }
};

/// Options for interpreting a file and for deriving missing data.
///
/// With `detect`, order and units are x y z w, radians, metres and seconds. A motion that contradicts them is refused,
/// and the message names the option to set. Other values are used without a check.
///
/// Tuning
///   contacts flicker, or come late       raise contact_height, contact_speed; or add a column of contacts
///   torques are rough, speeds are noisy  set smoothing_hz to three times the frequency of the fastest steps
struct ImportOptions {
  std::string quaternion_order = "detect", angle_unit = "detect", length_unit = "detect", time_unit = "detect";
  std::string velocities = "given", missing_joints = "refuse", topics = "detect";
  double rate_hz = 30.0;
  double grid_step_s = 0.0;
  double smoothing_hz = 0.0;
  double lift_m = 0.0;
  double contact_height = 0.01, contact_speed = 0.05, contact_least_s = 0.03;
  double load_ramp_s = 0.1, friction_use = 0.9;
  bool any_height = false;  ///< no option of users: feet may be far from the ground

  /// The unit of times [s].
  double time_unit_s() const;

  OptionFields Fields();
  /// The fields of order and units, which also apply to a motion that is only compared.
  OptionFields UnitFields();
};

/// @throws InvalidArgument that names the first option out of range.
void CheckImportOptions(ImportOptions options);

}  // namespace gaitwright
