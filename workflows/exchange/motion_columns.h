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
  std::map<std::string, std::string> ours;  ///< by their name
  std::map<std::string, double> scale;      ///< factors, by the file's column name
  std::vector<std::string> ignored;         ///< their names
  bool may_lack = false;                    ///< a file need not have all of these columns
  bool some_joints = false;                 ///< a file need not have all joints: positions of missing joints are NaN
  std::vector<std::string> elsewhere = {};  ///< columns of another file that the names also cover
};

/// Contents of a file of column names, see docs/import.md: `columns`, `scale`, `ignore`, and any of `quaternion_order`,
/// `angle_unit`, `length_unit`, `time_unit`, which go into `options` if these have their default values. Failure
/// kBadInput `columns_file` naming the line.
Result<ColumnNames> ReadColumnNames(const std::string& path, ImportOptions& options);

/// The columns of a motion from a header, see docs/import.md: time_s, base_x_m, ... base_qw (or base_roll_rad,
/// base_pitch_rad, base_yaw_rad with R_WB = Rz Ry Rx), and by joint q_<joint>_rad, v_<joint>_rad_s, tau_<joint>_nm, by
/// foot link contact_<link>, force_<link>_x_n; of slides _m, _m_s, _n. `_deg` and `_mm` are converted. A joint's name
/// without the q_, with its unit or alone, is its position too. The quaternion is brought into the order x y z w.
///
/// Other columns are listed in `unused_columns`, unless they begin like a known name: then they are refused, with the
/// nearest name. Failure kBadInput `columns`, naming the column and the accepted names: no times, no position of some
/// joint, an incomplete group, two columns for one quantity; a name in `names` without a column; a contact that is
/// neither 0 nor 1; a mimic joint that does not follow its leader.
Result<MotionTable> MotionFromCsv(const RobotModel& model, const CsvTable& table, const ColumnNames& names,
                                  const ImportOptions& options);

}  // namespace gaitwright
