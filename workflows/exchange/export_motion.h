// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/file.h"
#include "kinematics/base/result.h"
#include "workflows/exchange/motion_rows.h"

namespace gaitwright {

/// What a motion is written as.
enum class ExportFormat { kCsv, kTrajectoryYaml, kTrajectoryJson, kNpz, kSvg };

/// Their names, in the order of ExportFormat: "csv", "joint-trajectory-yaml", "joint-trajectory-json", "npz", "svg".
const std::vector<std::string>& ExportFormatNames();

/// The format of that name. @throws InvalidArgument naming those there are.
ExportFormat ExportFormatOf(const std::string& name);

/// A motion as files, with what is to be said of them.
struct ExportedMotion {
  std::vector<OutputFile> files;  ///< one; of plots one each
  int rows = 0;
  double start_s = 0.0, end_s = 0.0, rate_hz = 0.0;
  std::vector<std::string> notes;  ///< what the format leaves out, and the like; plain sentences
};

/// A plan in a format. @param rate_hz  of rows; 0 for UsualRate.  @param out  the file; of plots the folder.
/// @throws InvalidArgument as RowsOfPlan does, and for a figure that is not finite.
ExportedMotion ExportPlan(const RobotModel& model, const MotionPlan& plan, ExportFormat format, double rate_hz,
                          const std::string& out);

/// A log in a format. @param rate_hz  of rows; 0 for the log's own.  @param plan  what was played, where it is known:
/// plots then show both, with all plots of a report. @throws InvalidArgument as RowsOfLog does, and where log and plan
/// are not of one robot and motion.
ExportedMotion ExportLog(const RobotModel& model, const PlaybackLog& log, const MotionPlan* plan, ExportFormat format,
                         double rate_hz, const std::string& out);

}  // namespace gaitwright
