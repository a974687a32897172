// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

#include "kinematics/base/file.h"
#include "kinematics/base/hash.h"
#include "kinematics/base/text.h"
#include "workflows/exchange/bvh_motion_internal.h"
#include "workflows/exchange/check_motion_table.h"
#include "workflows/exchange/contact_plan_internal.h"
#include "workflows/exchange/csv_motion.h"
#include "workflows/exchange/deepmimic_motion_internal.h"
#include "workflows/exchange/derive_base.h"
#include "workflows/exchange/even_motion.h"
#include "workflows/exchange/frame_motion_internal.h"
#include "workflows/exchange/joint_trajectory.h"
#include "workflows/exchange/motion_columns.h"
#include "workflows/exchange/motion_file.h"
#include "workflows/exchange/npz_motion_internal.h"
#include "workflows/exchange/read_motion_internal.h"
#include "workflows/exchange/recorded_motion_internal.h"

namespace gaitwright {
namespace {

std::string ExtensionOf(const std::string& file) { return LowerCase(std::filesystem::path(file).extension().string()); }

/// A table whose columns are named by its first line; without such a line, by `names` in the file of column names, or
/// by their numbers.
Result<CsvTable> ParseNamedTable(const std::string& text, const ImportRequest& request) {
  ImportOptions ignored = request.options;
  Result<ColumnNames> names = ColumnNames{};
  if (!request.columns_file.empty()) names = ReadColumnNames(request.columns_file, ignored);
  if (!names) return names.failure();
  if (!LacksColumnNames(text)) {
    if (!names->in_order.empty())
      return RefusedMotion(request.columns_file,
                           fmt::format("has 'names', but '{}' has a line of names", request.file));
    return ParseCsvTable(text, request.file);
  }
  Result<CsvTable> table = ParseNumberTable(text, request.file);
  if (!table || names->in_order.empty()) return table;
  if (names->in_order.size() != table->columns.size()) {
    return RefusedMotion(request.columns_file, fmt::format("has {} names, but '{}' has {} columns",
                                                           names->in_order.size(), request.file, table->num_columns()));
  }
  std::set<std::string> unique(names->in_order.begin(), names->in_order.end());
  if (unique.size() != names->in_order.size() || unique.count("") > 0)
    return RefusedMotion(request.columns_file, "has a name in 'names' twice, or an empty one");
  table->columns = names->in_order;
  return table;
}

/// Reads the table of a CSV. `request` gets the units of the column-names file.
Result<MotionTable> ReadCsvMotion(const RobotModel& model, const std::string& text, ImportRequest& request) {
  if (request.columns_file.empty() && LacksColumnNames(text))
    return ParseNumberFrames(model, text, request.file, request.options);
  const Result<CsvTable> table = ParseNamedTable(text, request);
  if (!table) return table.failure();
  CsvReading reading{request.columns_file, request.options};
  Result<MotionTable> motion = MotionOfCsv(model, *table, reading);
  request.options = reading.options;
  return motion;
}

Result<MotionTable> ReadTrajectory(const RobotModel& model, const std::string& text, const ImportRequest& request) {
  if (HoldsDeepMimicFrames(text)) return ParseDeepMimic(model, text, request.file, request.options);
  if (HoldsJsonFrames(text)) return ParseJsonFrames(model, text, request.file, request.options);
  return ExtensionOf(request.file) == ".json" ? ParseJointTrajectoryJson(model, text, request.file, request.options)
                                              : ParseJointTrajectory(model, text, request.file, request.options);
}

/// Whether a YAML text contains footsteps and not a joint trajectory.
bool HoldsFootsteps(const std::string& text) {
  return text.find("joint_names") == std::string::npos && text.find("footsteps") != std::string::npos;
}

/// Advice for a file that this program wrote, which needs no import; empty for other files.
std::string InsteadOfImport(MotionFileKind kind) {
  switch (kind) {
    case MotionFileKind::kPlan:
      return "'audit', 'play' and 'compare' accept it directly, and 'export' converts it for other programs";
    case MotionFileKind::kLog:
      return "'compare' and 'view' accept it directly; 'export LOG --plan PLAN --out motion.csv' writes its measured "
             "motion as a CSV, which can be imported";
    case MotionFileKind::kReport:
      return "it contains no motion; 'compare' compares two reports, and the report's plan needs no import";
    case MotionFileKind::kTrials:
      return "it contains no motion; use it with 'audit PLAN --preflight --trials-result FILE'";
    default:
      return "";
  }
}

MotionForm FormOf(const std::string& extension) {
  if (extension == ".csv" || extension == ".tsv" || extension == ".txt") return MotionForm::kCsv;
  if (extension == ".npz") return MotionForm::kNpz;
  if (extension == ".bvh") return MotionForm::kBvh;
  return extension == ".mcap" || extension == ".db3" ? MotionForm::kRecording : MotionForm::kTree;
}

Result<MotionText> ReadFolder(const std::string& folder) {
  if (!IsBagFolder(folder)) return RefusedMotion(folder, "is a folder; give a file, such as a .csv or .yaml");
  Result<std::vector<std::string>> files = ReadBagFolder(folder);
  if (!files) return files.failure();
  MotionText read{std::move(files->front()), MotionForm::kRecording};
  read.further.assign(std::make_move_iterator(files->begin() + 1), std::make_move_iterator(files->end()));
  return read;
}

}  // namespace

Failure RefusedMotion(const std::string& file, const std::string& why) {
  return {FailureKind::kBadInput, FailureCode::kImport, "ImportMotion", fmt::format("'{}': {}", file, why), {}};
}

const std::vector<std::string>& MotionEndings() {
  static const std::vector<std::string> endings = {".csv", ".tsv", ".txt",  ".npz", ".mcap",
                                                   ".db3", ".bvh", ".yaml", ".yml", ".json"};
  return endings;
}

std::string MotionText::Hash() const {
  if (further.empty()) return HexHash(text);
  std::string hashes = HexHash(text);
  for (const std::string& file : further) hashes += HexHash(file);
  return HexHash(hashes);
}

Result<MotionText> ReadMotionText(const ImportRequest& request) {
  std::error_code ignored;
  if (std::filesystem::is_directory(request.file, ignored)) return ReadFolder(request.file);
  const std::string extension = ExtensionOf(request.file);
  const std::vector<std::string>& endings = MotionEndings();
  if (std::find(endings.begin(), endings.end(), extension) == endings.end()) {
    return RefusedMotion(request.file, fmt::format("a file of type '{}' is not a known motion; accepted: {}", extension,
                                                   fmt::join(endings, ", ")));
  }
  MotionText read;
  read.form = FormOf(extension);
  const bool binary = read.form == MotionForm::kNpz || read.form == MotionForm::kRecording;
  Result<std::string> text = binary ? ReadBytes(request.file) : ReadFile(request.file);
  if (!text) return text.failure();
  read.text = std::move(*text);
  if (!binary) {
    const MotionFileKind kind = KindOfText(read.text);
    if (const std::string instead = InsteadOfImport(kind); !instead.empty())
      return RefusedMotion(request.file, fmt::format("is {} of this program: {}", NameOf(kind), instead));
    // Frames of motion_imitation are often in a text file.
    if (HoldsJsonFrames(read.text)) read.form = MotionForm::kTree;
    if (read.form == MotionForm::kTree && (HoldsFootsteps(read.text) || HoldsContactPlan(read.text)))
      read.form = MotionForm::kFootsteps;
  }
  if (read.form != MotionForm::kCsv && !request.columns_file.empty())
    return RefusedMotion(request.file, "--columns is for a CSV file only");
  return read;
}

Result<MotionTable> ReadMotionTable(const RobotModel& model, const MotionText& text, ImportRequest& request) {
  switch (text.form) {
    case MotionForm::kCsv:
      return ReadCsvMotion(model, text.text, request);
    case MotionForm::kNpz:
      return ParseNpzMotion(model, text.text, request.file, request.options);
    case MotionForm::kRecording:
      return ParseRecordedMotion(model, text.text, text.further, request.file, request.options);
    case MotionForm::kBvh:
      return ParseBvhMotion(model, text.text, request.file, request.options);
    case MotionForm::kTree:
    case MotionForm::kFootsteps:
      break;
  }
  return ReadTrajectory(model, text.text, request);
}

EvenMotion EvenMotionOf(const RobotModel& model, const Terrain& terrain, const ImportOptions& asked, MotionTable table,
                        ImportNotes& notes) {
  ImportOptions options = asked;
  notes.derived = table.derived;
  if (options.smoothing_hz == 0.0 && HasFrames(table.format)) options.smoothing_hz = CoarseSmoothingHz(table);
  CheckMotionTable(model, terrain, options, table);
  const bool placed = !table.base_m.empty(), turned = !table.quaternion.empty();
  if (!placed) table.base_m.assign(table.time_s.size(), Vector3::Zero());
  if (!turned) table.quaternion.assign(table.time_s.size(), Eigen::Vector4d(0.0, 0.0, 0.0, 1.0));
  EvenMotion motion = Resample(model, table, options, notes.derived, notes.warnings);
  if (!placed) BlameJoints(model, table, [&] { DeriveBase(model, terrain, options, turned, motion, notes.derived); });
  return motion;
}

}  // namespace gaitwright
