// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "cli/motion_input.h"
#include "workflows/compare/compare_reports.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright::cli {

/// The two files to compare, and how to read them.
struct CompareFiles {
  std::string a, b;
  std::string columns, columns_b;  ///< maps of CSV columns: of both files; of B if its names differ
  ImportOptions units;             ///< units of a CSV
  MotionRobot robot;
};

/// Two motions, or two reports.
struct CompareInput {
  std::optional<ComparedMotion> a = {}, b = {};
  std::optional<MotionPlan> played = {};  ///< the plan of --plan
  std::optional<ReadReport> report_a = {}, report_b = {};
};

/// Reads both files; the content decides the type. The robot of a log or table is that of --robot, --urdf or --plan,
/// otherwise that of the other side. Failures: as of the readers; if the two types cannot be compared; if a log or
/// table has no robot; if a log is of another robot.
/// @throws InvalidArgument if column names or units are given and no file is a CSV that they apply to.
Result<CompareInput> ReadCompareInput(const CompareFiles& files);

}  // namespace gaitwright::cli
