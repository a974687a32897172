// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/export_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/options.h"
#include "planning/plan/json_part_internal.h"
#include "playback/control/gains.h"
#include "playback/mjcf/model_file.h"
#include "playback/play/play.h"
#include "playback/report/plot_style.h"
#include "playback/score/stability_report.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/export_csv.h"
#include "workflows/exchange/export_frames_internal.h"
#include "workflows/exchange/export_mcap_internal.h"
#include "workflows/exchange/export_npz.h"
#include "workflows/exchange/export_trajectory.h"
#include "workflows/exchange/joint_trajectory.h"
#include "workflows/exchange/motion_plots.h"

namespace gaitwright {
namespace {

constexpr double kSameStep = 2e-6;  // share of a step

void AddPlots(const std::vector<Plot>& plots, const std::string& folder, ExportedMotion& exported) {
  for (const Plot& plot : plots) {
    const std::string file = (std::filesystem::path(folder) / (plot.name + ".svg")).string();
    exported.files.push_back({file, StandaloneSvg(plot.svg)});
  }
}

std::string ExportText(const RobotModel& model, const MotionRows& rows, ExportFormat format, double rate_hz,
                       ExportPart part) {
  switch (format) {
    case ExportFormat::kCsv:
      return MotionCsv(model, rows);
    case ExportFormat::kTrajectoryYaml:
      return JointTrajectoryYaml(model, rows);
    case ExportFormat::kTrajectoryJson:
      return JointTrajectoryJson(model, rows);
    case ExportFormat::kNpz:
      return MotionNpz(model, rows);
    case ExportFormat::kFramesCsv:
      return FramesCsv(model, rows);
    case ExportFormat::kFramesJson:
      return FramesJson(model, rows, rate_hz, part == ExportPart::kCycle);
    case ExportFormat::kFramesNpz:
      return FramesNpz(model, rows, rate_hz);
    case ExportFormat::kMcap:
      return MotionMcap(model, rows);
    case ExportFormat::kSvg:
    case ExportFormat::kMjcf:
      break;
  }
  throw InvalidArgument("plots are written to a folder, not to a single file");
}

/// Whether the size is within the limits of `import`; other programs may read more.
bool IsReadBack(const RobotModel& model, const MotionRows& rows, ExportFormat format, std::size_t bytes) {
  constexpr std::size_t kOthersInYaml = 15,
                        kOthersInJson = 8;  // keys, lists and times of a point
  const std::size_t n = rows.time_s.size(), lists = 2U + (rows.a.empty() ? 0U : 1U) + (rows.tau.empty() ? 0U : 1U);
  const std::size_t numbers = lists * model.dof_names.size();
  switch (format) {
    case ExportFormat::kTrajectoryYaml:
      return bytes <= kLargestTrajectoryYaml && n * (numbers + kOthersInYaml) <= kMostTrajectoryYamlValues;
    case ExportFormat::kTrajectoryJson:
      return bytes <= kLargestJson && n <= kMostCsvRows && n * (numbers + kOthersInJson) <= kMostJsonValues;
    case ExportFormat::kCsv:
      return n <= kMostCsvRows && n * MotionCsvColumns(model).size() <= kMostCsvCells;
    default:
      return true;
  }
}

void AddSizeNote(const RobotModel& model, const MotionRows& rows, ExportFormat format, ExportedMotion& exported) {
  if (format == ExportFormat::kSvg || IsReadBack(model, rows, format, exported.files.front().text.size())) return;
  const bool yaml = format == ExportFormat::kTrajectoryYaml;
  exported.notes.push_back(
      fmt::format("it is larger than 'import' accepts: use a lower --rate-hz{}",
                  yaml ? ", or the formats joint-trajectory-json or csv, which may be longer" : ""));
}

bool IsOfFrames(ExportFormat format) {
  return format == ExportFormat::kFramesCsv || format == ExportFormat::kFramesJson ||
         format == ExportFormat::kFramesNpz;
}

void AddNotes(const RobotModel& model, const MotionRows& rows, ExportFormat format, double rate_hz,
              ExportedMotion& exported) {
  const bool trajectory = format == ExportFormat::kTrajectoryYaml || format == ExportFormat::kTrajectoryJson;
  if (trajectory)
    exported.notes.emplace_back("the motion of the base is left out: a joint trajectory cannot contain it");
  if (rows.a.empty() && (trajectory || format == ExportFormat::kNpz || format == ExportFormat::kMcap))
    exported.notes.emplace_back("there are no accelerations: a log does not contain them");
  if (IsOfFrames(format)) exported.notes.push_back(FramesNote(model, rate_hz, format == ExportFormat::kFramesCsv));
  if (rows.tau.empty() && format != ExportFormat::kSvg && !IsOfFrames(format))
    exported.notes.emplace_back("there are no torques: the plan does not contain them");
}

/// Adds a note if the last row is not the end of the motion, because all steps are equal.
void AddEndNote(double motion_end_s, ExportedMotion& exported) {
  const double beyond_s = exported.end_s - motion_end_s;
  if (std::abs(beyond_s) * exported.rate_hz < kSameStep) return;
  exported.notes.push_back(beyond_s > 0.0
                               ? fmt::format("the last row is {:.6g} s after the plan's end, so that all steps are "
                                             "equal; it has the last posture, at rest",
                                             beyond_s)
                               : fmt::format("the last {:.6g} s are left out, so that all steps are equal", -beyond_s));
}

/// How exactly the cycle repeats.
std::string CycleNote(const CycleRows& cycle) {
  return fmt::format(
      "one cycle of {:.6g} s: the last row is the first one a cycle later, to {:.1e} rad or m of the joints and {:.1e} "
      "rad/s or m/s of their rates",
      cycle.rows.time_s.back() - cycle.rows.time_s.front(), cycle.joints, cycle.joint_rates);
}

ExportedMotion ExportRows(const RobotModel& model, const MotionRows& rows, ExportFormat format, double rate_hz,
                          const std::string& out, ExportPart part = ExportPart::kAll) {
  ExportedMotion exported;
  exported.rows = rows.size();
  exported.start_s = rows.time_s.front();
  exported.end_s = rows.time_s.back();
  exported.rate_hz = rate_hz;
  if (format == ExportFormat::kSvg) {
    AddPlots(MotionPlots({{model.name, &model, &rows}}), out, exported);
  } else {
    exported.files.push_back({out, ExportText(model, rows, format, rate_hz, part)});
  }
  AddNotes(model, rows, format, rate_hz, exported);
  AddSizeNote(model, rows, format, exported);
  return exported;
}

/// The robot on the plan's ground, in the plan's first posture.
ExportedMotion ExportModel(const RobotModel& model, const MotionPlan& plan, double rate_hz, const std::string& out) {
  if (rate_hz != 0.0) throw InvalidArgument("--rate-hz has no effect on --format mjcf, which is a model without rows");
  const Gains gains = DeriveGains(model);
  ExportedMotion exported;
  exported.files = MujocoFiles(model, plan.terrain, plan.whole_body.q.front(), gains.stiffness, gains.damping, out);
  if (!model.transmissions.empty())
    exported.notes.emplace_back(
        "transmissions are left out: each joint has a separate actuator with the joint's effort limit");
  return exported;
}

void CheckBelongs(const RobotModel& model, const PlaybackLog& log, const MotionPlan* plan) {
  if (!log.robot_hash.empty() && log.robot_hash != model.hash) {
    throw InvalidArgument(fmt::format("the log is of robot '{}' ({}), not of '{}' ({}); give the robot that was played",
                                      log.robot, log.robot_hash, model.name, model.hash));
  }
  if (plan == nullptr || log.plan_hash == MotionHash(*plan)) return;
  throw InvalidArgument(
      fmt::format("the log was played from plan {}, not from the given plan {}; give the plan that was played",
                  log.plan_hash, MotionHash(*plan)));
}

}  // namespace

const std::vector<std::string>& ExportFormatNames() {
  static const std::vector<std::string> names = {"csv",
                                                 "joint-trajectory-yaml",
                                                 "joint-trajectory-json",
                                                 "npz",
                                                 "frames-csv",
                                                 "frames-json",
                                                 "frames-npz",
                                                 "mcap",
                                                 "svg",
                                                 "mjcf"};
  return names;
}

ExportFormat ExportFormatOf(const std::string& name) {
  const std::vector<std::string>& names = ExportFormatNames();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw InvalidArgument(
        fmt::format("format '{}' does not exist{}; accepted: {}", name, NearestHint(name, names), QuotedList(names)));
  }
  return static_cast<ExportFormat>(found - names.begin());
}

ExportedMotion ExportPlan(const RobotModel& model, const MotionPlan& plan, ExportFormat format, double rate_hz,
                          const std::string& out, ExportPart part) {
  if (format == ExportFormat::kMjcf) {
    if (part == ExportPart::kCycle) throw InvalidArgument("--format mjcf is a model and has no cycle");
    return ExportModel(model, plan, rate_hz, out);
  }
  const double rate = rate_hz != 0.0 ? rate_hz : UsualRate(plan);
  if (part == ExportPart::kCycle) {
    const CycleRows cycle = RowsOfCycle(model, plan, rate);
    ExportedMotion exported = ExportRows(model, cycle.rows, format, cycle.rate_hz, out, part);
    exported.notes.push_back(CycleNote(cycle));
    return exported;
  }
  ExportedMotion exported = ExportRows(model, RowsOfPlan(model, plan, rate), format, rate, out);
  AddEndNote(plan.whole_body.end_s(), exported);
  return exported;
}

ExportedMotion ExportLog(const RobotModel& model, const PlaybackLog& log, const MotionPlan* plan, ExportFormat format,
                         double rate_hz, const std::string& out) {
  CheckBelongs(model, log, plan);
  if (format == ExportFormat::kMjcf) {
    if (plan == nullptr) throw InvalidArgument("a log does not contain the ground; give --plan FILE for --format mjcf");
    return ExportModel(model, *plan, rate_hz, out);
  }
  const double rate = rate_hz != 0.0 ? rate_hz : log.log_rate_hz;
  ExportedMotion exported = ExportRows(model, RowsOfLog(model, log, rate), format, rate, out);
  if (format != ExportFormat::kSvg || plan == nullptr) {
    AddEndNote(log.samples.back().time_s, exported);
    return exported;
  }
  exported.files.clear();
  AddPlots(MakePlots(model, *plan, log, Score(model, *plan, log)), out, exported);
  return exported;
}

}  // namespace gaitwright
