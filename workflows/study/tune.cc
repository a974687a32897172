// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/tune.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "kinematics/base/hash.h"
#include "kinematics/base/version.h"
#include "playback/score/gates.h"
#include "workflows/study/run_sweep.h"

namespace gaitwright {
namespace {

/// The plans that were requested last. Candidates that differ only in the playback share a plan. Thread-safe.
class RecentPlans {
 public:
  using Shared = std::shared_ptr<const Result<PlannedWalk>>;

  explicit RecentPlans(const Study& study) : study_(study) {}

  Shared Take(const StudyPoint& values) {
    constexpr std::size_t kMost = 8;
    std::promise<Shared> promise;
    std::shared_future<Shared> plan;
    const std::string key = PlanKey(study_.axes, values);
    bool mine = false;
    {
      const std::lock_guard lock(mutex_);
      const auto known =
          std::find_if(plans_.begin(), plans_.end(), [&](const auto& entry) { return entry.first == key; });
      mine = known == plans_.end();
      plan = mine ? promise.get_future().share() : known->second;
      if (mine) plans_.emplace_back(key, plan);
      if (plans_.size() > kMost) plans_.pop_front();
    }
    if (mine) {
      try {
        promise.set_value(std::make_shared<const Result<PlannedWalk>>(PlanPoint(study_, values)));
      } catch (...) {
        promise.set_exception(std::current_exception());
      }
    }
    return plan.get();
  }

 private:
  const Study& study_;
  std::mutex mutex_;
  std::deque<std::pair<std::string, std::shared_future<Shared>>> plans_;
};

CandidateWorth JudgeOver(const Study& study, const StudyPoint& values, const PlannedWalk& planned, int first,
                         int count) {
  CandidateWorth worth;
  const PlayRequest play = PlaybackOf(study, values);
  for (int number = first; number < first + count; ++number) {
    const Result<TrialWorth> trial = study.play_trial(study.model, planned.motion.plan, play, number);
    if (!trial) return {trial.failure().message, {}};
    worth.trials.push_back(*trial);
  }
  return worth;
}

CandidateWorth JudgeCandidate(const Study& study, RecentPlans& plans, const StudyPoint& values, int first, int count) {
  const RecentPlans::Shared planned = plans.Take(values);
  if (!planned->ok()) return {planned->failure().message, {}};
  const AuditReport& audit = planned->value().audit;
  if (!audit.pass()) return {"the plan fails its audit: " + LawName(audit.violations.front().law), {}};
  try {
    return JudgeOver(study, values, planned->value(), first, count);
  } catch (const InvalidArgument& error) {
    return {error.what(), {}};
  }
}

std::vector<std::string> MetricKeys() {
  std::vector<std::string> keys;
  for (const MetricRule& rule : MetricRules()) keys.push_back(rule.key);
  return keys;
}

/// Plays the undisturbed walk with the present values and with the favourite ones.
void PlayBoth(const Study& study, TuneReport& report) {
  Study both = study;
  both.trials = 0;
  both.metrics = report.metrics;
  both.points = {report.result.candidates.front().values, report.result.candidates[report.result.favourite].values};
  StudyPlans plans(both, {0, 1});
  report.before = RunPoint(both, 0, plans);
  report.after = RunPoint(both, 1, plans);
}

}  // namespace

void CheckTunable(const std::vector<StudyAxis>& axes) {
  for (const StudyAxis& axis : axes) {
    if (IsOfCommand(axis.key) || axis.key.starts_with("score.")) {
      throw InvalidArgument(fmt::format(
          "'{}' cannot be tuned: scores are comparable only for the same command and the same rules; sweep it instead",
          axis.key));
    }
    if (axis.key.starts_with("play.") || axis.key.starts_with("sensors.") || axis.key == "command_delay_s") {
      throw InvalidArgument(fmt::format(
          "'{}' cannot be tuned: it describes the world or the robot, not the walk; sweep it instead", axis.key));
    }
  }
}

StudyPoint UsualValues(const Study& study) {
  WalkRequest walk = study.walk;
  PlayRequest play = study.play;
  const OptionFields fields = StudyFields(walk, play);
  StudyPoint values;
  for (const StudyAxis& axis : study.axes) {
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.key == axis.key; });
    if (field == fields.end()) throw InvalidArgument(fmt::format("there is no option '{}' to tune", axis.key));
    values.push_back(OptionText(*field));
  }
  return values;
}

std::string TuneIdentity(const Study& study, const TuneOptions& options, const std::string& trials) {
  TuneOptions shown = options;
  std::string text = StudyIdentity(study, trials) + "\n";
  for (const StudyAxis& axis : study.axes) text += fmt::format("{} {} {}\n", axis.key, axis.low, axis.high);
  for (const auto& [key, value] : TextsOf(shown.Fields())) text += key + "=" + value + "\n";
  return HexHash(text);
}

Result<TuneReport> Tune(const Study& study, const TuneOptions& options, JobJournal& journal, const JobOptions& jobs) {
  CheckTunable(study.axes);
  RecentPlans plans(study);
  const TuneProblem problem{study.axes, UsualValues(study), [&](const StudyPoint& values, int first, int count) {
                              return JudgeCandidate(study, plans, values, first, count);
                            }};
  Result<TuneResult> found = SearchTuning(problem, options, study.walk.seed, journal, jobs);
  if (!found) return found.failure();
  TuneReport report{std::move(*found), {}, {}, MetricKeys()};
  if (!report.result.candidates[report.result.favourite].value) {
    return Failure{FailureKind::kInfeasible,
                   FailureCode::kNoPlan,
                   "Tune",
                   fmt::format("none of {} candidates has a plan that passes its audit; the present values: {}",
                               report.result.candidates.size(), report.result.candidates.front().worth.refusal),
                   {"lower the speed", "widen the ranges"}};
  }
  PlayBoth(study, report);
  return report;
}

std::string TunedOptions(const Study& study, const TuneResult& result) {
  std::string yaml = result.better() ? "# Tuned; better on held-out trials.\n"
                                     : "# Not better than these present values on held-out trials, so they are kept.\n";
  if (result.proof && !result.proof->no_before.empty())
    yaml = "# Tuned; the present values have no plan that passes its audit.\n";
  yaml += fmt::format("# Robot {} ({}), gait {}, terrain {}; gaitwright {}.\n", study.model.name, study.model.hash,
                      study.walk.gait.empty() ? "its best" : study.walk.gait, study.walk.terrain, Version());
  WalkRequest walk = study.walk;
  std::string command;
  for (const auto& [key, value] : TextsOf(CommandFields(walk))) command += fmt::format(" {}={}", key, value);
  yaml += "# Command:" + command + "\n";
  for (std::size_t k = 0; k < study.axes.size(); ++k)
    yaml += study.axes[k].key + ": " + result.candidates[result.chosen].values[k] + "\n";
  return yaml;
}

}  // namespace gaitwright
