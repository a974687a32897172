// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "planning/audit/audit.h"
#include "workflows/grade/motion_run.h"
#include "workflows/grade/student_python.h"
#include "workflows/study/run_trials.h"
#include "workflows/walk/walk_report.h"

namespace gaitwright {
namespace {

constexpr std::size_t kMostReasons = 6, kMostFallsReported = 2;

PlayedWalk PlayOnce(const JudgeSetup& setup, const MotionPlan& plan, const PlayRequest& request) {
  Result<PlayedWalk> played =
      setup.own ? PlayWalk(setup.model, plan, request, setup.own(plan)) : PlayWalk(setup.model, plan, request);
  if (setup.broken) {
    if (const std::string why = setup.broken(); !why.empty()) throw BrokenCode(why);
  }
  if (!played) throw InvalidArgument(played.failure().message);
  return std::move(*played);
}

std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Counts a trial, and stores the reason of a fall.
void Count(const TrialOutcome& trial, RunOutcome& outcome) {
  if (trial.survived) {
    ++outcome.survived;
  } else if (outcome.falls.size() < kMostFallsReported) {
    outcome.falls.push_back(fmt::format("trial {}: {}", trial.number + 1, ShownWords(FirstLine(trial.reason))));
  }
}

/// Plays the trials of a submitted controller in sequence; trials of built-in controllers use all cores.
void PlayOwn(const JudgeSetup& setup, const TrialStudy& study, std::uint64_t seed, RunOutcome& outcome) {
  if (const auto failure = ReasonNotTried(study)) throw InvalidArgument(failure->message);
  for (int number = 0; number < setup.part.motion.trials; ++number) {
    const SampledTrial trial = SampleTrial(study.disturbances, study.model, study.plan, SeedOfTrial(seed, number));
    const PlayedWalk played = PlayOnce(setup, study.plan, DisturbedRequest(study.request, trial));
    Count(OutcomeOf(number, trial, played.decisive().log, played.decisive().report), outcome);
  }
}

void PlayTrials(const JudgeSetup& setup, const MotionRun& run, const MotionPlan& plan, RunOutcome& outcome) {
  const MotionSetup& motion = setup.part.motion;
  if (motion.trials == 0) return;
  const Disturbances disturbances = motion.disturbances ? *motion.disturbances : StandardBesides(setup.model, run.play);
  const TrialStudy study{setup.model, plan, run.play, disturbances};
  if (setup.own) return PlayOwn(setup, study, run.seed, outcome);
  TrialOptions options;
  options.trials = motion.trials;
  options.seed = static_cast<int>(run.seed);
  const Result<RobustnessReport> report = RunTrials(study, options);
  if (!report) throw InvalidArgument(report.failure().message);
  for (const TrialOutcome& trial : report->outcomes) Count(trial, outcome);
}

AuditReport AuditOf(const RobotModel& model, const MotionPlan& plan) {
  Result<AuditReport> audit = Audit(model, plan, {});
  if (!audit) throw InvalidArgument(audit.failure().message);
  return std::move(*audit);
}

void Judge(const JudgeSetup& setup, const MotionRun& run, const MotionPlan& plan, std::vector<MotionPage>& pages,
           RunOutcome& outcome) {
  if (plan.duration_s() > setup.part.motion.longest_motion_s)
    throw InvalidArgument(fmt::format("the motion lasts {:.1f} s; at most {:g} s can be played", plan.duration_s(),
                                      setup.part.motion.longest_motion_s));
  const AuditReport audit = AuditOf(setup.model, plan);
  outcome.audit_passes = audit.pass();
  if (!audit.pass()) {
    const Violation& worst = audit.violations.front();
    outcome.audit_words = fmt::format("{} at {:.2f} s, {}: {}, limit {}", LawName(worst.law), worst.at_s, worst.where,
                                      AuditFigure(worst.value, worst.unit), AuditFigure(worst.limit, worst.unit));
  }
  const PlayedWalk played = PlayOnce(setup, plan, run.play);
  outcome.report = played.decisive().report;
  outcome.engines = VerdictsOf(played);
  pages.push_back({fmt::format("{}: {}", setup.part.title, run.title), WalkReport({setup.model, plan, played, audit})});
  PlayTrials(setup, run, plan, outcome);
}

void AddReasons(const RunOutcome& run, std::vector<std::string>& reasons) {
  const auto tell = [&](const std::string& what) {
    if (reasons.size() < kMostReasons) reasons.push_back(fmt::format("{}: {}", run.title, what));
  };
  if (!run.failure.empty()) return tell(run.failure);
  if (!run.audit_passes) tell("the audit fails: " + ShownWords(run.audit_words));
  if (run.report && !run.report->pass) tell(ShownWords(FirstLine(run.report->reason)));
  if (!run.engines.empty()) tell(VerdictsText(run.engines));
  if (run.trials > 0) tell(fmt::format("{} of {} trials survived", run.survived, run.trials));
  for (const std::string& fall : run.falls) tell(fall);
}

}  // namespace

RunOutcome JudgeRun(const JudgeSetup& setup, const MotionRun& run, const MotionPlan& plan,
                    std::vector<MotionPage>& pages) {
  RunOutcome outcome;
  outcome.title = run.title;
  outcome.trials = setup.part.motion.trials;
  try {
    Judge(setup, run, plan, pages, outcome);
  } catch (const InvalidArgument& error) {
    outcome.failure = ShownWords(error.what());
    outcome.report.reset();
  }
  return outcome;
}

PartMark MarkOfRuns(const RubricPart& part, const std::vector<RunOutcome>& runs, std::vector<MotionPage> pages) {
  std::vector<std::optional<double>> values;
  for (const Check& check : part.checks) values.push_back(MeasureOf(check.measure, check.higher_is_better, runs));
  PartMark mark = MarkOf(part, values);
  mark.pages = std::move(pages);
  if (mark.points >= mark.of) return mark;
  std::vector<std::string> reasons;
  for (const RunOutcome& run : runs) AddReasons(run, reasons);
  mark.reasons.insert(mark.reasons.end(), reasons.begin(), reasons.end());
  return mark;
}

}  // namespace gaitwright
