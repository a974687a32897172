// SPDX-License-Identifier: BSD-3-Clause
#include "cli/options_file.h"
#include "cli/orbit_switch_internal.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/policy_arguments_internal.h"
#include "cli/trials_arguments.h"
#include "cli/walk_arguments.h"
#include "workflows/study/trial.h"

namespace gaitwright::cli {
namespace {

struct PlaySettings {
  Common common;
  PolicyArguments input;
  PlayArguments play;
  OptionsFile options;
  DisturbanceArguments disturbances;
  Outputs outputs;
  OrbitSwitch orbit;
};

/// Plays the plan, under the disturbances of one trial if they are given.
Result<PlayedWalk> PlayAsAsked(PlaySettings& a, const RobotModel& model, const MotionPlan& plan) {
  if (a.disturbances.file.empty()) return PlayWalk(model, plan, a.play.request);
  const Result<Disturbances> disturbances = a.disturbances.Load(model, a.play.request);
  if (!disturbances) return disturbances.failure();
  a.play.CheckActs(a.common.sets, {}, DrawnOptions(*disturbances));
  Result<PlayedTrial> trial =
      PlayTrial({model, plan, a.play.request, *disturbances}, 0, static_cast<std::uint64_t>(a.common.seed));
  if (!trial) return trial.failure();
  return std::move(trial->played);
}

int RunPlay(PlaySettings& a) {
  a.play.SetDefaults(a.common);
  const Result<OptionTexts> options = a.options.Apply(a.play.Fields(), a.common);
  if (!options) return Report(options.failure(), a.common);
  ApplySets("--set", a.common.sets, a.play.Fields());
  a.play.Finish();
  a.input.Check();
  if (a.orbit.asked && a.input.is_policy())
    throw InvalidArgument("--orbit needs a plan, because a policy has no planned cycles");
  if (a.orbit.asked && !a.disturbances.file.empty())
    throw InvalidArgument("--orbit measures the gait without the disturbances of a trial; leave out --disturbances");
  Paths paths;
  a.input.AddPathsTo(paths);
  paths.Write("--log", a.outputs.log, {".json"});
  if (a.play.request.play.world.engine == "both") a.outputs.second_log = WithSuffix(a.outputs.log, "-mujoco");
  paths.Write("the second log of --log", a.outputs.second_log, {".json"});
  paths.Write("--report", a.outputs.report, {".html"});
  paths.plot_folder = a.outputs.plot_folder;
  a.disturbances.AddPathTo(paths);
  a.options.AddPathTo(paths);
  CheckPaths(paths);
  const Result<PlayedInput> input = a.input.Read();
  if (!input) return Report(input.failure(), a.common);
  if (input->prepared) UsePolicy(*input->prepared, a.play.request);
  if (a.disturbances.file.empty()) a.play.CheckActs(a.common.sets);
  PrintPolicy(*input, a.common);
  const Result<AuditReport> audit = AuditOf(*input);
  if (!audit) return Report(audit.failure(), a.common);
  const Result<PlayedWalk> played = PlayAsAsked(a, input->model, input->plan);
  if (!played) return Report(played.failure(), a.common);
  const auto orbit = a.orbit.Measure(input->model, input->plan, a.play.request);
  if (!orbit) return Report(orbit.failure(), a.common);
  Judged judged{input->model, input->plan, *played, *audit};
  AddOrbitTo(judged, *orbit);
  Result<Files> files = WriteOutputs(judged, a.outputs);
  if (!files) return Report(files.failure(), a.common);
  const Files read = a.input.Files();
  files->insert(files->begin(), read.begin(), read.end());
  std::vector<std::pair<std::string, std::string>> more;
  if (input->prepared) more.emplace_back("policy", PolicyJson(input->model, *input->prepared->policy));
  AddOrbitTo(more, *orbit);
  PrintJudged(judged, *files, a.common, more);
  PrintOrbit(*orbit, a.common);
  return judged.pass() ? kPass : kVerdictFail;
}

}  // namespace

void AddPlay(Verb program, int& status) {
  auto a = std::make_shared<PlaySettings>();
  const Verb verb = program.AddVerb("play", "Play a plan, or a learned policy, in physics and score it");
  a->outputs = {"", "", "", "", "", ""};
  a->input.AddTo(verb);
  a->play.AddTo(verb);
  a->options.AddTo(verb);
  verb.SetGroup("Playback and disturbances");
  a->disturbances.AddTo(verb, "none; with it, this plays the trial of --seed");
  a->orbit.AddTo(verb);
  verb.SetGroup("Output");
  AddText(verb, "--log", "FILE", a->outputs.log, "Write the log to this JSON file; default: none.");
  AddText(verb, "--report", "FILE", a->outputs.report, "Write the report to this HTML file; default: none.");
  AddText(verb, "--plot-dir", "FOLDER", a->outputs.plot_folder,
          "Write the plots into this folder, as SVG files; default: none.");
  AddCommon(
      verb, a->common,
      {"play plan.json --report report.html", "play plan.json --push 0,20,0 --push-at 1.5 --friction 0.6 --json"});
  AddOptionFlags(verb, a->play.Fields(), a->common.sets, a->common.json);
  SetWork(verb, a->common, status, [a] { return RunPlay(*a); });
}

}  // namespace gaitwright::cli
