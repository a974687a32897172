// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/run_point.h"

#include <fmt/format.h>

#include <algorithm>

namespace gaitwright {
namespace {

Failure AsFailure(const InvalidArgument& error) {
  return {FailureKind::kBadInput, FailureCode::kInvalidArgument, "RunPoint", error.what(), {}};
}

PointOutcome Refused(std::size_t point, const Failure& failure) {
  PointOutcome outcome;
  outcome.point = point;
  outcome.code = FailureCodeName(failure.code);
  outcome.reason = failure.message;
  return outcome;
}

/// The failed gates, such as "goal_error_m, scuffs".
std::string GatesMissed(const StabilityReport& report) {
  std::string keys;
  for (const Metric& metric : report.metrics) {
    if (!metric.pass) keys += (keys.empty() ? "" : ", ") + metric.key;
  }
  return keys;
}

void Judge(PointOutcome& outcome, const PlannedWalk& planned, const StabilityReport& report) {
  const Metric& fell = report.At("fell");
  outcome.score = report.score;
  outcome.reason = report.reason;
  if (fell.value && *fell.value != 0.0) {
    outcome.status = PointStatus::kFell;
    outcome.code = "fell";
    outcome.fell_at_s = fell.at_s;
  } else {
    outcome.status = report.pass ? PointStatus::kPass : PointStatus::kGateMissed;
    outcome.code = GatesMissed(report);
  }
  if (planned.audit.pass()) return;
  outcome.status = PointStatus::kAuditFailed;
  outcome.code = LawName(planned.audit.violations.front().law);
  outcome.reason = fmt::format("the plan fails its audit: {}; in physics: {}", outcome.code, report.reason);
}

Result<PointSurvival> TryOften(const Study& study, const MotionPlan& plan, const PlayRequest& play) {
  double score_sum = 0.0;
  int survived = 0;
  for (int number = 0; number < study.trials; ++number) {
    const Result<TrialWorth> worth = study.play_trial(study.model, plan, play, number);
    if (!worth) return worth.failure();
    score_sum += worth->score;
    survived += worth->survived ? 1 : 0;
  }
  return SurvivalOf(study.trials, survived, score_sum / study.trials);
}

}  // namespace

std::string PlanKey(const std::vector<StudyAxis>& axes, const StudyPoint& point) {
  std::string key;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (ShapesThePlan(axes[k].key)) key += point[k] + '\n';
  }
  return key;
}

PlayRequest PlaybackOf(const Study& study, const StudyPoint& point) {
  WalkRequest walk = study.walk;
  PlayRequest play = study.play;
  ApplyPoint(study.axes, point, walk, play);
  return play;
}

Result<PlannedWalk> PlanPoint(const Study& study, const StudyPoint& point) {
  WalkRequest walk = study.walk;
  PlayRequest play = study.play;
  try {
    ApplyPoint(study.axes, point, walk, play);
    return PlanWalk(study.model, walk);
  } catch (const InvalidArgument& error) {
    return AsFailure(error);
  }
}

StudyPlans::StudyPlans(const Study& study, const std::vector<std::size_t>& pending) : study_(study) {
  for (const std::size_t point : pending) ++entries_[PlanKey(study.axes, study.points[point])].left;
}

StudyPlans::Shared StudyPlans::Take(std::size_t point) {
  std::promise<Shared> promise;
  std::shared_future<Shared> plan;
  bool mine = false;
  {
    const std::lock_guard lock(mutex_);
    const auto entry = entries_.try_emplace(PlanKey(study_.axes, study_.points[point])).first;
    mine = !entry->second.plan.valid();
    if (mine) {
      entry->second.plan = promise.get_future().share();
      ++made_;
    }
    plan = entry->second.plan;
    if (--entry->second.left <= 0) entries_.erase(entry);
  }
  if (mine) {
    try {
      promise.set_value(std::make_shared<const Result<PlannedWalk>>(PlanPoint(study_, study_.points[point])));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  }
  return plan.get();
}

int StudyPlans::made() const {
  const std::lock_guard lock(mutex_);
  return made_;
}

PointOutcome RunPoint(const Study& study, std::size_t point, StudyPlans& plans) {
  const StudyPlans::Shared planned = plans.Take(point);
  if (!planned->ok()) return Refused(point, planned->failure());
  const MotionPlan& plan = planned->value().motion.plan;
  try {
    const PlayRequest play = PlaybackOf(study, study.points[point]);
    const Result<PlayedWalk> played = PlayWalk(study.model, plan, play);
    if (!played) return Refused(point, played.failure());
    PointOutcome outcome;
    outcome.point = point;
    const StabilityReport& report = played->decisive().report;
    Judge(outcome, planned->value(), report);
    outcome.engines = VerdictsOf(*played);
    for (const std::string& key : study.metrics) outcome.metrics.push_back(report.At(key).value);
    if (study.trials == 0 || !outcome.audit_pass()) return outcome;
    const Result<PointSurvival> survival = TryOften(study, plan, play);
    if (!survival) return Refused(point, survival.failure());
    outcome.survival = *survival;
    return outcome;
  } catch (const InvalidArgument& error) {
    return Refused(point, AsFailure(error));
  }
}

std::vector<std::size_t> OrderByPlan(const Study& study, const std::vector<std::size_t>& pending) {
  std::map<std::string, std::size_t> first;
  for (const std::size_t point : pending) first.try_emplace(PlanKey(study.axes, study.points[point]), point);
  std::vector<std::size_t> ordered = pending;
  std::stable_sort(ordered.begin(), ordered.end(), [&](std::size_t a, std::size_t b) {
    return first.at(PlanKey(study.axes, study.points[a])) < first.at(PlanKey(study.axes, study.points[b]));
  });
  return ordered;
}

}  // namespace gaitwright
