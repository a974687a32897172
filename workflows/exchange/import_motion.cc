// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/import_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "kinematics/base/file.h"
#include "kinematics/base/hash.h"
#include "kinematics/base/text.h"
#include "kinematics/base/version.h"
#include "planning/terrain/load_terrain.h"
#include "workflows/exchange/check_motion_table.h"
#include "workflows/exchange/csv_motion.h"
#include "workflows/exchange/derive_base.h"
#include "workflows/exchange/even_motion.h"
#include "workflows/exchange/footstep_file.h"
#include "workflows/exchange/joint_trajectory.h"
#include "workflows/exchange/motion_file.h"

namespace gaitwright {
namespace {

Failure RefusedMotion(const std::string& file, const std::string& why) {
  return {FailureKind::kBadInput, FailureCode::kImport, "ImportMotion", fmt::format("'{}': {}", file, why), {}};
}

std::string ExtensionOf(const std::string& file) { return LowerCase(std::filesystem::path(file).extension().string()); }

/// Reads the table of a CSV. `request` gets the units of the column-names file.
Result<MotionTable> ReadCsvMotion(const RobotModel& model, const std::string& text, ImportRequest& request) {
  const Result<CsvTable> table = ParseCsvTable(text, request.file);
  if (!table) return table.failure();
  CsvReading reading{request.columns_file, request.options};
  Result<MotionTable> motion = MotionOfCsv(model, *table, reading);
  request.options = reading.options;
  return motion;
}

Result<MotionTable> ReadTrajectory(const RobotModel& model, const std::string& text, const ImportRequest& request) {
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

/// Makes a plan from a table.
void MakePlan(const RobotModel& model, const Terrain& terrain, const ImportRequest& request, MotionTable table,
              ImportedMotion& imported) {
  imported.format = table.format;
  imported.rows = table.rows();
  imported.unused_columns = table.unused_columns;
  imported.notes.derived = table.derived;
  CheckMotionTable(model, terrain, request.options, table);
  const bool placed = !table.base_m.empty(), turned = !table.quaternion.empty();
  if (!placed) table.base_m.assign(table.time_s.size(), Vector3::Zero());
  if (!turned) table.quaternion.assign(table.time_s.size(), Eigen::Vector4d(0.0, 0.0, 0.0, 1.0));
  EvenMotion motion = Resample(model, table, request.options, imported.notes.derived, imported.notes.warnings);
  BlameJoints(model, table, [&] {
    if (!placed) DeriveBase(model, terrain, request.options, turned, motion, imported.notes.derived);
    imported.plan = PlanOfMotion(model, terrain, std::move(motion), request.options, request.goal, imported.notes);
  });
}

Provenance ProvenanceOf(ImportRequest request, const ImportedMotion& imported, const std::string& text) {
  Provenance provenance{Version(), "ImportMotion", {}, 0};
  provenance.options = {{"format", imported.format}, {"source_hash", HexHash(text)}};
  const OptionTexts options =
      imported.format == "footsteps" ? TextsOf(request.motion.Fields()) : TextsOf(request.options.Fields());
  provenance.options.insert(provenance.options.end(), options.begin(), options.end());
  return provenance;
}

/// Adds the notes on derived data and oddities to the plan's warnings.
void WarnInPlan(ImportedMotion& imported) {
  std::vector<std::string>& warnings = imported.plan.warnings;
  for (const DerivedPart& part : imported.notes.derived)
    warnings.push_back(fmt::format("derived, {}: {}", part.what, part.how));
  warnings.insert(warnings.end(), imported.notes.warnings.begin(), imported.notes.warnings.end());
}

}  // namespace

Result<ImportedMotion> ImportMotionOn(const RobotModel& model, const Terrain& terrain, const ImportRequest& asked) {
  ImportRequest request = asked;
  CheckOptions(request.Fields());
  CheckImportOptions(request.options);
  std::error_code ignored;
  if (std::filesystem::is_directory(request.file, ignored))
    return RefusedMotion(request.file, "is a folder; give a file, such as a .csv or .yaml");
  const std::string extension = ExtensionOf(request.file);
  const bool csv = extension == ".csv" || extension == ".tsv" || extension == ".txt";
  const bool yaml = extension == ".yaml" || extension == ".yml" || extension == ".json";
  if (!csv && !yaml) {
    return RefusedMotion(
        request.file,
        fmt::format("a file of type '{}' is not a known motion; accepted: .csv, .tsv, .txt, .yaml, .yml, .json",
                    extension));
  }
  if (!csv && !request.columns_file.empty()) return RefusedMotion(request.file, "--columns is for a CSV file only");
  const Result<std::string> text = ReadFile(request.file);
  if (!text) return text.failure();
  const MotionFileKind kind = KindOfText(*text);
  if (const std::string instead = InsteadOfImport(kind); !instead.empty())
    return RefusedMotion(request.file, fmt::format("is {} of this program: {}", NameOf(kind), instead));
  ImportedMotion imported;
  try {
    if (yaml && HoldsFootsteps(*text)) {
      if (auto failure = PlanFootstepFile(model, terrain, *text, request, imported)) return *failure;
    } else {
      Result<MotionTable> table = csv ? ReadCsvMotion(model, *text, request) : ReadTrajectory(model, *text, request);
      if (!table) return table.failure();
      MakePlan(model, terrain, request, std::move(*table), imported);
    }
  } catch (const InvalidArgument& error) {
    return RefusedMotion(request.file, error.what());
  }
  imported.plan.provenance = ProvenanceOf(request, imported, *text);
  WarnInPlan(imported);
  const Result<AuditReport> audit = Audit(model, imported.plan, {});
  if (!audit) return audit.failure();
  imported.audit = *audit;
  return imported;
}

Result<ImportedMotion> ImportMotion(const RobotModel& model, const ImportRequest& request) {
  const Result<Terrain> terrain = LoadTerrain(request.terrain, ScaleOf(model));
  if (!terrain) return terrain.failure();
  return ImportMotionOn(model, *terrain, request);
}

}  // namespace gaitwright
