// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "cli/motion_source_internal.h"
#include "cli/numbers.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "planning/audit/broken_time_internal.h"
#include "planning/plan/plan_json.h"
#include "workflows/exchange/import_motion.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {
namespace {

struct ImportSettings {
  Common common;
  ImportRequest request;
  RobotFlags robot;
  std::string goal, out = "imported.json";
};

nlohmann::ordered_json ImportedJson(const ImportedMotion& imported, const std::vector<BrokenTime>& broken,
                                    const std::string& path) {
  nlohmann::ordered_json derived = nlohmann::ordered_json::array();
  for (const DerivedPart& part : imported.notes.derived) derived.push_back({{"what", part.what}, {"how", part.how}});
  return {{"robot", imported.plan.robot},
          {"verdict", imported.audit.pass() ? "pass" : "fail"},
          {"format", MotionFormatName(imported.format)},
          {"rows", imported.rows},
          {"duration_s", imported.plan.duration_s()},
          {"footholds", imported.plan.footsteps.footholds.size()},
          {"derived", derived},
          {"unused_columns", imported.unused_columns},
          {"warnings", imported.notes.warnings},
          {"audit", ParsedJson(AuditJson(imported.audit))},
          {"broken", ParsedJson(BrokenJson(broken))},
          {"files", {{"plan", path}}}};
}

void PrintImported(const ImportedMotion& imported, const std::vector<BrokenTime>& broken, const std::string& path,
                   const Common& common) {
  if (common.json) {
    PrintJson(ImportedJson(imported, broken, path));
    return;
  }
  if (common.quiet) {
    fmt::print("{}\n", imported.audit.pass() ? "pass" : "fail");
    return;
  }
  fmt::print("{}: {} rows of {}, {:.3f} s, {} footholds\n", imported.plan.robot, imported.rows,
             MotionFormatName(imported.format), imported.plan.duration_s(), imported.plan.footsteps.footholds.size());
  for (const DerivedPart& part : imported.notes.derived) fmt::print("derived: {}: {}\n", part.what, part.how);
  for (const std::string& column : imported.unused_columns) fmt::print("not used: {}\n", column);
  for (const std::string& warning : imported.notes.warnings) fmt::print("warning: {}\n", warning);
  fmt::print("{}{}plan    {}\n", AuditText(imported.audit), BrokenText(broken), path);
}

int RunImport(ImportSettings& a) {
  ApplySets("--set", a.common.sets, a.request.Fields());
  if (!a.goal.empty()) {
    const std::vector<double> pose = ParseNumbers("--goal", a.goal, 3);
    a.request.goal = PlanarPose{pose[0], pose[1], pose[2]};
  }
  Paths paths;
  AddSourcePaths(a.request, a.robot, paths);
  paths.Write("the plan", a.out, {".json"});
  CheckPaths(paths);
  const Result<RobotModel> model = ReadRobot(a.robot);
  if (!model) return Report(model.failure(), a.common);
  const Result<ImportedMotion> imported = ImportMotion(*model, a.request);
  if (!imported) return Report(imported.failure(), a.common);
  const Result<std::string> saved = SavePlan(imported->plan, a.out);
  if (!saved) return Report(saved.failure(), a.common);
  std::vector<BrokenTime> broken;
  if (!imported->audit.pass()) {
    const Result<AuditReport> again = AuditOverTime(*model, imported->plan, {}, broken);
    if (!again) return Report(again.failure(), a.common);
  }
  PrintImported(*imported, broken, a.out, a.common);
  return imported->audit.pass() ? kPass : kVerdictFail;
}

}  // namespace

void AddImport(Verb program, int& status) {
  auto a = std::make_shared<ImportSettings>();
  const Verb verb = program.AddVerb("import", "Turn a motion of other software into a plan, and audit it");
  AddMotionSource(
      verb, "FILE",
      "The motion: a CSV with named columns, from OCS2, or with frames without names (.csv, .tsv, .txt); a ROS joint "
      "trajectory or footsteps (.yaml, .yml, .json); frames of motion_imitation (.txt, .json); arrays of NumPy "
      "(.npz); a recording of ROS 2 (.mcap, .db3, or the folder of a bag); a skeleton with the robot's joints (.bvh); "
      "frames "
      "of DeepMimic (.json, .txt).",
      a->request, a->robot);
  AddText(verb, "--goal", "x,y,yaw", a->goal,
          "Intended end pose, in m, m and rad from the start; default: the end of the motion.");
  verb.SetGroup("Output");
  AddText(verb, "--out", "FILE", a->out,
          "Plan file to write; its folder is created if missing; default imported.json.");
  AddCommon(verb, a->common,
            {"import motion.csv --robot a1 --out theirs.json", "import motion.csv --set velocities=derived --json"});
  AddOptionFlags(verb, a->request.Fields(), a->common.sets, a->common.json);
  SetWork(verb, a->common, status, [a] { return RunImport(*a); });
}

}  // namespace gaitwright::cli
