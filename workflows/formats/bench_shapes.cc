// SPDX-License-Identifier: BSD-3-Clause
// Output of bench.
#include "workflows/formats/result_shapes_internal.h"

namespace gaitwright {

using namespace shapes;

namespace {

DataShape FaultsShape() {
  return Object({{"force_balance_mg", Number(), "Largest error divided by the weight."},
                 {"torque_balance_mg_m", Number()},
                 {"friction_mg", Number()},
                 {"unilateral_mg", Number()},
                 {"reach_m", Number()},
                 {"foothold_m", Number()},
                 {"goal", Number()}});
}

DataShape TimingShape() {
  return Object({{"refusal", Text(), "Reason why no other timing was found, or empty."},
                 {"keeps_all_laws", Truth()},
                 {"mended", Truth()},
                 {"cost_before", Number()},
                 {"cost", Number()},
                 {"fall", Number(), "Share of the cost that the timing saved."},
                 {"duration_s", Number()},
                 {"steps", Whole()},
                 {"solves", Whole()},
                 {"cpu_ms", Number()},
                 {"node_violation", Number()},
                 {"at_1_khz", FaultsShape()}});
}

DataShape AuditRoundsShape() {
  const DataShape task =
      Object({{"distance_m", Number()}, {"goal_higher_m", Number()}, {"duration_s", Number()}, {"friction", Number()}});
  return Object({{"pass", Truth()},
                 {"refusal", Text()},
                 {"as_planned", AuditShape()},
                 {"in_the_end", AuditShape()},
                 {"rounds_swings_planned", Whole()},
                 {"rounds_breaks_halved", Whole()},
                 {"rounds_other_patches", Whole()},
                 {"passes_when_eased", Truth()},
                 {"eased", OrNull(task), "Task that passes its audit."},
                 {"eased_in_the_end", OrNull(AuditShape())},
                 {"cpu_ms", Number()}});
}

}  // namespace

DataShape BenchResultShape() {
  const DataShape one = Object({{"robot", Text()},
                                {"schedule", Text()},
                                {"ground", Text()},
                                {"solved", Truth(), "Result of the original task."},
                                {"reason", Text(), "Reason for a failure, or empty."},
                                {"solved_when_eased", Truth()},
                                {"distance_m", Number()},
                                {"goal_higher_m", Number()},
                                {"duration_s", Number()},
                                {"friction", Number()},
                                {"variables", Whole()},
                                {"constraints", Whole()},
                                {"iterations", Whole()},
                                {"patch_choices", Whole()},
                                {"cpu_ms", Number()},
                                {"cost", Number()},
                                {"node_violation", Number()},
                                {"at_1_khz", FaultsShape(), "Between the nodes."},
                                {"timing", OrNull(TimingShape())},
                                {"audit", OrNull(AuditRoundsShape())},
                                {"peak_memory_mb", Number()}});
  return Object({{"bench", Text({"centroidal"})}, {"cases", List(one)}, {"files", FilesShape({"problems"})}});
}

DataShape WholeBodyBenchShape() {
  const DataShape one =
      Object({{"case", Text(), "ROBOT-GAIT-SPEED."},
              {"robot", Text()},
              {"gait", Text()},
              {"speed_m_s", Number()},
              {"distance_m", Number()},
              {"reason", Text(), "Reason why there is no finished plan, or what its audit finds; or empty."},
              {"planning_cpu_s", Number()},
              {"audit", VerdictShape()},
              {"whole_body", OrNull(FinishShape())},
              {"ms_an_iteration", Number(), "CPU time."}});
  return Object({{"bench", Text({"whole-body"})}, {"cases", List(one)}});
}

}  // namespace gaitwright
