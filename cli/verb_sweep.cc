// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "cli/helping_rank.h"
#include "cli/interruptible.h"
#include "cli/progress_bar.h"
#include "cli/study_arguments.h"
#include "cli/write_results.h"
#include "planning/plan/plan_json.h"
#include "playback/score/gates.h"
#include "workflows/cluster/shared_sweep.h"
#include "workflows/study/study_page.h"
#include "workflows/study/sweep_files.h"

namespace gaitwright::cli {
namespace {

struct SweepSettings {
  Common common;
  StudyArguments study;
  std::optional<int> samples;
  int trials = 0;
  std::string metrics =
      "goal_error_m, zmp_margin_p05_m, dcm_capture_margin_min_m, slip_max_step_m, torque_use_max, cost_of_transport";
  std::string out = "sweep.csv", report, map, best;

  std::string SoFar() const { return out + ".so-far"; }
};

/// The keys of --metrics. @throws InvalidArgument for an unknown key; the message names the nearest one.
std::vector<std::string> MetricKeys(const std::string& text) {
  std::vector<std::string> keys;
  std::istringstream stream(text);
  while ((stream >> std::ws).good()) {
    std::string key;
    std::getline(stream, key, ',');
    keys.push_back(RuleOf(key).key);
  }
  return keys;
}

/// Only for the process that writes: the other processes of an MPI run may not see its folders.
void CheckSweepPaths(const SweepSettings& a) {
  Paths paths = a.study.PathsToRead();
  paths.Write("--out", a.out, {".csv"});
  paths.Write("--report", a.report, {".html"});
  paths.Write("--map", a.map, {".svg"});
  paths.Write("--best", a.best, {".json"});
  paths.Write("the sweep so far", a.SoFar());
  CheckPaths(paths);
}

Result<Study> SweepStudy(SweepSettings& a) {
  const StudyLayout layout = a.samples ? StudyLayout::kSamples : StudyLayout::kGrid;
  const std::vector<StudyAxis> axes = ParseAxes(a.study.over, layout);
  const Result<OptionTexts> options = a.study.Finish(axes, a.common);
  if (!options) return options.failure();
  for (const std::string& key : KeysOf(axes)) {
    if (std::any_of(options->begin(), options->end(), [&](const auto& option) { return option.first == key; }))
      throw InvalidArgument(fmt::format("--options sets what --over {} varies; leave one of them out", key));
  }
  Result<RobotModel> model = a.study.FinishFor(axes);
  if (!model) return model.failure();
  Study study{
      std::move(*model), a.study.walk.request, a.study.play.request, axes, {}, MetricKeys(a.metrics), a.trials, {}};
  study.points =
      a.samples ? SampledPoints(axes, static_cast<std::size_t>(*a.samples), study.walk.seed) : GridPoints(axes);
  return study;
}

Result<Disturbances> PrepareTrials(SweepSettings& a, Study& study) {
  Result<Disturbances> disturbances = a.study.disturbances.Load(study.model, study.play, KeysOf(study.axes));
  if (!disturbances) return disturbances;
  a.study.play.CheckActs(a.common.sets, KeysOf(study.axes), DrawnOptions(*disturbances));
  study.play_trial = PlayerOf(*disturbances, a.common.seed);
  return disturbances;
}

/// The study, and a text that identifies its work.
struct SweepInputs {
  Study study;
  std::string identity;
};

Result<SweepInputs> ReadSweepInputs(SweepSettings& a) {
  if (a.trials == 0 && !a.study.disturbances.file.empty())
    throw InvalidArgument("--disturbances is for trials: give --trials too");
  Result<Study> study = SweepStudy(a);
  if (!study) return study.failure();
  std::string trials;
  if (a.trials == 0) {
    a.study.play.CheckActs(a.common.sets, KeysOf(study->axes));
  } else {
    const Result<Disturbances> disturbances = PrepareTrials(a, *study);
    if (!disturbances) return disturbances.failure();
    trials = DisturbancesText(*disturbances);
  }
  std::string identity = StudyIdentity(*study, trials);
  return SweepInputs{std::move(*study), std::move(identity)};
}

Result<std::vector<PointOutcome>> SweepWithBar(const SweepSettings& a, const SweepInputs& sweep, JobJournal& journal,
                                               SharedWork& work) {
  const Interruptible interruptible;
  ProgressBar bar(!a.common.quiet, "points");
  const int before = static_cast<int>(journal.found());
  const auto show = [&](std::size_t done, std::size_t of) {
    bar.Show({before + static_cast<int>(done), before + static_cast<int>(of), before},
             Interruptible::asked() ? "ending" : "");
  };
  return RunSharedSweep(work, sweep.study, sweep.identity, journal, {a.study.threads, show, Interruptible::asked});
}

Result<WrittenFiles> WriteSweep(const SweepSettings& a, const Study& study, const std::vector<PointOutcome>& outcomes) {
  WrittenFiles files = {{"map", a.out}};
  std::vector<OutputFile> texts = {{a.out, SweepCsv(study, outcomes)}};
  const auto add = [&](const char* kind, const std::string& path, const std::string& text) {
    files.emplace_back(kind, path);
    texts.push_back({path, text});
  };
  if (!a.report.empty()) add("report", a.report, SweepPage(study, outcomes));
  if (!a.map.empty()) add("picture", a.map, DrawStabilityMap(study, outcomes, MapQuantity::kScore).svg);
  const SweepSummary summary = SummaryOf(outcomes);
  if (!a.best.empty() && summary.best) {
    const Result<PlannedWalk> planned = PlanPoint(study, study.points[*summary.best]);
    if (!planned) return planned.failure();
    add("best", a.best, PlanToJson(planned->motion.plan));
  }
  const auto written = WriteResults(texts, a.SoFar());
  if (!written) return written.failure();
  return files;
}

void PrintSweep(const SweepSettings& a, const Study& study, const std::vector<PointOutcome>& outcomes,
                const WrittenFiles& files) {
  const SweepSummary summary = SummaryOf(outcomes);
  if (a.common.json) {
    fmt::print("{}", SweepJson(study, outcomes, files));
  } else if (a.common.quiet) {
    fmt::print("{} of {} pass\n", summary.Count(PointStatus::kPass), outcomes.size());
  } else {
    fmt::print("{}\n", SweepText(study, outcomes));
    for (const auto& [kind, path] : files) fmt::print("{:<7} {}\n", kind, path);
    const std::string flags = summary.best ? PlayFlags(study, *summary.best) : "";
    if (!a.best.empty() && !flags.empty()) fmt::print("to play it: play {} {}\n", a.best, flags);
  }
}

/// See HelpRank0.
std::optional<Failure> HelpWithSweep(SweepSettings& a, SharedWork& work) {
  const Result<SweepInputs> sweep = ReadSweepInputs(a);
  if (!sweep) return sweep.failure();
  ServeSweep(work, sweep->study, sweep->identity);
  return std::nullopt;
}

int RunSweep(SweepSettings& a) {
  SharedWork work(Ranks::Join());
  if (!work.ranks().leads()) return HelpRank0(work, [&] { return HelpWithSweep(a, work); });
  CheckSweepPaths(a);
  const Result<SweepInputs> sweep = ReadSweepInputs(a);
  if (!sweep) return Report(sweep.failure(), a.common);
  Result<JobJournal> journal = JobJournal::Open(a.SoFar(), sweep->identity, a.study.resume);
  if (!journal) return Report(journal.failure(), a.common);
  const Result<std::vector<PointOutcome>> outcomes = SweepWithBar(a, *sweep, *journal, work);
  if (!outcomes) {
    const int status = Report(outcomes.failure(), a.common);
    return outcomes.failure().code == FailureCode::kInterrupted ? kInterrupted : status;
  }
  const Result<WrittenFiles> files = WriteSweep(a, sweep->study, *outcomes);
  if (!files) return Report(files.failure(), a.common);
  journal->Remove();
  PrintSweep(a, sweep->study, *outcomes, *files);
  return kPass;
}

void AddSweepFlags(Verb verb, SweepSettings& a) {
  a.study.AddTo(
      verb,
      "An option and its values: KEY=FROM:TO:COUNT or KEY=a,b,c for a grid, KEY=FROM:TO with --samples; may be "
      "repeated. KEY is speed, lateral_speed, yaw_rate, step_length or a key of --list-options=all; default: none.");
  verb.SetGroup("Varied options");
  AddWholeNumber(verb, "--samples", 1, a.samples,
                 "Number of points of a Halton sequence (see --seed), instead of a grid; default: a grid.");
  verb.SetGroup("Work at each point");
  AddWholeNumber(verb, "--trials", 0, a.trials,
                 "Randomised playbacks for each point whose plan passes its audit; all points get the same "
                 "disturbances; default 0.");
  a.study.disturbances.AddTo(verb);
  AddText(verb, "--metrics", "KEYS", a.metrics, "Comma-separated metrics to report; default " + a.metrics + ".");
  a.study.AddWorkTo(verb);
  verb.SetGroup("Output");
  AddText(verb, "--out", "FILE", a.out,
          "Write the map to this CSV file; FILE.so-far keeps intermediate results during the run; default sweep.csv.");
  AddText(verb, "--report", "FILE", a.report, "Write the report to this HTML file; default: none.");
  AddText(verb, "--map", "FILE", a.map, "Write a picture of the map to this SVG file; default: none.");
  AddText(verb, "--best", "FILE", a.best,
          "Write the plan of the best point (by survival, then score) to this file; default: none.");
}

}  // namespace

void AddSweep(Verb program, int& status) {
  auto a = std::make_shared<SweepSettings>();
  const Verb verb =
      program.AddVerb("sweep", "Plan and play a walk over ranges of options, and map where and why it fails");
  AddSweepFlags(verb, *a);
  AddCommon(verb, a->common,
            {"sweep --distance 0.3 --over speed=0.2:0.4:2 --quiet",
             "sweep --distance 0.3 --over stabilised.dcm_gain=1,1.5 --trials 1 --report a.html --best a.json",
             "sweep --distance 0.3 --over speed=0.1:0.4 --over gait.cycle_s=0.4:0.6 --samples 2 --json"});
  AddOptionFlags(verb, a->study.Fields(), a->common.sets, a->common.json);
  SetWorkInRanks(verb, a->common, status, [a] { return RunSweep(*a); });
}

}  // namespace gaitwright::cli
