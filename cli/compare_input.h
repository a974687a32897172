// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "cli/motion_input.h"
#include "workflows/compare/compare_reports.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright::cli {

/// What is to be compared, by its files.
struct CompareFiles {
  std::string a, b;
  std::string columns, columns_b;  ///< names of the columns of a CSV, or of both; of B where its names are others
  ImportOptions units;             ///< of a CSV
  MotionRobot robot;
};

/// Two motions, or two reports.
struct CompareInput {
  std::optional<ComparedMotion> a = {}, b = {};
  std::optional<MotionPlan> played = {};  ///< that of --plan
  std::optional<ReadReport> report_a = {}, report_b = {};
};

/// Reads both files, each as what its content is. Failures of the readers; where two do not belong together, a log or a
/// table has no robot (that of --robot, --urdf or --plan, else that of the other side), or a log is of another robot.
/// @throws InvalidArgument for column names and units where there is no CSV that they are for.
Result<CompareInput> ReadCompareInput(const CompareFiles& files);

}  // namespace gaitwright::cli
