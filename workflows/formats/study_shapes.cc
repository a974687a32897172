// SPDX-License-Identifier: BSD-3-Clause
// Output of trials, sweep, tune and the preflight.
#include "workflows/formats/result_shapes_internal.h"
#include "workflows/study/point_outcome.h"

namespace gaitwright {

using namespace shapes;

namespace {

/// A value of an option: a number, a word or a truth value.
DataShape ValueShape() { return Either(Either(Number(), Text()), Truth()); }

DataShape SensitivityShape() {
  return Object({{"name", Text()},
                 {"unit", Text()},
                 {"falls_with", Text(), "'more', 'less', 'far off', 'near', 'is WORD', 'is not WORD'."},
                 {"effect", Number(), "Rank-biserial correlation."},
                 {"p", NumberOrNull()},
                 {"log_odds_per_std", NumberOrNull()},
                 {"median_fell", NumberOrNull()},
                 {"median_survived", NumberOrNull()}});
}

DataShape GaitSensitivityShape() {
  return Object({{"standard_error", NumberOrNull()},
                 {"missing", Text(), "Reason for a missing value, or empty."},
                 {"trials", Whole()},
                 {"steps", Whole()},
                 {"indicators", TextsShape()},
                 {"disturbances", TextsShape()},
                 {"varied", List(Truth()), "True for each disturbance that varied."},
                 {"response", List(List(Numbers())),
                  "Response by number of steps after the disturbance: rows are indicators, columns disturbances."}});
}

DataShape PushBinShape() {
  return Object({{"direction_deg", Number()},
                 {"n", Whole(), "Number of pushes whose outcome is known."},
                 {"fell", Whole()},
                 {"unknown", Whole(), "Number of pushes with unknown outcome."},
                 {"largest_survived_n", NumberOrNull()},
                 {"smallest_fatal_n", NumberOrNull()}});
}

DataShape WorstShape() {
  return Object({{"seed", Whole()},
                 {"number", Whole()},
                 {"survived", Truth()},
                 {"score", NumberOrNull()},
                 {"ended_s", Number()},
                 {"cause", Text()},
                 {"reason", Text()},
                 {"log_hash", Text()},
                 {"sampled", MapOf(Either(Number(), Text())), "Sampled values by name."}});
}

DataShape SpreadShape() {
  return Object({{"unit", Text()},
                 {"n", Whole(), "Number of trials with a value."},
                 {"min", Number()},
                 {"p05", Number()},
                 {"median", Number()},
                 {"p95", Number()},
                 {"max", Number()},
                 {"limit", NumberOrNull(), "Limit of the gate; null if the gate applied in no trial."},
                 {"broken", Whole(), "Number of trials that failed the gate."}});
}

DataShape TrialsTableShape() {
  const DataShape cell = OrNull(Either(Either(Number(), Text()), Truth()));
  return Object({{"columns", TextsShape()}, {"rows", List(List(cell)), "One list per trial."}});
}

/// The numbers of trials that survived and passed.
std::vector<ShapeMember> CountMembers() {
  const DataShape share = Number(0.0, 1.0);
  std::vector<ShapeMember> members = {{"n", Whole(), "Number of trials."}, {"survived", Whole()}};
  for (const ShapeMember& member : SurvivalMembers().members) members.push_back(member);
  members.insert(members.end(), {{"passed", Whole(), "Trials that also passed every gate."},
                                 {"pass_share", share, "Share that passed."},
                                 {"pass_low", share, "Lower end of the 95 % interval."},
                                 {"pass_high", share, "Upper end of the 95 % interval."}});
  return members;
}

DataShape AxisShape() {
  return Object({{"key", Text()},
                 {"unit", Text()},
                 {"from", NumberOrNull(), "Lower end of the range; null for words."},
                 {"to", NumberOrNull()},
                 {"values", OrNull(List(ValueShape())), "Values of the axis; null for a sampled range."}});
}

DataShape StatusShape() {
  std::vector<std::string> names;
  for (const PointStatus status : kPointStatuses) names.push_back(StatusName(status));
  return Text(names);
}

DataShape EngineVerdictShape() { return Text({"pass", "fail", "fell"}); }

DataShape PointShape() {
  const DataShape engine =
      Object({{"engine", Text()}, {"verdict", EngineVerdictShape()}, {"score", Number()}, {"cause", Text()}});
  return Object({{"point", Whole(), "Number of the point, from 0."},
                 {"values", MapOf(ValueShape()), "Values of the axes by option key."},
                 {"status", StatusShape()},
                 {"verdict", VerdictShape()},
                 {"audit_pass", OrNull(Truth()), "True if the audit passes; null without a plan."},
                 {"score", NumberOrNull()},
                 {"code", Text()},
                 {"reason", Text()},
                 {"fell_at_s", NumberOrNull()},
                 {"metrics", MapOf(NumberOrNull()), "Metrics that --metrics selects, by key."},
                 Optional("engines", List(engine), "Verdict of each engine, if two have played."),
                 Optional("trials", OrNull(Whole())),
                 Optional("survived", OrNull(Whole())),
                 Optional("survival", NumberOrNull()),
                 Optional("survival_low", NumberOrNull()),
                 Optional("survival_high", NumberOrNull()),
                 Optional("trial_score_mean", NumberOrNull())});
}

DataShape CountsShape() {
  DataShape counts = Object({{"points", Whole()}});
  for (const PointStatus status : kPointStatuses) counts.members.push_back({StatusName(status), Whole()});
  return counts;
}

DataShape CandidateShape() {
  return Object({{"candidate", Whole(), "Number of the candidate; 0 has the present values."},
                 {"found_by", Text({"usual", "sample", "surface", "cma-es"})},
                 {"values", MapOf(Number())},
                 {"value", NumberOrNull(), "Value of the objective; null if the candidate was refused."},
                 {"score_mean", NumberOrNull()},
                 {"survived", OrNull(Whole())},
                 {"refusal", Text()}});
}

DataShape DifferenceShape() {
  return Object({{"before", NumberOrNull()},
                 {"after", Number()},
                 {"difference", NumberOrNull()},
                 {"low", NumberOrNull(), "Lower end of the 95 % interval."},
                 {"high", NumberOrNull()}});
}

DataShape PreflightTrialsShape() {
  const DataShape condition = Object({{"key", Text()}, {"value", Text()}, {"usual", Text()}});
  const DataShape worst = Object({{"seed", Whole()}, {"words", Text()}});
  DataShape different =
      With(Object({{"n", Whole()}, {"survived", Whole()}, {"passed", Whole()}}), SurvivalMembers().members);
  return With(Object(CountMembers()),
              {{"different", different, "Counts over the trials whose logs differ."},
               {"controller", Text()},
               {"conditions", List(condition), "Options that were not at their default values."},
               {"disturbances", Text(), "Disturbances as YAML text."},
               {"causes", MapOf(Whole())},
               {"worst", List(worst)}});
}

}  // namespace

DataShape TrialsResultShape() {
  return With(Object(CountMembers()),
              {{"different", Whole(), "Number of trials whose logs differ."},
               {"remarks", TextsShape()},
               {"metrics", MapOf(SpreadShape()), "Spread of each metric, by key."},
               {"causes", MapOf(Whole()), "Causes of falls, with the number of trials."},
               {"broken_gates", MapOf(Whole()), "Failed gates without a fall, with the number of trials."},
               {"gait_sensitivity_norm", NumberOrNull(), "Gait sensitivity norm; null if it cannot be estimated."},
               {"gait_sensitivity", GaitSensitivityShape()},
               {"sensitivity", List(SensitivityShape()), "Correlates of falling, the most significant first."},
               {"pushes", List(PushBinShape()), "Results of pushes by direction."},
               {"worst", List(WorstShape())},
               Optional("second", Anything(), "The run in the second engine of --engine both, with these members."),
               {"robot", Text()},
               {"robot_hash", Text()},
               {"plan_hash", Text()},
               {"whole_plan_hash", Text()},
               {"controller", Text()},
               {"seed", Whole()},
               {"disturbances", Text(), "Disturbances as YAML text."},
               {"options", MapOf(Text()), "Options of the playback, before trials change them."},
               {"repeat", Text(), "The command that repeats one trial exactly."},
               {"trials", TrialsTableShape()},
               Optional("files", FilesShape({"plan", "policy", "contract", "result", "report", "so_far"}),
                        "Files written; on standard output only.")});
}

DataShape SweepResultShape() {
  const DataShape failure = Object(
      {{"status", StatusShape()}, {"code", Text()}, {"points", List(Whole())}, {"where", Text()}, {"example", Text()}});
  return Object({{"robot", Text()},
                 {"axes", List(AxisShape(), 1)},
                 {"points", List(PointShape())},
                 {"best", OrNull(PointShape()), "Best point; null if no plan passes its audit."},
                 {"best_play_flags", OrNull(Text())},
                 {"counts", CountsShape()},
                 {"failures", List(failure), "Reasons of failure, the most frequent first."},
                 {"files", FilesShape({"map", "report", "picture", "best"})}});
}

DataShape TuneResultShape() {
  const DataShape axis = Object({{"key", Text()}, {"unit", Text()}, {"from", Number()}, {"to", Number()}});
  const DataShape proof = Object({{"trials", Whole()},
                                  {"value", DifferenceShape()},
                                  {"score", DifferenceShape()},
                                  {"survival", DifferenceShape()},
                                  {"no_before", Text(), "Reason why the present values give no plan, or empty."}});
  const DataShape metric = Object({{"before", NumberOrNull()}, {"after", NumberOrNull()}});
  const DataShape verdict = Object({{"verdict", EngineVerdictShape()}, {"score", Number()}});
  const DataShape engine = Object({Optional("before", verdict), Optional("after", verdict)});
  return Object({{"robot", Text()},
                 {"better", Truth(), "True if the held-out trials confirm the improvement."},
                 {"verdict", Text()},
                 {"axes", List(axis, 1)},
                 {"trials", Whole(), "Number of trials of each candidate."},
                 {"survival_weight", Number()},
                 {"usual", MapOf(Number())},
                 {"favourite", CandidateShape()},
                 {"options", MapOf(Number()), "Chosen option values."},
                 {"held_out", OrNull(proof), "Held-out trials; null if the present values are the best."},
                 {"metrics", MapOf(metric), "Metrics of the undisturbed walk."},
                 {"engines", MapOf(engine), "Undisturbed walk in each engine; empty if only one has played."},
                 {"surface_predicted", NumberOrNull()},
                 {"finalists", List(Whole())},
                 {"candidates", List(CandidateShape())},
                 {"files", FilesShape({"options", "result", "report"})}});
}

DataShape PreflightShape() {
  return Object({{"verdict", Text({"go", "no-go"})},
                 {"reasons", TextsShape(), "Reasons for a no-go."},
                 {"remarks", TextsShape()},
                 {"robot", Text()},
                 {"robot_hash", Text()},
                 {"plan_hash", Text()},
                 {"whole_plan_hash", Text()},
                 {"least_survival", Number()},
                 {"fewest_trials", Whole()},
                 {"program_version", Text()},
                 {"made_by", Text()},
                 {"motion", Text()},
                 {"duration_s", Number()},
                 {"limits", List(MarginShape()), "Smallest margin of each check."},
                 {"audit", AuditShape()},
                 {"trials", OrNull(PreflightTrialsShape())},
                 {"assumptions", TextsShape()},
                 {"not_checked", TextsShape()},
                 {"files", FilesShape({"report", "approach"})}});
}

}  // namespace gaitwright
