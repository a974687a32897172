// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/explain.h"
#include "cli/options_file.h"
#include "cli/orbit_switch_internal.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/robot_input.h"
#include "cli/walk_arguments.h"

namespace gaitwright::cli {
namespace {

struct WalkSettings {
  Common common;
  WalkArguments walk;
  PlayArguments play;
  OptionsFile options;
  OrbitSwitch orbit;
  Outputs outputs;
  Explain explain;
};

void CheckWalkPaths(const WalkSettings& a) {
  Paths paths;
  a.outputs.AddPathsTo(paths);
  a.walk.robot.AddTo(paths);
  paths.AddGait(a.walk.request.gait);
  paths.AddSequence(a.walk.request.sequence);
  paths.AddTerrain(a.walk.request.terrain);
  a.options.AddPathTo(paths);
  CheckPaths(paths);
}

int RunWalk(WalkSettings& a) {
  a.play.SetDefaults(a.common);
  const OptionFields fields = Joined({a.walk.Fields(), a.play.Fields()});
  const Result<OptionTexts> options = a.options.Apply(fields, a.common);
  if (!options) return Report(options.failure(), a.common);
  ApplySets("--set", a.common.sets, fields);
  a.walk.request.seed = static_cast<std::uint64_t>(a.common.seed);
  CheckWalkPaths(a);
  const Result<RobotModel> model = ReadRobot(a.walk.robot);
  if (!model) return Report(model.failure(), a.common);
  a.walk.Finish(*model);
  a.play.Finish();
  a.play.CheckActs(a.common.sets);
  const Result<PlannedWalk> planned = PlanWalk(*model, a.walk.request, a.explain.target());
  if (!planned) {
    a.explain.PrintRefused();
    return Report(WithDraft(planned.failure(), a.walk.robot, *model), a.common);
  }
  const Result<PlayedWalk> played = PlayWalk(*model, planned->motion.plan, a.play.request);
  if (!played) return Report(played.failure(), a.common);
  const auto orbit = a.orbit.Measure(*model, planned->motion.plan, a.play.request);
  if (!orbit) return Report(orbit.failure(), a.common);
  Judged judged{*model, planned->motion.plan, *played, planned->audit, planned->planning_cpu_s, true};
  if (a.walk.robot.is_file()) judged.mesh_folder = a.walk.robot.folder();
  AddOrbitTo(judged, *orbit);
  const Result<Files> files = WriteOutputs(judged, a.outputs);
  if (!files) return Report(files.failure(), a.common);
  std::vector<std::pair<std::string, std::string>> more;
  if (a.explain.asked) more.emplace_back("tried", a.explain.Json());
  AddOrbitTo(more, *orbit);
  PrintJudged(judged, *files, a.common, more);
  PrintOrbit(*orbit, a.common);
  a.explain.Print(a.common);
  return judged.pass() ? kPass : kVerdictFail;
}

}  // namespace

void AddWalk(Verb program, int& status) {
  auto a = std::make_shared<WalkSettings>();
  const Verb verb = program.AddVerb("walk", "Plan, audit, play and score a walk, and write the report");
  a->outputs.folder = "out";
  a->walk.AddTo(verb);
  a->play.request.play.world.engine = ProvingEngine();
  a->play.AddTo(verb);
  a->options.AddTo(verb);
  a->orbit.AddTo(verb);
  a->outputs.AddTo(verb);
  a->explain.AddTo(verb);
  AddCommon(verb, a->common,
            {"walk --robot a1 --speed 0.3 --distance 1", "walk --robot nao --steps 4 --step-length 0.04 --out-dir nao",
             "walk --sequence 'trot: speed=0.5; stand: duration=1; walk: speed=0.1' --out-dir parts",
             "walk --robot a1 --distance 1 --push 0,30,0 --push-at 2 --quiet"});
  AddOptionFlags(verb, Joined({a->walk.Fields(), a->play.Fields()}), a->common.sets, a->common.json);
  SetWork(verb, a->common, status, [a] { return RunWalk(*a); });
}

}  // namespace gaitwright::cli
