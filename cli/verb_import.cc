// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/robot_input.h"
#include "planning/plan/plan_json.h"
#include "workflows/exchange/import_motion.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {
namespace {

struct Arguments {
  Common common;
  ImportRequest request;
  std::string robot = "a1", urdf, goal, out = "imported.json";
};

nlohmann::ordered_json JsonOf(const ImportedMotion& imported, const std::string& path) {
  nlohmann::ordered_json derived = nlohmann::ordered_json::array();
  for (const DerivedPart& part : imported.notes.derived) derived.push_back({{"what", part.what}, {"how", part.how}});
  return {{"robot", imported.plan.robot},
          {"verdict", imported.audit.pass() ? "pass" : "fail"},
          {"format", imported.format},
          {"rows", imported.rows},
          {"duration_s", imported.plan.duration_s()},
          {"footholds", imported.plan.footsteps.footholds.size()},
          {"derived", derived},
          {"unused_columns", imported.unused_columns},
          {"warnings", imported.notes.warnings},
          {"audit", nlohmann::ordered_json::parse(AuditJson(imported.audit))},
          {"files", {{"plan", path}}}};
}

void Print(const ImportedMotion& imported, const std::string& path, const Common& common) {
  if (common.json) {
    fmt::print("{}\n", JsonOf(imported, path).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return;
  }
  if (common.quiet) {
    fmt::print("{}\n", imported.audit.pass() ? "pass" : "fail");
    return;
  }
  fmt::print("{}: {} rows of {}, {:.3f} s, {} footholds\n", imported.plan.robot, imported.rows, imported.format,
             imported.plan.duration_s(), imported.plan.footsteps.footholds.size());
  for (const DerivedPart& part : imported.notes.derived) fmt::print("derived: {}: {}\n", part.what, part.how);
  for (const std::string& column : imported.unused_columns) fmt::print("not used: {}\n", column);
  for (const std::string& warning : imported.notes.warnings) fmt::print("warning: {}\n", warning);
  fmt::print("{}plan    {}\n", AuditText(imported.audit), path);
}

int Run(Arguments& a) {
  ApplySets("--set", a.common.sets, a.request.Fields());
  if (!a.goal.empty()) {
    const std::vector<double> pose = ParseNumbers("--goal", a.goal, 3);
    a.request.goal = PlanarPose{pose[0], pose[1], pose[2]};
  }
  Paths paths{
      {{"the motion", a.request.file}, {"--columns", a.request.columns_file}}, {{"the plan", a.out, {".json"}}}, ""};
  paths.AddRobotAndGait(a.urdf, "");
  paths.AddTerrain(a.request.terrain);
  CheckPaths(paths);
  const Result<RobotModel> model = ReadRobot(a.robot, a.urdf);
  if (!model) return Report(model.failure(), a.common);
  const Result<ImportedMotion> imported = ImportMotion(*model, a.request);
  if (!imported) return Report(imported.failure(), a.common);
  const Result<std::string> saved = SavePlan(imported->plan, a.out);
  if (!saved) return Report(saved.failure(), a.common);
  Print(*imported, a.out, a.common);
  return imported->audit.pass() ? kPass : kVerdictFail;
}

}  // namespace

void AddImport(CLI::App& app, int& status) {
  auto a = std::make_shared<Arguments>();
  CLI::App& verb = *app.add_subcommand("import", "Make a plan of a motion that others made, and audit it");
  AddText(verb, "FILE", "FILE", a->request.file,
          "The motion: a CSV with named columns, or one of OCS2 (.csv, .tsv, .txt); a joint trajectory of ROS, or "
          "footsteps (.yaml, .yml, .json).")
      ->required();
  verb.option_defaults()->group("Robot and ground");
  CLI::Option* named =
      AddText(verb, "--robot", "NAME", a->robot, "Robot by name, see 'gaitwright robots'; default a1.");
  AddText(verb, "--urdf", "FILE", a->urdf, "A URDF file of your own; default: the robot of --robot.")->excludes(named);
  AddText(verb, "--terrain", "NAME", a->request.terrain,
          "Ground that it goes over, by name or a file, see 'gaitwright terrains'; default flat.");
  verb.option_defaults()->group("How the file is read");
  AddText(verb, "--columns", "FILE", a->request.columns_file,
          "A YAML that says how the CSV's columns are called, see docs/import.md; default: as its first line says.");
  const OptionFields fields = a->request.Fields();
  AddField(verb, "--quaternion-order", fields, "quaternion_order");
  AddField(verb, "--angle-unit", fields, "angle_unit");
  AddField(verb, "--length-unit", fields, "length_unit");
  AddField(verb, "--time-unit", fields, "time_unit");
  AddText(verb, "--goal", "x,y,yaw", a->goal,
          "Where it was to end, in m, m and rad from its start; default: where it ends.");
  verb.option_defaults()->group("What is written");
  AddText(verb, "--out", "FILE", a->out, "The plan, its folder made if need be; default imported.json.");
  AddCommon(verb, a->common,
            {"import motion.csv --robot a1 --out theirs.json", "import motion.csv --set velocities=derived --json"});
  AddOptionList(verb, a->request.Fields(), a->common.json);
  verb.callback([a, &status] { status = Guarded(a->common, [&] { return Run(*a); }); });
}

}  // namespace gaitwright::cli
