// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/exchange/compared_motion.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Options for reading the CSV of a motion.
struct CsvReading {
  std::string columns_file = {};  ///< ReadColumnNames; "" to use the header's names
  ImportOptions options = {};
  std::vector<std::string> elsewhere = {};  ///< columns of another table that the names file also covers
  bool some_joints = false;                 ///< true: missing joints are NaN, regardless of the options
};

/// The motion in a table whose column names are those of the names file, of OCS2 or of this program. Units and
/// quaternion order of the names file go into `reading`. Values are not checked: call CheckMotionTable or
/// CheckComparedTable. Failures: as of ReadColumnNames, Ocs2ColumnNames and MotionFromCsv.
Result<MotionTable> MotionOfCsv(const RobotModel& model, const CsvTable& table, CsvReading& reading);

/// The motion as one side of a comparison, with the joints that the table has. Failures: as of MotionOfCsv and
/// CheckedTable.
Result<ComparedMotion> ComparedCsv(const RobotModel& model, const CsvTable& table, CsvReading reading);

}  // namespace gaitwright
