// SPDX-License-Identifier: BSD-3-Clause
// Output of walk, play, do, plan and audit, and errors.
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
  return Object({{"survival", share, "Share of trials that reached the plan's end without a fall."},
                 {"survival_low", share, "Lower end of the 95 % interval."},
                 {"survival_high", share, "Upper end of the 95 % interval."}});
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
                 {"margin", Number(), "Margin to the limit; negative beyond it."},
                 {"share", OrNull(Number()), "Margin divided by the limit, if the limit is a magnitude."}});
}

DataShape AuditShape() {
  const DataShape violation = Object({{"law", Text(LawNames())},
                                      {"at_s", Number(), "Time of the worst value."},
                                      {"where", Text(), "Joint, foot or pair of links with the worst value."},
                                      {"value", Number()},
                                      {"limit", Number()},
                                      {"unit", Text()}});
  return Object({{"verdict", VerdictShape()},
                 {"violations", List(violation), "Violations, causes before their consequences."},
                 {"samples", Whole()},
                 {"notes", TextsShape(), "Parts that were not checked."},
                 Optional("remarks", TextsShape(), "Likely causes of violations."),
                 Optional("margins", List(MarginShape()), "Margins by check, the smallest first; with --margins.")});
}

DataShape BrokenShape() {
  return Object({{"law", Text(LawNames())},
                 {"share", Number(), "Share of the samples at which the check fails at any place."},
                 {"worst_s", Numbers(), "Starts of the whole seconds in which it fails longest: at most three."}});
}

DataShape AuditResultShape() {
  const DataShape approach = Object({{"duration_s", Number()},
                                     {"base", Text()},
                                     {"via_standing", Truth()},
                                     {"farthest", Text(), "Joint that moves the farthest."},
                                     {"plan", Text(), "File of the approach plan."}});
  return With(AuditShape(), {{"broken", List(BrokenShape()), "Checks that fail, with the time for which they fail."},
                             {"warnings", TextsShape(), "Warnings of the plan."},
                             Optional("approach", OrNull(approach),
                                      "Approach to the first posture, with --approach; null if none is needed.")});
}

namespace {

DataShape MetricShape(const MetricRule& rule) {
  const DataShape value = rule.key == "fell" ? Truth() : OrNull(Number());
  return Object({{"value", value},
                 Optional("planned", OrNull(Number()), "Value in the plan, if it has one."),
                 {"unit", Text({rule.unit})},
                 {"limit", OrNull(Number()), "Limit of the gate; null if no gate applies."},
                 {"pass", Truth()},
                 {"at_s", OrNull(Number()), "Time of the worst value."},
                 Optional("not_applied", Text(), "Reason why a value or a gate is missing.")});
}

DataShape MetricsShape() {
  DataShape metrics = Object({});
  for (const MetricRule& rule : MetricRules()) metrics.members.push_back({rule.key, MetricShape(rule), rule.meaning});
  return metrics;
}

/// The list of --explain.
DataShape TriedShape() {
  return List(
      Object({{"extent", Text({"start-look", "first-look", "start", "whole"})},
              {"pace", Text(), "Flag that sets the speed, without dashes."},
              {"value", Number(), "Value of the speed, in its unit."},
              {"unit", Text()},
              {"cycle_s", Number()},
              {"refused", OrNull(Text(FailureCodeNames())), "Failure code; null if the plan is sound."},
              {"free_footholds", Truth(), "True if footholds could move on their patches."},
              {"whole_body", Truth(), "True if the whole body was optimised (trajectory.method=whole-body)."},
              {"heel_off_rad", Number(0.0, 1.2), "Pitch of soles at lift-off of the longest steps; 0: flat."}}));
}

DataShape EnginesShape() {
  return List(Object({{"verdict", VerdictShape()},
                      {"score", Number(0.0, 100.0)},
                      {"reason", Text()},
                      {"metrics", MetricsShape()},
                      {"notes", TextsShape()},
                      {"engine", Text()},
                      {"log_hash", Text()},
                      {"playback_realtime_factor", Number()}}),
              2);
}

}  // namespace

DataShape AgreementShape() {
  const DataShape quantity =
      Object({{"quantity", Text()},
              {"unit", Text()},
              {"rms", Number()},
              {"largest", Number(), "Magnitude of the largest difference."},
              {"at_s", Number(), "Time of the largest difference."},
              {"tolerance", Number()},
              {"parts_s", OrNull(Number()), "First time at which the difference exceeds the tolerance."},
              {"values", List(Number()), "Values of both engines at parts_s."}});
  return Object(
      {{"engines", List(Text(), 2)},
       {"start_s", Number()},
       {"end_s", Number()},
       {"agree", Truth()},
       {"first", OrNull(quantity), "Quantity whose difference exceeds its tolerance first; null if the engines agree."},
       {"quantities", List(quantity)}});
}

namespace {

/// A learned policy: its joints, orders, sizes and gains.
DataShape PolicyTableShape() {
  const DataShape joint = Object({{"name", Text()},
                                  {"hardware", Whole(), "Number in the hardware's order."},
                                  {"default_position_rad", Number()},
                                  {"stiffness_nm_rad", Number()},
                                  {"damping_nm_s_rad", Number()}});
  const DataShape term = Object({{"name", Text()}, {"size", Whole()}, {"history", Whole(1.0)}});
  return Object({{"name", Text()},
                 {"hash", Text(), "Hash of network and contract."},
                 {"robot", Text()},
                 {"step_s", Number()},
                 {"observations", Whole()},
                 {"actions", Whole()},
                 {"terms", List(term, 1), "Observations in the order of the inputs."},
                 {"joints", List(joint, 1), "Joints in the network's order."},
                 {"warnings", TextsShape()}});
}

/// Floquet multipliers of the steady part of a gait.
DataShape OrbitShape() {
  return Object({{"verdict", Text({"unknown", "stable", "neutral", "unstable"}),
                  "By the largest magnitude: neutral if it is 1 within 0.05."},
                 {"largest", NumberOrNull(), "Largest magnitude."},
                 {"multipliers", List(Numbers(2)), "Real and imaginary part, the largest magnitude first."},
                 {"unexplained", Number(), "Root mean square error of the linear map, as a share."},
                 {"cycle_s", Number()},
                 {"cycles", Whole(), "Steady cycles of the plan."},
                 {"impulse_n_s", Number(), "Of each push."},
                 {"playbacks", Whole()},
                 {"missing", Text(), "Why the multipliers are unknown; else empty."}});
}

}  // namespace

DataShape WalkResultShape() {
  return Object({{"robot", Text()},
                 {"verdict", VerdictShape()},
                 {"score", Number(0.0, 100.0)},
                 {"reason", Text()},
                 {"metrics", MetricsShape(), "Metrics by key, see docs/scores.md."},
                 {"notes", TextsShape()},
                 {"audit", AuditShape()},
                 {"warnings", TextsShape(), "Warnings of the plan."},
                 {"adjustments", AdjustmentsShape(), "Adjustments that the planner made."},
                 Optional("tried", TriedShape(), "Plans that were tried; with --explain."),
                 Optional("drawn", MapOf(Text()), "Sampled values of a trial, by name."),
                 {"engine", Text(), "Engine of score, reason, metrics and log; with two engines, the first."},
                 Optional("engines", EnginesShape(), "Result of each engine, if two have played."),
                 Optional("agreement", AgreementShape(), "How the two engines differ."),
                 {"log_hash", Text(), "Hash of all samples of the log."},
                 {"planning_cpu_s", Number(), "CPU time of planning; 0 for play."},
                 {"playback_realtime_factor", Number()},
                 Optional("policy", PolicyTableShape(), "Of play --policy; there is no plan then."),
                 Optional("orbit", OrbitShape(), "Stability of the steady gait; with --orbit."),
                 {"files", FilesShape({"plan", "policy", "contract", "log", "second_log", "report", "plots"})}});
}

DataShape DoResultShape() {
  const DataShape scores = Object({{"completion", Object({{"done", Whole()}, {"of", Whole()}})},
                                   {"stability", Object({{"metric", Text()}, {"value_m", OrNull(Number())}})},
                                   {"smoothness", Object({{"jerk_rms_rad_s3", OrNull(Number())}})},
                                   {"energy", Object({{"work_j", Number()}})}});
  return With(WalkResultShape(), {{"tasks", Anything(), "Task plan, see its schema."},
                                  {"understood_by", Text({"grammar", "language model", "file"})},
                                  {"scores", scores}});
}

DataShape FinishShape() {
  return Object({{"knots", Whole()},
                 {"variables", Whole()},
                 {"solves", Whole()},
                 {"iterations", Whole(), "Of all solves."},
                 {"solve_cpu_s", Number()},
                 {"residual_force_mg", Number(), "At 1 kHz, divided by the weight."},
                 {"residual_moment_mgl", Number(), "At 1 kHz, divided by the weight and the leg length."},
                 {"periodic_cycles", Whole(), "Steady cycles that repeat exactly (trajectory.cycles=periodic)."}});
}

DataShape PlanResultShape() {
  const DataShape part = Object({{"gait", Text()}, {"start_s", Number()}, {"end_s", Number()}});
  return Object({{"robot", Text()},
                 {"verdict", VerdictShape(), "Verdict of the audit."},
                 {"gait", Text()},
                 {"parts", List(part, 1)},
                 {"duration_s", Number()},
                 {"footholds", Whole(), "Number of footholds."},
                 {"zmp_error_max_m", Number()},
                 {"residual", Number()},
                 {"whole_body", OrNull(FinishShape())},
                 {"planning_cpu_s", Number()},
                 {"warnings", TextsShape()},
                 {"adjustments", AdjustmentsShape()},
                 {"audit", AuditShape()},
                 Optional("tried", TriedShape(), "Plans that were tried; with --explain."),
                 {"files", FilesShape({"plan"})}});
}

DataShape ErrorShape() {
  const DataShape suggestion =
      Object({{"what", Text(), "Flag or option to set, without dashes."},
              {"value", OrNull(Either(Number(), Text())), "Value to set; null if it is not known."},
              {"certainty", Text({"planned", "estimated", "untried"})}});
  const DataShape violation = Object({{"law", Text(LawNames())},
                                      {"at_s", NumberOrNull(), "Time of the worst value; null if it is not known."},
                                      {"where", Text(), "Joint, foot or pair of links with the worst value."},
                                      {"value", Number()},
                                      {"limit", Number()},
                                      {"unit", Text()}});
  return Object({{"error", Object({{"code", Text(FailureCodeNames()), "Failure code."},
                                   {"stage", Text()},
                                   {"message", Text(), "Message: one sentence that names the offending input."},
                                   {"hints", TextsShape(), "Hints, as text."},
                                   {"suggestions", List(suggestion), "Hints that name an option and a value."},
                                   Optional("violation", violation, "The violated check.")})}});
}

}  // namespace gaitwright
