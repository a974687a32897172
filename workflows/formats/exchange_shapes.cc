// SPDX-License-Identifier: BSD-3-Clause
// Output of compare, export and import.
#include "workflows/formats/result_shapes_internal.h"

namespace gaitwright {

using namespace shapes;

namespace {

DataShape SeriesShape() {
  return Object({{"unit", Text()},
                 {"rms", Number()},
                 {"largest", Number()},
                 {"at_s", Number()},
                 {"tolerance", Number()},
                 {"noise", Number(), "Standard deviation of the noise; 0 unless a side was measured."},
                 {"first_beyond_s", NumberOrNull()}});
}

DataShape FirstShape() {
  return Object({{"quantity", Text()},
                 {"at_s", Number()},
                 {"a", NumberOrNull()},
                 {"b", NumberOrNull()},
                 {"unit", Text()},
                 {"tolerance", Number()}});
}

DataShape MetricPairsShape() {
  return MapOf(Object({{"a", NumberOrNull()},
                       {"b", NumberOrNull()},
                       {"change", NumberOrNull(), "b - a."},
                       {"unit", Text()},
                       {"limit", NumberOrNull()},
                       {"pass_a", Truth()},
                       {"pass_b", Truth()},
                       {"differs", Truth()}}));
}

DataShape WordsShape() { return List(Object({{"key", Text()}, {"a", Text()}, {"b", Text()}})); }

DataShape FootTimesShape() {
  return Object({{"stances_a", Whole()},
                 {"stances_b", Whole()},
                 {"unmatched", Whole()},
                 {"timing_rms_s", Number()},
                 {"timing_largest_s", Number(), "B - A."},
                 {"at_s", Number()},
                 {"tolerance_s", Number()},
                 {"first_beyond_s", NumberOrNull()}});
}

}  // namespace

DataShape MotionComparisonShape() {
  const DataShape side =
      Object({{"name", Text()}, {"kind", Text({"plan", "log", "csv", "trajectory"})}, {"robot", Text()}});
  const DataShape alignment = Object({{"by", Text({"none", "start", "best"})},
                                      {"offset_s", Number(), "Time of B minus time of A."},
                                      {"best_offset_s", NumberOrNull()},
                                      {"agreement", NumberOrNull()}});
  const DataShape joint = Object(
      {{"position", OrNull(SeriesShape())}, {"speed", OrNull(SeriesShape())}, {"torque", OrNull(SeriesShape())}});
  const DataShape figure = Object({{"a", NumberOrNull()}, {"b", NumberOrNull()}, {"unit", Text()}});
  return Object({{"compared", Text({"motions"})},
                 {"a", side},
                 {"b", side},
                 {"same", Truth(), "True if all differences are within tolerance."},
                 {"first_difference", OrNull(FirstShape())},
                 {"in_order", List(FirstShape()), "First difference of each quantity, in order of time."},
                 {"alignment", alignment},
                 {"start_s", Number()},
                 {"end_s", Number()},
                 {"samples", Whole()},
                 {"joints", MapOf(joint), "Comparison of each joint, by joint name."},
                 {"joints_only_a", List(Text())},
                 {"joints_only_b", List(Text())},
                 {"base", MapOf(OrNull(SeriesShape()))},
                 {"balance", MapOf(OrNull(SeriesShape()))},
                 {"feet", MapOf(FootTimesShape())},
                 {"figures", MapOf(figure)},
                 {"metrics", MetricPairsShape()},
                 {"words", WordsShape(), "Differences in text values."},
                 {"notes", TextsShape()},
                 Optional("agreement", AgreementShape(), "How two logs of the plan of --plan differ."),
                 {"files", FilesShape({"report"})}});
}

DataShape ReportComparisonShape() {
  const DataShape side = Object({{"name", Text()}, {"kind", Text({"report"})}, {"score", Number()}});
  return Object({{"compared", Text({"reports"})},
                 {"a", side},
                 {"b", side},
                 {"same", Truth()},
                 {"metrics", MetricPairsShape()},
                 {"words", WordsShape()},
                 {"files", FilesShape({"report"})}});
}

DataShape ExportResultShape() {
  return Object({{"format", Text()},
                 {"from", Text({"plan", "log"})},
                 {"robot", Text()},
                 {"rows", Whole()},
                 {"rate_hz", Number()},
                 {"start_s", Number()},
                 {"end_s", Number()},
                 {"notes", TextsShape(), "Data that the format cannot contain."},
                 {"files", FilesShape({"motion", "plots", "model"})}});
}

DataShape ImportResultShape() {
  const DataShape derived = Object({{"what", Text()}, {"how", Text()}});
  return Object(
      {{"robot", Text()},
       {"verdict", VerdictShape(), "Verdict of the audit."},
       {"format", Text({"csv", "ocs2-csv", "joint-trajectory", "footsteps", "frames-csv", "frames-json", "frames-npz",
                        "npz", "ros-bag", "ros-bag-trajectory", "frames-bvh", "frames-deepmimic"})},
       {"rows", Whole(), "Number of rows of the file."},
       {"duration_s", Number()},
       {"footholds", Whole(), "Number of footholds."},
       {"derived", List(derived), "Derived quantities and their derivation."},
       {"unused_columns", List(Text())},
       {"warnings", TextsShape()},
       {"audit", AuditShape()},
       {"broken", List(BrokenShape()), "Checks that fail, with the time for which they fail."},
       {"files", FilesShape({"plan"})}});
}

DataShape RepairResultShape() {
  const DataShape derived = Object({{"what", Text()}, {"how", Text()}});
  const DataShape change = Object({{"what", Text({"smoothed", "contacts", "other_contact", "stood", "slowed",
                                                  "left_out", "lifted", "pinned", "parted", "held"})},
                                   {"where", Text(), "Foot, joint or links; empty for the whole robot."},
                                   {"start_s", Number()},
                                   {"end_s", Number()},
                                   {"by", Number(), "In `unit`."},
                                   {"unit", Text()},
                                   {"text", Text()}});
  const DataShape group = Object({{"unit", Text({"rad", "m"}), "Of `rms` and `largest`."},
                                  {"rms", Number()},
                                  {"largest", Number()},
                                  {"largest_where", Text(), "Joint, foot or last link of an arm; empty for the base."},
                                  {"largest_at_s", Number()}});
  const DataShape distance =
      Object({{"joint_rms_rad", Number()},
              {"joint_mean_rad", Number()},
              {"joint_largest_rad", Number()},
              {"joint_largest", Text(), "The joint."},
              {"joint_largest_at_s", Number()},
              {"base_rms_m", Number()},
              {"base_largest_m", Number()},
              {"base_largest_at_s", Number()},
              {"base_turn_rms_rad", Number()},
              {"groups", MapOf(group), "Joints of legs, arms, torso_and_head; places of base, hands, feet."}});
  const DataShape optimisation = Object({{"knots", Whole()},
                                         {"windows", Whole(), "In which a long motion was solved."},
                                         {"solves", Whole()},
                                         {"iterations", Whole()},
                                         {"solve_cpu_s", Number()}});
  const DataShape engine =
      Object({{"verdict", Text({"pass", "fail", "fell"})}, {"score", Number()}, {"cause", Text()}});
  return Object({{"robot", Text()},
                 {"verdict", VerdictShape(), "Of the audit and the engines; with --check of the audit of the file."},
                 {"format", Text({"csv", "ocs2-csv", "joint-trajectory", "frames-csv", "frames-json", "frames-npz",
                                  "npz", "ros-bag", "ros-bag-trajectory", "frames-bvh", "frames-deepmimic"})},
                 {"rows", Whole(), "Number of rows of the file."},
                 {"duration_s", Number(), "Of the file's motion."},
                 {"smoothing_hz", Number(), "Cut-off frequency of the smoothing; 0 without it."},
                 {"derived", List(derived), "Derived quantities and their derivation."},
                 {"unused_columns", TextsShape(), "Columns or arrays of the file."},
                 {"warnings", TextsShape()},
                 {"kept", Truth(), "True if the file's motion was sound and was kept."},
                 {"before", OrNull(AuditShape()), "Audit of the file's motion; null if it cannot be audited."},
                 {"broken", List(BrokenShape()), "Checks of `before` that fail, with the time for which they fail."},
                 {"changes", List(change), "Without the optimisation of the whole body."},
                 Optional("distance", distance, "From the file's motion; this and the following without --check."),
                 Optional("after", AuditShape(), "Audit of the plan."),
                 Optional("broken_after", List(BrokenShape()), "Checks of `after` that fail."),
                 Optional("optimisation", optimisation),
                 Optional("score", Number(), "The lower one of the engines."),
                 Optional("reason", Text()),
                 Optional("engines", MapOf(engine), "By engine, if both played."),
                 Optional("files", FilesShape({"plan", "report"}))});
}

DataShape RepairedClipsShape() {
  const DataShape clip =
      Object({{"clip", Text(), "Path of the file within the folder."},
              {"verdict", Text({"pass", "fail", "refused"})},
              {"duration_s", Number(), "Of the file's motion; 0 if it was refused."},
              {"broken_share", Number(), "Share of the time for which the file's motion fails a check; 1 if unknown."},
              {"broken", Text(), "The check that it fails for the longest time."},
              {"violations", Whole(), "Of the file's motion."},
              {"joint_rms_rad", Number(), "Distance of the plan from the file's motion."},
              {"joint_largest_rad", Number()},
              {"base_rms_m", Number()},
              {"slowed_s", Number(), "Time by which parts were slowed."},
              {"left_out_s", Number(), "Duration of parts that were left out."},
              {"reason", Text(), "Why it fails or was refused."},
              {"plan", Text(), "File of the plan; empty without one."}});
  return Object({{"robot", Text()},
                 {"verdict", VerdictShape(), "A pass if all clips pass."},
                 {"passed", Whole(), "Number of clips that pass."},
                 {"clips", List(clip), "The worst first."},
                 {"files", FilesShape({"table"})}});
}

}  // namespace gaitwright
