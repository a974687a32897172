// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Names and meanings of the columns of an external file.
struct ColumnNames {
  std::map<std::string, std::string> ours;  ///< this program's names, by the file's column name
  std::map<std::string, double> scale;      ///< factors, by the file's column name
  std::vector<std::string> ignored;         ///< column names of the file to ignore
  bool may_lack = false;                    ///< a file need not have all of these columns
  bool some_joints = false;                 ///< a file need not have all joints: positions of missing joints are NaN
  std::vector<std::string> elsewhere = {};  ///< columns of another file that the names also cover
  std::vector<std::string> in_order = {};   ///< of a file without a line of names; empty: the numbers of its columns
};

/// Reads a file of column names, see docs/import.md: `names`, `columns`, `scale`, `ignore`, and any of
/// `quaternion_order`, `angle_unit`, `length_unit`, `time_unit`, which go into `options` if these have their default
/// values. Failure kBadInput `columns_file`, which names the line.
Result<ColumnNames> ReadColumnNames(const std::string& path, ImportOptions& options);

/// The columns of a motion from a header, see docs/import.md: time_s, base_x_m, ... base_qw (or base_roll_rad,
/// base_pitch_rad, base_yaw_rad with R_WB = Rz Ry Rx), and by joint q_<joint>_rad, v_<joint>_rad_s, tau_<joint>_nm, by
/// foot link contact_<link>, force_<link>_x_n; of prismatic joints _m, _m_s, _n. `_deg` and `_mm` are converted. The
/// name of a joint without the q_, with or without its unit, is also its position. The quaternion is brought into the
/// order x y z w.
///
/// Other columns are listed in `unused_columns`, unless they begin like a known name: then they are refused, with the
/// nearest name. Failure kBadInput `columns`, which names the column and the accepted names, for: no times, no position
/// of some joint, an incomplete group, two columns for one quantity, a name in `names` without a column, a contact that
/// is neither 0 nor 1, and a mimic joint that does not follow its leader.
Result<MotionTable> MotionFromCsv(const RobotModel& model, const CsvTable& table, const ColumnNames& names,
                                  const ImportOptions& options);

}  // namespace gaitwright
