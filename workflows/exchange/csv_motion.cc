// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/csv_motion.h"

#include "workflows/exchange/motion_columns.h"
#include "workflows/exchange/ocs2_columns.h"

namespace gaitwright {

Result<MotionTable> MotionOfCsv(const RobotModel& model, const CsvTable& table, CsvReading& reading) {
  std::vector<DerivedPart> derived;
  Result<ColumnNames> names = ColumnNames{};
  const bool ocs2 = reading.columns_file.empty() && IsOcs2Motion(table);
  if (!reading.columns_file.empty()) names = ReadColumnNames(reading.columns_file, reading.options);
  if (ocs2) names = Ocs2ColumnNames(model, table, derived);
  if (!names) return names.failure();
  names->elsewhere = reading.elsewhere;
  names->some_joints = reading.some_joints;
  Result<MotionTable> motion = MotionFromCsv(model, table, *names, reading.options);
  if (!motion) return motion;
  if (ocs2) motion->format = MotionFormat::kOcs2Csv;
  motion->derived.insert(motion->derived.begin(), derived.begin(), derived.end());
  return motion;
}

Result<ComparedMotion> ComparedCsv(const RobotModel& model, const CsvTable& table, CsvReading reading) {
  reading.some_joints = true;
  const Result<MotionTable> motion = MotionOfCsv(model, table, reading);
  if (!motion) return motion.failure();
  return CheckedTable(model, reading.options, *motion, table.source);
}

}  // namespace gaitwright
