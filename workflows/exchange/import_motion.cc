// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/import_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "kinematics/base/version.h"
#include "planning/terrain/load_terrain.h"
#include "workflows/exchange/check_motion_table.h"
#include "workflows/exchange/footstep_file.h"
#include "workflows/exchange/read_motion_internal.h"

namespace gaitwright {
namespace {

/// Makes a plan from a table.
void MakePlan(const RobotModel& model, const Terrain& terrain, const ImportRequest& request, const MotionTable& table,
              ImportedMotion& imported) {
  imported.format = table.format;
  imported.rows = table.rows();
  imported.unused_columns = table.unused_columns;
  EvenMotion motion = EvenMotionOf(model, terrain, request.options, table, imported.notes);
  BlameJoints(model, table, [&] {
    imported.plan = PlanOfMotion(model, terrain, std::move(motion), request.options, request.goal, imported.notes);
  });
}

Provenance ProvenanceOf(ImportRequest request, const ImportedMotion& imported, const std::string& hash) {
  Provenance provenance{Version(), "ImportMotion", {}, 0};
  provenance.options = {{"format", MotionFormatName(imported.format)}, {"source_hash", hash}};
  const OptionTexts options = imported.format == MotionFormat::kFootsteps ? TextsOf(request.motion.Fields())
                                                                          : TextsOf(request.options.Fields());
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
  const Result<MotionText> text = ReadMotionText(request);
  if (!text) return text.failure();
  ImportedMotion imported;
  try {
    if (text->form == MotionForm::kFootsteps) {
      if (auto failure = PlanFootstepFile(model, terrain, text->text, request, imported)) return *failure;
    } else {
      Result<MotionTable> table = ReadMotionTable(model, *text, request);
      if (!table) return table.failure();
      MakePlan(model, terrain, request, *table, imported);
    }
  } catch (const InvalidArgument& error) {
    return RefusedMotion(request.file, error.what());
  }
  imported.plan.provenance = ProvenanceOf(request, imported, text->Hash());
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
