// SPDX-License-Identifier: BSD-3-Clause
// What walk, play, do, plan and audit print, and errors.
#include "planning/audit/audit_report.h"
#include "planning/plan/plan_shape.h"
#include "playback/score/gates.h"
#include "workflows/formats/result_shapes_internal.h"

namespace gaitwright {

using namespace shapes;

DataShape With(DataShape shape, const std::vector<ShapeMember>& more) {
  shape.members.insert(shape.members.end(), more.begin(), more.end());
  return shape;
}

DataShape VerdictShape() { return Text({"pass", "fail"}); }

DataShape TextsShape() { return List(Text()); }

DataShape SurvivalMembers() {
  const DataShape share = Number(0.0, 1.0);
  return Object({{"survival", share, "Share that did not fall and reached the plan's end."},
                 {"survival_low", share, "Lower end of its 95 % interval."},
                 {"survival_high", share, "Upper end of its 95 % interval."}});
}

DataShape FilesShape(const std::vector<std::string>& kinds) {
  DataShape files = Object({});
  for (const std::string& kind : kinds) files.members.push_back(Optional(kind, Text()));
  return files;
}

DataShape MarginShape() {
  return Object({{"law", Text(LawNames())},
                 {"at_s", Number()},
                 {"where", Text()},
                 {"value", Number()},
                 {"limit", Number()},
                 {"unit", Text()},
                 {"margin", Number(), "Negative beyond the limit."},
                 {"share", OrNull(Number()), "Margin over limit, where the limit is a size."}});
}

DataShape AuditShape() {
  const DataShape violation = Object({{"law", Text(LawNames())},
                                      {"at_s", Number(), "When it is worst."},
                                      {"where", Text(), "Joint, foot or pair of links."},
                                      {"value", Number()},
                                      {"limit", Number()},
                                      {"unit", Text()}});
  return Object({{"verdict", VerdictShape()},
                 {"violations", List(violation), "The cause before its consequences."},
                 {"samples", Whole()},
                 {"notes", TextsShape(), "What was not looked at."},
                 Optional("remarks", TextsShape(), "What is likely amiss where a law is broken."),
                 Optional("margins", List(MarginShape()), "With --margins: by law, the least first.")});
}

DataShape AuditResultShape() {
  const DataShape approach = Object({{"duration_s", Number()},
                                     {"base", Text()},
                                     {"via_standing", Truth()},
                                     {"farthest", Text(), "A joint."},
                                     {"plan", Text(), "The file."}});
  return With(AuditShape(), {{"warnings", TextsShape(), "Of the plan."},
                             Optional("approach", OrNull(approach), "With --approach; null: there is no way to go.")});
}

namespace {

DataShape MetricShape(const MetricRule& rule) {
  const DataShape value = rule.key == "fell" ? Truth() : OrNull(Number());
  return Object({{"value", value},
                 Optional("planned", OrNull(Number()), "Of the plan, where it has one."),
                 {"unit", Text({rule.unit})},
                 {"limit", OrNull(Number()), "null: no gate is applied."},
                 {"pass", Truth()},
                 {"at_s", OrNull(Number()), "When it was worst."},
                 Optional("not_applied", Text(), "Why a value or a gate is missing.")});
}

DataShape MetricsShape() {
  DataShape metrics = Object({});
  for (const MetricRule& rule : MetricRules()) metrics.members.push_back({rule.key, MetricShape(rule), rule.meaning});
  return metrics;
}

}  // namespace

namespace {

/// What --explain lists.
DataShape TriedShape() {
  return List(Object({{"extent", Text({"start-look", "first-look", "start", "whole"})},
                      {"pace", Text(), "The flag of the command's speed, without dashes."},
                      {"value", Number(), "Of the pace, in its unit."},
                      {"unit", Text()},
                      {"cycle_s", Number()},
                      {"refused", OrNull(Text(FailureCodeNames())), "Null: the plan is sound."}}));
}

}  // namespace

DataShape WalkResultShape() {
  return Object({{"robot", Text()},
                 {"verdict", VerdictShape()},
                 {"score", Number(0.0, 100.0)},
                 {"reason", Text()},
                 {"metrics", MetricsShape(), "By key, each as docs/scores.md has it."},
                 {"notes", TextsShape()},
                 {"audit", AuditShape()},
                 {"warnings", TextsShape(), "Of the plan."},
                 {"adjustments", AdjustmentsShape(), "Of the plan."},
                 Optional("tried", TriedShape(), "With --explain: plans that were tried."),
                 Optional("drawn", MapOf(Text()), "Of a trial: what was drawn, by name."),
                 {"log_hash", Text(), "Of all samples of the log."},
                 {"planning_cpu_s", Number(), "0 for play."},
                 {"playback_realtime_factor", Number()},
                 {"files", FilesShape({"plan", "log", "report", "plots"})}});
}

DataShape DoResultShape() {
  const DataShape scores = Object({{"completion", Object({{"done", Whole()}, {"of", Whole()}})},
                                   {"stability", Object({{"metric", Text()}, {"value_m", OrNull(Number())}})},
                                   {"smoothness", Object({{"jerk_rms_rad_s3", OrNull(Number())}})},
                                   {"energy", Object({{"work_j", Number()}})}});
  return With(WalkResultShape(), {{"tasks", Anything(), "A task plan, which has a schema of its own."},
                                  {"understood_by", Text({"grammar", "language model", "file"})},
                                  {"scores", scores}});
}

DataShape PlanResultShape() {
  const DataShape part = Object({{"gait", Text()}, {"start_s", Number()}, {"end_s", Number()}});
  return Object({{"robot", Text()},
                 {"verdict", VerdictShape(), "Of the audit."},
                 {"gait", Text()},
                 {"parts", List(part, 1)},
                 {"duration_s", Number()},
                 {"footholds", Whole(), "Their number."},
                 {"zmp_error_max_m", Number()},
                 {"residual", Number()},
                 {"planning_cpu_s", Number()},
                 {"warnings", TextsShape()},
                 {"adjustments", AdjustmentsShape()},
                 {"audit", AuditShape()},
                 Optional("tried", TriedShape(), "With --explain: plans that were tried."),
                 {"files", FilesShape({"plan"})}});
}

DataShape ErrorShape() {
  const DataShape suggestion = Object({{"what", Text(), "The flag or option to give, without dashes."},
                                       {"value", OrNull(Either(Number(), Text())), "Null: not known."},
                                       {"certainty", Text({"planned", "estimated", "untried"})}});
  const DataShape violation = Object({{"law", Text(LawNames())},
                                      {"at_s", NumberOrNull(), "Null: not known."},
                                      {"where", Text(), "Joint, foot or pair of links."},
                                      {"value", Number()},
                                      {"limit", Number()},
                                      {"unit", Text()}});
  return Object({{"error", Object({{"code", Text(FailureCodeNames()), "Why it is refused."},
                                   {"stage", Text()},
                                   {"message", Text(), "One sentence that names the offender."},
                                   {"hints", TextsShape(), "What may help, in words."},
                                   {"suggestions", List(suggestion), "Those hints that name an option."},
                                   Optional("violation", violation, "The law that forbids it.")})}});
}

}  // namespace gaitwright
