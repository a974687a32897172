// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "cli/helping_rank.h"
#include "cli/interruptible.h"
#include "cli/json_text_internal.h"
#include "cli/options_file.h"
#include "cli/paths.h"
#include "cli/policy_arguments_internal.h"
#include "cli/progress_bar.h"
#include "cli/trials_arguments.h"
#include "cli/walk_arguments.h"
#include "cli/write_results.h"
#include "playback/report/trials_page.h"
#include "workflows/cluster/shared_trials.h"

namespace gaitwright::cli {
namespace {

struct TrialsSettings {
  Common common;
  PolicyArguments input;
  std::string out = "trials.json", report;
  PlayArguments play;
  OptionsFile options;
  DisturbanceArguments disturbances;
  TrialOptions trials;
  std::optional<double> require_survival;
  bool resume = false, show = false;

  std::string SoFar() const { return out + ".so-far"; }
  std::string engine() const { return play.request.play.world.engine; }
  OptionFields Fields() { return Joined({Prefixed("trials", trials.Fields()), play.Fields()}); }
};

int ShowDisturbances(const TrialsSettings& a, const Disturbances& disturbances) {
  const std::string text = DisturbancesText(disturbances);
  if (a.common.json) {
    PrintJson(nlohmann::ordered_json{{"disturbances", text}});
  } else {
    fmt::print("{}", text);
  }
  return kPass;
}

/// A run, and the number of trials in the journal beyond the end of the run.
struct TrialRun {
  RobustnessReport report;
  int beyond = 0;
};

void PrintTrialsQuietly(const TrialsSettings& a, const RobustnessReport& report, bool enough) {
  if (a.require_survival) {
    fmt::print("{}\n", enough ? "pass" : "fail");
  } else {
    fmt::print("{} of {} survived\n", report.survived, report.n);
  }
}

nlohmann::ordered_json TrialsJson(const TrialsSettings& a, const TrialRun& run) {
  auto json = ParsedJson(RobustnessJson(run.report));
  for (const auto& [kind, path] : a.input.Files()) json["files"][kind] = path;
  json["files"]["result"] = a.out;
  if (!a.report.empty()) json["files"]["report"] = a.report;
  if (run.beyond > 0) json["files"]["so_far"] = a.SoFar();
  return json;
}

void PrintTrials(const TrialsSettings& a, const TrialRun& run, bool enough) {
  const RobustnessReport& report = run.report;
  if (a.common.quiet) return PrintTrialsQuietly(a, report, enough);
  fmt::print("{}\nresult  {}\n", RobustnessText(report), a.out);
  if (!a.report.empty()) fmt::print("report  {}\n", a.report);
  if (run.beyond > 0)
    fmt::print("so far  {} more trials are in {}; --resume continues with them\n", run.beyond, a.SoFar());
}

/// Runs the trials, with a journal beside the result and a progress bar.
Result<TrialRun> TrialsWithBar(const TrialsSettings& a, const TrialStudy& study, SharedWork& work) {
  const Interruptible interruptible;
  ProgressBar bar(!a.common.quiet, "trials");
  TrialHooks hooks;
  hooks.journal = a.SoFar();
  hooks.resume = a.resume;
  hooks.stop = [] { return Interruptible::asked(); };
  hooks.progress = [&](const TrialProgress& p) {
    bar.Show({p.done, p.wanted, p.restored},
             Interruptible::asked() ? "ending" : fmt::format("{} fell", p.done - p.survived));
  };
  Result<TrialBook> book = TrialBook::Open(study, a.trials, hooks);
  if (!book) return book.failure();
  Result<RobustnessReport> report = RunSharedTrials(work, study, a.trials, *book);
  if (!report) return report.failure();
  std::vector<OutputFile> files = {{a.out, RobustnessJson(*report)}};
  if (!a.report.empty()) files.push_back({a.report, TrialsPage(*report)});
  const auto written = WriteResults(files, a.SoFar());
  if (!written) return written.failure();
  book->Close();
  return TrialRun{std::move(*report), book->beyond()};
}

/// The requested runs: one, or with `--engine both` one in each engine. The second run has separate files.
std::vector<TrialsSettings> RunsOf(const TrialsSettings& a) {
  if (a.engine() != "both") return {a};
  std::vector<TrialsSettings> runs = {a, a};
  runs[0].play.request.play.world.engine = "bullet";
  runs[1].play.request.play.world.engine = "mujoco";
  runs[1].out = WithSuffix(a.out, "-mujoco");
  runs[1].report = WithSuffix(a.report, "-mujoco");
  return runs;
}

/// Only for the process that writes: the other processes of an MPI run may not see its folders.
void CheckTrialsPaths(const TrialsSettings& a) {
  Paths paths;
  a.input.AddPathsTo(paths);
  if (!a.show) {
    for (const TrialsSettings& run : RunsOf(a)) {
      paths.Write("--out", run.out, {".json"});
      paths.Write("--report", run.report, {".html"});
      paths.Write("the run so far", run.SoFar());
    }
  }
  a.disturbances.AddPathTo(paths);
  a.options.AddPathTo(paths);
  CheckPaths(paths);
}

void CheckShare(const TrialsSettings& a) {
  if (a.require_survival && (*a.require_survival < 0.0 || *a.require_survival > 1.0)) {
    throw InvalidArgument(fmt::format("--require-survival is {}; accepted: 0 to 1", *a.require_survival));
  }
}

/// The files that are read before the first trial.
struct TrialInputs {
  PlayedInput played;
  Disturbances disturbances;

  TrialStudy Study(const PlayRequest& request) const { return {played.model, played.plan, request, disturbances}; }
};

Result<TrialInputs> ReadTrialInputs(TrialsSettings& a) {
  a.trials.seed = a.common.seed;
  const Result<OptionTexts> options = a.options.Apply(a.play.Fields(), a.common);
  if (!options) return options.failure();
  ApplySets("--set", a.common.sets, a.Fields());
  a.play.Finish();
  CheckShare(a);
  a.input.Check();
  Result<PlayedInput> input = a.input.Read();
  if (!input) return input.failure();
  if (input->prepared) UsePolicy(*input->prepared, a.play.request);
  Result<Disturbances> disturbances = a.disturbances.Load(input->model, a.play.request);
  if (!disturbances) return disturbances.failure();
  a.play.CheckActs(a.common.sets, {}, DrawnOptions(*disturbances));
  return TrialInputs{std::move(*input), std::move(*disturbances)};
}

/// See HelpRank0.
std::optional<Failure> HelpWithTrials(TrialsSettings& a, SharedWork& work) {
  const Result<TrialInputs> read = ReadTrialInputs(a);
  if (!read) return read.failure();
  if (a.show) return std::nullopt;
  for (const TrialsSettings& run : RunsOf(a)) ServeTrials(work, read->Study(run.play.request), a.trials);
  return std::nullopt;
}

int RunTrials(TrialsSettings& a) {
  SharedWork work(Ranks::Join());
  if (!work.ranks().leads()) return HelpRank0(work, [&] { return HelpWithTrials(a, work); });
  CheckTrialsPaths(a);
  const Result<TrialInputs> read = ReadTrialInputs(a);
  if (!read) return Report(read.failure(), a.common);
  if (a.show) return ShowDisturbances(a, read->disturbances);
  PrintPolicy(read->played, a.common);
  nlohmann::ordered_json json;
  bool all_enough = true;
  for (const TrialsSettings& one : RunsOf(a)) {
    const Result<TrialRun> run = TrialsWithBar(one, read->Study(one.play.request), work);
    if (!run) {
      const int status = Report(run.failure(), a.common);
      return run.failure().code == FailureCode::kInterrupted ? kInterrupted : status;
    }
    const bool enough = !a.require_survival || run->report.survival.share >= *a.require_survival;
    all_enough = all_enough && enough;
    if (!a.common.json) {
      if (a.engine() == "both") fmt::print("{}{}: ", json.is_null() || a.common.quiet ? "" : "\n", one.engine());
      PrintTrials(one, *run, enough);
    }
    if (json.is_null()) {
      json = TrialsJson(one, *run);
    } else {
      json["second"] = TrialsJson(one, *run);
    }
  }
  if (a.common.json) PrintJson(json);
  return all_enough ? kPass : kVerdictFail;
}

void AddTrialsFlags(Verb verb, TrialsSettings& a) {
  a.input.AddTo(verb);
  verb.SetGroup("Trials");
  AddWholeNumber(verb, "-n,--trials", 1, a.trials.trials, "Number of trials; default 500.");
  a.disturbances.AddTo(verb);
  verb.AddSwitch("--show-disturbances", a.show, "Print the disturbances that would be sampled, as YAML, and exit.");
  AddField(verb, "--until-width", a.trials.Fields(), "until_width");
  AddWholeNumber(verb, "--until-least", 1, a.trials.until_least,
                 "Smallest number of trials before they may stop early; default 50.");
  AddWholeNumber(verb, "--threads", 0, a.trials.threads,
                 "Number of threads, which does not change the result; default 0: one per core.");
  AddNumber(verb, "--require-survival", "SHARE", a.require_survival,
            "Exit with status 3 if the survival rate is below this share (0 to 1); default: not required, and --quiet "
            "prints the number of survivors.");
  a.play.AddTo(verb);
  a.options.AddTo(verb);
  verb.SetGroup("Output");
  AddText(verb, "--out", "FILE", a.out,
          "Write the result to this JSON file; FILE.so-far keeps intermediate results during the run; default "
          "trials.json.");
  AddText(verb, "--report", "FILE", a.report, "Write the report to this HTML file; default: none.");
  verb.AddSwitch("--resume", a.resume, "Continue an interrupted run; the result equals that of an uninterrupted one.");
}

}  // namespace

void AddTrials(Verb program, int& status) {
  auto a = std::make_shared<TrialsSettings>();
  const Verb verb =
      program.AddVerb("trials", "Play a plan or policy many times under disturbances, and report its survival rate");
  AddTrialsFlags(verb, *a);
  AddCommon(verb, a->common,
            {"trials plan.json -n 2 --quiet", "trials plan.json -n 2 --out two.json --report two.html --threads 1",
             "trials plan.json --show-disturbances"});
  AddOptionFlags(verb, a->Fields(), a->common.sets, a->common.json);
  SetWorkInRanks(verb, a->common, status, [a] { return RunTrials(*a); });
}

}  // namespace gaitwright::cli
