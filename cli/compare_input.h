// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "cli/motion_input.h"
#include "workflows/exchange/compare_reports.h"

namespace gaitwright::cli {

/// What is to be compared, by its files.
struct CompareFiles {
  std::string a, b, columns;
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
Result<CompareInput> ReadCompareInput(const CompareFiles& files);

}  // namespace gaitwright::cli
