// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "cli/interruptible.h"
#include "cli/progress_bar.h"
#include "cli/study_arguments.h"
#include "cli/write_results.h"
#include "workflows/study/tune_files.h"

namespace gaitwright::cli {
namespace {

struct TuneSettings {
  Common common;
  StudyArguments study;
  TuneOptions tune;
  std::string out = "tuned.yaml", result, report;

  std::string SoFar() const { return out + ".so-far"; }
};

void CheckTunePaths(const TuneSettings& a) {
  Paths paths = a.study.PathsToRead();
  paths.Write("--out", a.out, {".yaml"});
  paths.Write("--result", a.result, {".json"});
  paths.Write("--report", a.report, {".html"});
  paths.Write("the tuning so far", a.SoFar());
  CheckPaths(paths);
}

Result<Study> TuneStudy(TuneSettings& a) {
  const std::vector<StudyAxis> axes = ParseAxes(a.study.over, StudyLayout::kTuning);
  CheckTunable(axes);
  const Result<OptionTexts> options = a.study.Finish(axes, a.common);
  if (!options) return options.failure();
  Result<RobotModel> model = a.study.FinishFor(axes);
  if (!model) return model.failure();
  return Study{std::move(*model), a.study.walk.request, a.study.play.request, axes, {}, {}, a.tune.trials, {}};
}

Result<TuneReport> TuneWithBar(const TuneSettings& a, const Study& study, JobJournal& journal) {
  const Interruptible interruptible;
  ProgressBar bar(!a.common.quiet, "jobs");
  const int before = static_cast<int>(journal.found());
  const auto show = [&](std::size_t done, std::size_t of) {
    bar.Show({static_cast<int>(std::min(done, of)), static_cast<int>(of), before},
             Interruptible::asked() ? "ending" : "");
  };
  return Tune(study, a.tune, journal, {a.study.threads, show, Interruptible::asked});
}

Result<WrittenFiles> WriteTuned(const TuneSettings& a, const Study& study, const TuneReport& report) {
  WrittenFiles files = {{"options", a.out}};
  if (!a.result.empty()) files.emplace_back("result", a.result);
  if (!a.report.empty()) files.emplace_back("report", a.report);
  std::vector<OutputFile> texts = {{a.out, TunedOptions(study, report.result)}};
  if (!a.result.empty()) texts.push_back({a.result, TuneJson(study, report, a.tune, files)});
  if (!a.report.empty()) texts.push_back({a.report, TunePage(study, report, a.tune)});
  const auto written = WriteResults(texts, a.SoFar());
  if (!written) return written.failure();
  return files;
}

int RunTune(TuneSettings& a) {
  CheckTunePaths(a);
  Result<Study> study = TuneStudy(a);
  if (!study) return Report(study.failure(), a.common);
  const Result<Disturbances> disturbances = a.study.disturbances.Load(study->model, study->play, KeysOf(study->axes));
  if (!disturbances) return Report(disturbances.failure(), a.common);
  a.study.play.CheckActs(a.common.sets, KeysOf(study->axes), DrawnOptions(*disturbances));
  study->play_trial = PlayerOf(*disturbances, a.common.seed);
  const std::string identity = TuneIdentity(*study, a.tune, DisturbancesText(*disturbances));
  Result<JobJournal> journal = JobJournal::Open(a.SoFar(), identity, a.study.resume);
  if (!journal) return Report(journal.failure(), a.common);
  const Result<TuneReport> report = TuneWithBar(a, *study, *journal);
  if (!report) {
    const bool interrupted = report.failure().code == FailureCode::kInterrupted;
    if (!interrupted) journal->Remove();
    const int status = Report(report.failure(), a.common);
    return interrupted ? kInterrupted : status;
  }
  const Result<WrittenFiles> files = WriteTuned(a, *study, *report);
  if (!files) return Report(files.failure(), a.common);
  journal->Remove();
  if (a.common.json) {
    fmt::print("{}", TuneJson(*study, *report, a.tune, *files));
  } else if (a.common.quiet) {
    fmt::print("{}\n", report->result.better() ? "better" : "no better");
  } else {
    fmt::print("{}\n", TuneText(*study, *report, a.tune));
    for (const auto& [kind, path] : *files) fmt::print("{:<7} {}\n", kind, path);
  }
  return kPass;
}

void AddTuneFlags(Verb verb, TuneSettings& a) {
  a.study.AddTo(verb,
                "An option and its range, as KEY=FROM:TO; may be repeated. KEY is a numeric key of --list-options=all, "
                "except play.*, sensors.* and score.*; default: none.");
  const OptionFields fields = a.tune.Fields();
  verb.SetGroup("Search");
  AddField(verb, "--evaluations", fields, "evaluations");
  AddField(verb, "--trials", fields, "trials");
  AddField(verb, "--finalists", fields, "finalists");
  AddField(verb, "--held-out", fields, "held_out");
  AddField(verb, "--survival-weight", fields, "survival_weight");
  AddField(verb, "--search-method", fields, "method");
  AddField(verb, "--smooth-above", fields, "smooth_above");
  a.study.disturbances.AddTo(verb);
  a.study.AddWorkTo(verb);
  verb.SetGroup("Output");
  AddText(verb, "--out", "FILE", a.out,
          "Write the tuned options to this file, for --options of walk, plan, play and trials; FILE.so-far keeps "
          "intermediate results during the run; default tuned.yaml.");
  AddText(verb, "--result", "FILE", a.result, "Write the JSON result to this file; default: none.");
  AddText(verb, "--report", "FILE", a.report, "Write the report to this HTML file; default: none.");
}

}  // namespace

void AddTune(Verb program, int& status) {
  auto a = std::make_shared<TuneSettings>();
  const Verb verb = program.AddVerb("tune", "Find better values of options, and test them on held-out trials");
  AddTuneFlags(verb, *a);
  AddCommon(verb, a->common,
            {"tune --distance 0.3 --over stabilised.dcm_gain=1:2 --evaluations 2 --trials 1 --held-out 6"});
  AddOptionFlags(verb, a->study.Fields(), a->common.sets, a->common.json);
  SetWork(verb, a->common, status, [a] { return RunTune(*a); });
}

}  // namespace gaitwright::cli
