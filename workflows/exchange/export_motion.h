// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/file.h"
#include "kinematics/base/result.h"
#include "workflows/exchange/motion_rows.h"

namespace gaitwright {

/// Format of an exported motion.
enum class ExportFormat {
  kCsv,
  kTrajectoryYaml,
  kTrajectoryJson,
  kNpz,
  kFramesCsv,
  kFramesJson,
  kFramesNpz,
  kMcap,
  kSvg,
  kMjcf
};

/// Format names, in the order of ExportFormat: "csv", "joint-trajectory-yaml", "joint-trajectory-json", "npz",
/// "frames-csv", "frames-json", "frames-npz", "mcap", "svg", "mjcf".
const std::vector<std::string>& ExportFormatNames();

/// The format with this name. @throws InvalidArgument that lists the formats.
ExportFormat ExportFormatOf(const std::string& name);

/// Which part of a plan is exported.
enum class ExportPart { kAll, kCycle };

/// An exported motion: files and notes.
struct ExportedMotion {
  std::vector<OutputFile> files;  ///< one file, or one for each plot
  int rows = 0;                   ///< 0 for a model, which also has no times
  double start_s = 0.0, end_s = 0.0, rate_hz = 0.0;
  std::vector<std::string> notes;  ///< plain sentences, for example on data that the format cannot contain
};

/// Exports a plan in a format; "mjcf" is the robot on its ground with the first posture and the gains (MujocoFiles).
/// @param rate_hz  of rows; 0 for UsualRate.  @param out  the file, or the folder of plots.
/// @param part  kCycle for RowsOfCycle, whose first and last row are one cycle apart.
/// @throws InvalidArgument as RowsOfPlan and RowsOfCycle do, for a value that is not finite, and for the cycle of a
/// model.
ExportedMotion ExportPlan(const RobotModel& model, const MotionPlan& plan, ExportFormat format, double rate_hz,
                          const std::string& out, ExportPart part = ExportPart::kAll);

/// Exports a log in a format. @param rate_hz of rows; 0 for the rate of the log. @param plan the played plan, if known;
/// plots then show both, with all plots of a report. @throws InvalidArgument as RowsOfLog does, and if log and plan are
/// not of the same robot and motion.
ExportedMotion ExportLog(const RobotModel& model, const PlaybackLog& log, const MotionPlan* plan, ExportFormat format,
                         double rate_hz, const std::string& out);

}  // namespace gaitwright
