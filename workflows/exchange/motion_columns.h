// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// How the columns of somebody else's file are called and what they hold.
struct ColumnNames {
  std::map<std::string, std::string> ours;  ///< by their name
  std::map<std::string, double> scale;      ///< by their name: what their numbers are multiplied with
  std::vector<std::string> ignored;         ///< their names
  bool may_lack = false;                    ///< a file need not have all of these columns
  bool some_joints = false;                 ///< nor all joints: the positions of others are not a number
  std::vector<std::string> elsewhere = {};  ///< columns of another file that the names are for too
};

/// What a file of column names says, see docs/import.md: `columns`, `scale`, `ignore`, and any of `quaternion_order`,
/// `angle_unit`, `length_unit`, `time_unit`, which go into `options` where these are at their usual values.
/// Failure kBadInput `columns_file` naming the line.
Result<ColumnNames> ReadColumnNames(const std::string& path, ImportOptions& options);

/// The columns of a motion as a header says them, see docs/import.md: time_s, base_x_m, ... base_qw (or base_roll_rad,
/// base_pitch_rad, base_yaw_rad with R_WB = Rz Ry Rx), and by joint q_<joint>_rad, v_<joint>_rad_s, tau_<joint>_nm, by
/// foot link contact_<link>, force_<link>_x_n; of slides _m, _m_s, _n. `_deg` and `_mm` are taken as they say. A
/// joint's name without the q_, with its unit or alone, is its position too. The quaternion is brought into the order x
/// y z w.
///
/// Others are named in `unused_columns`, unless they begin like one of ours: then they are refused, with the nearest.
/// Failure kBadInput `columns`, naming column and what would be taken: no times, no position of some joint, only a part
/// of what belongs together, two columns for one thing; a name in `names` that is no column; a contact that is neither
/// 0 nor 1; a joint that mimics another and does not follow it.
Result<MotionTable> MotionFromCsv(const RobotModel& model, const CsvTable& table, const ColumnNames& names,
                                  const ImportOptions& options);

}  // namespace gaitwright
