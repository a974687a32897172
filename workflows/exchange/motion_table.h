// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// Bounds of a motion that is imported or compared: how long it lasts, and how far from zero its clock begins [s] (one
/// that counts from 1970 is at 2e9); speeds, accelerations and torques that come of its positions; rows on a grid.
inline constexpr double kLongestMotion = 3600.0, kLatestStart = 1e10, kLargestDerived = 1e9;
inline constexpr int kMostGridRows = 1'000'000;

/// Something that a file did not hold and that was worked out, and from what.
struct DerivedPart {
  std::string what, how;

  bool operator==(const DerivedPart&) const = default;
};

/// A motion as a file has it, in SI units and in this robot's order; whatever a file may leave out is empty then, else
/// there is one for each row. Rows are at any times, which rise.
struct MotionTable {
  std::string format;  ///< "csv", "ocs2-csv", "joint-trajectory"
  std::vector<double> time_s;
  std::vector<Vector3> base_m;                ///< p_WB, of the URDF's root link
  std::vector<Eigen::Vector4d> quaternion;    ///< of R_WB, x y z w
  bool turned_by_angles = false;              ///< quaternions that come of roll, pitch and yaw: their order is known
  std::vector<Vector6> base_rate;             ///< v_WB, w_WB: linear, then angular, in W [m/s, rad/s]
  std::vector<Vector6> base_acceleration;     ///< their rates [m/s^2, rad/s^2]
  std::vector<VectorX> q, v, a, tau;          ///< by dof: [rad, m], [rad/s, m/s], [rad/s^2, m/s^2], [N m, N]
  std::vector<FootSet> contact;               ///< feet on the ground
  std::vector<std::vector<Vector3>> force_W;  ///< by foot, that the ground puts on it [N]
  std::vector<DerivedPart> derived;           ///< so far
  std::vector<std::string> unused_columns;    ///< in the file, and of no use here

  int rows() const { return static_cast<int>(time_s.size()); }
};

/// How what a file leaves open is understood, and how what it leaves out is worked out.
///
/// Order and units at `detect` are x y z w, radians, metres and seconds, unless the motion speaks against it, which is
/// then refused with the option that says how it is meant. Whatever else they are is believed.
///
/// Tuning
///   contacts flicker, or come late       more contact_height, contact_speed; or a column of contacts
///   torques are rough, speeds are noisy  smoothing_hz of three times the fastest steps
struct ImportOptions {
  std::string quaternion_order = "detect", angle_unit = "detect", length_unit = "detect", time_unit = "detect";
  std::string velocities = "given", missing_joints = "refuse";
  double grid_step_s = 0.0;
  double smoothing_hz = 0.0;
  double lift_m = 0.0;
  double contact_height = 0.01, contact_speed = 0.05, contact_least_s = 0.03;
  double load_ramp_s = 0.1, friction_use = 0.9;

  /// How long the unit of times is.
  double time_unit_s() const;

  OptionFields Fields();
  /// Those of order and units, which a motion that is only compared has too.
  OptionFields UnitFields();
};

/// @throws InvalidArgument naming the first option that is out of its range.
void CheckImportOptions(ImportOptions options);

}  // namespace gaitwright
