// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "cli/flags.h"
#include "cli/motion_source_internal.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/progress_bar.h"
#include "planning/plan/plan_json.h"
#include "workflows/repair/repair_report_internal.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {
namespace {

struct RepairSettings {
  Common common;
  RepairRequest request;
  RobotFlags robot;
  std::string out = "repaired.json";
  bool check = false, no_play = false;
};

int PrintRepair(const RepairResult& result, const std::string& path, const Common& common) {
  if (common.json) {
    fmt::print("{}\n", RepairJson(result, path));
  } else if (common.quiet) {
    fmt::print("{}\n", result.pass() ? "pass" : "fail");
  } else {
    fmt::print("{}{}", RepairText(result), path.empty() ? "" : fmt::format("plan    {}\n", path));
  }
  return result.pass() ? kPass : kVerdictFail;
}

/// Shows a progress bar over the windows of all solves: two solves are usual, more are added when they come.
Result<RepairedMotion> RepairWithBar(const RobotModel& model, const RepairSettings& a,
                                     const std::function<bool(const MotionPlan&)>& proves) {
  ProgressBar bar(!a.common.quiet, "windows");
  RepairRequest request = a.request;
  request.progress = [&](const FollowProgress& p) {
    bar.Show({(p.solve - 1) * p.all + p.done, std::max(2, p.solve) * p.all}, fmt::format("solve {}", p.solve));
  };
  return RepairMotion(model, request, proves);
}

int RunRepair(RepairSettings& a) {
  ApplySets("--set", a.common.sets, a.request.Fields());
  Paths paths;
  AddSourcePaths(a.request.source, a.robot, paths);
  if (!a.check) paths.Write("the plan", a.out, {".json"});
  CheckPaths(paths);
  const Result<RobotModel> model = ReadRobot(a.robot);
  if (!model) return Report(model.failure(), a.common);
  if (a.check) {
    const Result<MotionFindings> findings = ExamineMotion(*model, a.request);
    if (!findings) return Report(findings.failure(), a.common);
    return PrintRepair({*model, *findings}, "", a.common);
  }
  PlayRequest play;
  play.play.world.engine = ProvingEngine();
  std::optional<Result<PlayedWalk>> played;
  const auto proves = [&](const MotionPlan& plan) {
    if (a.no_play) return true;
    played = PlayWalk(*model, plan, play);
    return *played && (*played)->pass();
  };
  const Result<RepairedMotion> repaired = RepairWithBar(*model, a, proves);
  if (!repaired) return Report(repaired.failure(), a.common);
  const Result<std::string> saved = SavePlan(repaired->plan, a.out);
  if (!saved) return Report(saved.failure(), a.common);
  if (a.no_play) return PrintRepair({*model, repaired->findings, &*repaired}, a.out, a.common);
  if (!repaired->was_sound) played = PlayWalk(*model, repaired->plan, play);
  if (!*played) return Report(played->failure(), a.common);
  return PrintRepair({*model, repaired->findings, &*repaired, &**played}, a.out, a.common);
}

}  // namespace

void AddRepair(Verb program, int& status) {
  auto a = std::make_shared<RepairSettings>();
  const Verb verb = program.AddVerb("repair", "Change a motion as little as possible so that the robot can do it");
  AddMotionSource(
      verb, "MOTION",
      "The motion: a CSV with named columns, or frames without names as retargeted data sets have them (.csv, .tsv, "
      ".txt); a ROS joint trajectory (.yaml, .yml, .json); frames of motion_imitation (.txt, .json).",
      a->request.source, a->robot);
  verb.SetGroup("Output");
  AddText(verb, "--out", "FILE", a->out,
          "Plan file to write; its folder is created if missing; default repaired.json.");
  verb.AddSwitch("--check", a->check, "Only say what is wrong with the motion; default: no.");
  verb.AddSwitch("--no-play", a->no_play, "Do not play the plan in physics; default: no.");
  AddCommon(verb, a->common,
            {"repair dance.csv --urdf g1.urdf --out dance.json", "repair pace.txt --robot laikago --check --json"});
  AddOptionList(verb, a->request.Fields(), a->common.json);
  SetWork(verb, a->common, status, [a] { return RunRepair(*a); });
}

}  // namespace gaitwright::cli
