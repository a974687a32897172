// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/exchange/compared_motion.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// How the CSV of a motion is read.
struct CsvReading {
  std::string columns_file = {};  ///< ReadColumnNames; "" for names that the header itself says
  ImportOptions options = {};
  std::vector<std::string> elsewhere = {};  ///< columns of another table that the file of names is for too
  bool some_joints = false;                 ///< joints that the table lacks are not a number, whatever the options say
};

/// The motion in a table, whose columns are named by the file of names, or as OCS2 does, or as ours are. The units and
/// the order that the file of names says go into `reading`. Not checked yet: CheckMotionTable, CheckComparedTable.
/// Failures of ReadColumnNames, Ocs2ColumnNames and MotionFromCsv.
Result<MotionTable> MotionOfCsv(const RobotModel& model, const CsvTable& table, CsvReading& reading);

/// The same as one side of a comparison, with the joints that there are. Failures of CheckedTable too.
Result<ComparedMotion> ComparedCsv(const RobotModel& model, const CsvTable& table, CsvReading reading);

}  // namespace gaitwright
