// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/explain.h"
#include "cli/finish_json_internal.h"
#include "cli/json_text_internal.h"
#include "cli/options_file.h"
#include "cli/paths.h"
#include "cli/robot_input.h"
#include "cli/walk_arguments.h"
#include "planning/plan/parts_text.h"
#include "planning/plan/plan_json.h"

namespace gaitwright::cli {
namespace {

struct PlanSettings {
  Common common;
  WalkArguments walk;
  OptionsFile options;
  std::string out = "plan.json", folder;
  Explain explain;
};

void PrintPlanned(const PlannedWalk& planned, const std::string& path, const Explain& explain, const Common& common) {
  if (common.json) {
    nlohmann::ordered_json parts = nlohmann::ordered_json::array();
    for (const MotionPart& part : planned.motion.plan.parts)
      parts.push_back({{"gait", part.gait.name}, {"start_s", part.start_s}, {"end_s", part.end_s}});
    nlohmann::ordered_json json = {{"robot", planned.motion.plan.robot},
                                   {"verdict", planned.audit.pass() ? "pass" : "fail"},
                                   {"gait", GaitNames(planned.motion.plan.parts)},
                                   {"parts", parts},
                                   {"duration_s", planned.motion.plan.duration_s()},
                                   {"footholds", planned.motion.plan.footsteps.footholds.size()},
                                   {"zmp_error_max_m", planned.motion.zmp_error_max_m},
                                   {"residual", planned.motion.residual},
                                   {"whole_body", FinishJson(planned.motion.finished)},
                                   {"planning_cpu_s", planned.planning_cpu_s},
                                   {"warnings", planned.motion.plan.warnings},
                                   {"adjustments", ParsedJson(AdjustmentsJson(planned.motion.plan.adjustments))},
                                   {"audit", ParsedJson(AuditJson(planned.audit))},
                                   {"files", {{"plan", path}}}};
    if (explain.asked) json["tried"] = ParsedJson(explain.Json());
    PrintJson(json);
    return;
  }
  if (common.quiet) {
    fmt::print("{}\n", planned.audit.pass() ? "pass" : "fail");
    return;
  }
  fmt::print("{} {}: {}\nplanned in {:.2f} s of CPU\n", planned.motion.plan.robot, GaitNames(planned.motion.plan.parts),
             planned.motion.summary, planned.planning_cpu_s);
  if (const std::string parts = PartsText(planned.motion.plan.parts); !parts.empty()) fmt::print("parts: {}\n", parts);
  for (const Adjustment& adjustment : planned.motion.plan.adjustments)
    fmt::print("adjusted: {}\n", AdjustmentText(adjustment));
  for (const std::string& warning : planned.motion.plan.warnings) fmt::print("warning: {}\n", warning);
  fmt::print("{}", AuditText(planned.audit));
  fmt::print("plan    {}\n", path);
  explain.Print(common);
}

int RunPlan(PlanSettings& a) {
  const Result<OptionTexts> options = a.options.Apply(a.walk.Fields(), a.common);
  if (!options) return Report(options.failure(), a.common);
  ApplySets("--set", a.common.sets, a.walk.Fields());
  a.walk.request.seed = static_cast<std::uint64_t>(a.common.seed);
  const std::string path = a.folder.empty() ? a.out : (std::filesystem::path(a.folder) / "plan.json").string();
  Paths paths;
  paths.Write(a.folder.empty() ? "--out" : "the plan of --out-dir", path, {".json"});
  a.walk.robot.AddTo(paths);
  paths.AddGait(a.walk.request.gait);
  paths.AddSequence(a.walk.request.sequence);
  paths.AddTerrain(a.walk.request.terrain);
  a.options.AddPathTo(paths);
  CheckPaths(paths);
  const Result<RobotModel> model = ReadRobot(a.walk.robot);
  if (!model) return Report(model.failure(), a.common);
  a.walk.Finish(*model);
  const Result<PlannedWalk> planned = PlanWalk(*model, a.walk.request, a.explain.target());
  if (!planned) {
    a.explain.PrintRefused();
    return Report(WithDraft(planned.failure(), a.walk.robot, *model), a.common);
  }
  const Result<std::string> saved = SavePlan(planned->motion.plan, path);
  if (!saved) return Report(saved.failure(), a.common);
  PrintPlanned(*planned, path, a.explain, a.common);
  return planned->audit.pass() ? kPass : kVerdictFail;
}

}  // namespace

void AddPlan(Verb program, int& status) {
  auto a = std::make_shared<PlanSettings>();
  const Verb verb = program.AddVerb("plan", "Plan a walk, audit it and write it to a file");
  a->walk.AddTo(verb);
  a->options.AddTo(verb);
  verb.SetGroup("Output");
  const Flag out = AddText(verb, "--out", "FILE", a->out,
                           "Plan file to write; its folder is created if missing; default plan.json.");
  AddText(verb, "--out-dir", "FOLDER", a->folder, "Folder for plan.json, instead of --out; default: as --out.")
      .Exclude(out);
  a->explain.AddTo(verb);
  AddCommon(verb, a->common,
            {"plan --robot a1 --gait trot --speed 0.3 --distance 1 --out plan.json", "plan --goal 1,0.5,0.7 --json",
             "plan --sequence 'walk: speed=0.1, distance=0.3; trot: speed=0.4' --out parts.json"});
  AddOptionFlags(verb, a->walk.Fields(), a->common.sets, a->common.json);
  SetWork(verb, a->common, status, [a] { return RunPlan(*a); });
}

}  // namespace gaitwright::cli
