// SPDX-License-Identifier: BSD-3-Clause
#include "cli/compare_input.h"

#include <fmt/format.h>

#include <filesystem>

#include "kinematics/base/file.h"
#include "planning/plan/plan_json.h"
#include "playback/log/log_json.h"
#include "workflows/exchange/csv_motion.h"
#include "workflows/exchange/joint_trajectory.h"
#include "workflows/exchange/motion_file.h"

namespace gaitwright::cli {
namespace {

/// One of the two files.
struct SideFile {
  std::string path, text;
  MotionFileKind kind = MotionFileKind::kTable;
  std::optional<CsvTable> table = {};  ///< set if the file has columns of numbers
  CsvReading reading = {};             ///< how to read the table or the joint trajectory

  bool has_units() const { return table || kind == MotionFileKind::kTrajectory; }
};

Failure ComparisonRefused(FailureCode code, const std::string& message, std::vector<Suggestion> suggestions = {}) {
  return {FailureKind::kBadInput, code, "ReadCompareInput", message, std::move(suggestions)};
}

Result<SideFile> ReadSide(const std::string& path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  SideFile side{path, *text, KindOfText(*text)};
  if (side.kind == MotionFileKind::kJson) {
    return ComparisonRefused(
        FailureCode::kNoMotion, fmt::format("'{}' is JSON, but not a plan, log or report", path),
        {"give a plan.json, a log.json, the output of 'walk --json', a CSV of a motion, or a joint trajectory"});
  }
  if (side.kind == MotionFileKind::kTrials)
    return ComparisonRefused(FailureCode::kNoMotion,
                             fmt::format("'{}' is {}, which 'compare' does not accept", path, NameOf(side.kind)),
                             {"'trials --report FILE' writes a page for each of them"});
  if (side.kind != MotionFileKind::kTable) return side;
  Result<CsvTable> table = ParseCsvTable(side.text, path);
  const std::string extension = std::filesystem::path(path).extension().string();
  if (!table && (extension == ".yaml" || extension == ".yml")) {
    return ComparisonRefused(
        FailureCode::kNoMotion,
        fmt::format("'{}' is YAML, but not a joint trajectory; 'compare' accepts no other YAML", path),
        {"'import' turns footsteps into a plan, which can be compared"});
  }
  if (!table) return table.failure();
  side.table = std::move(*table);
  return side;
}

Result<ComparedMotion> ReadPlanSide(const SideFile& side) {
  Result<MotionPlan> plan = PlanFromJson(side.text, side.path);
  if (!plan) return plan.failure();
  const Result<MotionInput> input = PlanInput(std::move(*plan));
  if (!input) return input.failure();
  return ComparedPlan(*input->model, *input->plan, side.path);
}

Result<ComparedMotion> ReadLogSide(const SideFile& side, const RobotModel* model) {
  const Result<PlaybackLog> log = LogFromJson(side.text, side.path);
  if (!log) return log.failure();
  const std::vector<Suggestion> suggestions = {"--plan FILE, the plan that was played", "--robot " + log->robot};
  if (model == nullptr)
    return ComparisonRefused(
        FailureCode::kNoRobot,
        fmt::format("'{}' is a log of robot '{}', but does not contain the robot", side.path, log->robot), suggestions);
  if (model->hash != log->robot_hash) {
    return ComparisonRefused(FailureCode::kRobotHash,
                             fmt::format("'{}' is a log of robot '{}' ({}), not of '{}' ({})", side.path, log->robot,
                                         log->robot_hash, model->name, model->hash),
                             suggestions);
  }
  return ComparedLog(*model, *log, side.path);
}

Result<ComparedMotion> ReadTableSide(const SideFile& side, const RobotModel* model) {
  if (model == nullptr) {
    return ComparisonRefused(FailureCode::kNoRobot,
                             fmt::format("'{}' does not name the robot of the motion", side.path),
                             {"--robot NAME", "--urdf FILE", "--plan FILE, the plan that was played"});
  }
  if (!side.table) return ComparedTrajectory(*model, side.text, side.path, side.reading.options);
  return ComparedCsv(*model, *side.table, side.reading);
}

/// Sets how the columns of each side are read, if it has columns.
void SetColumnReading(const CompareFiles& files, SideFile& a, SideFile& b) {
  CompareFiles usual, given = files;
  const bool units = TextsOf(given.units.UnitFields()) != TextsOf(usual.units.UnitFields());
  if (!files.columns_b.empty() && !b.table)
    throw InvalidArgument(fmt::format("--columns-b is given, but '{}' is not a CSV file", b.path));
  if (!files.columns.empty() && !a.table && (!b.table || !files.columns_b.empty()))
    throw InvalidArgument(b.table ? "--columns is given, but A is not a CSV file and B is read with --columns-b"
                                  : "--columns is given, but neither file is a CSV file");
  if (units && !a.has_units() && !b.has_units())
    throw InvalidArgument("a unit or --quaternion-order is given, but neither file is a CSV or a ROS joint trajectory");
  a.reading = {files.columns, files.units};
  b.reading = {files.columns_b.empty() ? files.columns : files.columns_b, files.units};
  if (!a.table || !b.table || !files.columns_b.empty()) return;
  a.reading.elsewhere = b.table->columns;
  b.reading.elsewhere = a.table->columns;
}

Result<CompareInput> ReadReports(const SideFile& a, const SideFile& b) {
  if (a.kind != b.kind) {
    return ComparisonRefused(FailureCode::kNotAlike,
                             fmt::format("'{}' is {}, '{}' is {}: a report can only be compared with a report", a.path,
                                         NameOf(a.kind), b.path, NameOf(b.kind)));
  }
  const Result<ReadReport> of_a = ReportFromJson(a.text, a.path), of_b = ReportFromJson(b.text, b.path);
  if (!of_a) return of_a.failure();
  if (!of_b) return of_b.failure();
  CompareInput input;
  input.report_a = *of_a;
  input.report_b = *of_b;
  return input;
}

/// Reads a motion. Its robot is `named` if given, otherwise the robot of the other side.
Result<ComparedMotion> ReadMotionSide(const SideFile& side, const std::optional<RobotModel>& named,
                                      const std::optional<ComparedMotion>& other) {
  if (side.kind == MotionFileKind::kPlan) return ReadPlanSide(side);
  const RobotModel* model = named ? &*named : (other ? &other->model : nullptr);
  if (side.kind == MotionFileKind::kLog) return ReadLogSide(side, model);
  return ReadTableSide(side, model);
}

}  // namespace

Result<CompareInput> ReadCompareInput(const CompareFiles& files) {
  Result<SideFile> a = ReadSide(files.a), b = ReadSide(files.b);
  if (!a) return a.failure();
  if (!b) return b.failure();
  SetColumnReading(files, *a, *b);
  if (a->kind == MotionFileKind::kReport || b->kind == MotionFileKind::kReport) return ReadReports(*a, *b);
  Result<MotionInput> named = NamedInput(files.robot);
  if (!named) return named.failure();
  CompareInput input;
  input.played = std::move(named->played);
  // Read the side that says more about its robot first: a plan contains the robot, a log of it only a hash.
  const bool a_first = static_cast<int>(a->kind) <= static_cast<int>(b->kind);
  for (const bool take_a : {a_first, !a_first}) {
    const SideFile& side = take_a ? *a : *b;
    Result<ComparedMotion> motion = ReadMotionSide(side, named->model, take_a ? input.b : input.a);
    if (!motion) return motion.failure();
    (take_a ? input.a : input.b) = std::move(*motion);
  }
  return input;
}

}  // namespace gaitwright::cli
