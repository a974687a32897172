// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optimisation/centroidal/optimise_timing.h"
#include "optimisation/centroidal/plan_rigid_body.h"
#include "planning/audit/audit_report.h"
#include "workflows/study/centroidal_problems.h"

namespace gaitwright {

/// A robot with a schedule on a ground, by their indices in a set.
struct CentroidalCase {
  std::size_t robot = 0, schedule = 0, ground = 0;
};

/// Result of optimising the contact times.
struct TimingOutcome {
  std::string refusal;  ///< why no timing was found; empty if one was
  bool keeps = false;   ///< satisfies all constraints, also when checked at 1 kHz
  bool mended = false;  ///< the given timing was infeasible
  double cost_before = 0.0, cost = 0.0;
  double duration_s = 0.0;
  int steps = 0, solves = 0;
  double cpu_ms = 0.0;          ///< in addition to that of the first motion
  double node_violation = 0.0;  ///< as in CentroidalOutcome
  RigidBodyFaults between;

  /// Relative decrease of the cost.
  double Fall() const { return cost_before > 0.0 ? 1.0 - cost / cost_before : 0.0; }
};

/// Audit result of the motion of a case.
struct AuditOutcome {
  CentroidalTask task;                                ///< task of the motion
  std::string refusal;                                ///< why there is no plan to audit; empty if there is one
  AuditReport first;                                  ///< audit of the motion as first planned
  AuditReport report;                                 ///< audit of the last motion
  int swings_planned = 0, halvings = 0, changes = 0;  ///< rounds until then (AuditedMotion)
  double cpu_ms = 0.0;                                ///< CPU time of all audits and repeated planning
  /// If no motion of the task passes: an eased task that has one, with its audit.
  std::optional<CentroidalTask> eased = {};
  AuditReport eased_report = {};

  bool pass() const { return report.samples > 0 && report.pass(); }
};

/// Outcome of a case.
struct CentroidalOutcome {
  std::string robot, schedule, ground;
  CentroidalTask task;  ///< the original task, or the eased one
  bool solved = false, eased = false;
  std::string reason;  ///< why the original task was not solved; empty if it was
  int variables = 0, constraints = 0;
  int iterations = 0;   ///< over all choices of patches
  int choices = 0;      ///< number of choices of patches that were tried
  double cpu_ms = 0.0;  ///< CPU time of choosing footholds and planning for the original task
  double cost = 0.0;
  double node_violation = 0.0;          ///< largest constraint violation, in m, rad, rad/s and m g
  RigidBodyFaults between;              ///< constraint violations at 1 kHz
  double peak_memory_mb = 0.0;          ///< peak memory of the process so far
  std::optional<TimingOutcome> timing;  ///< if requested and there is a motion
  std::optional<AuditOutcome> audit;    ///< if requested; of the motion before its timing was optimised
};

/// All cases of a set whose name, "robot-schedule-ground" such as "hyq-1-gap", contains `filter`.
std::vector<CentroidalCase> CasesOf(const CentroidalProblemSet& set, const std::string& filter = "");

/// Further work on a case, in addition to planning the original task.
struct CaseChoices {
  bool ease = false;                         ///< ease the task if it has no motion
  std::optional<TimingOptions> timing = {};  ///< optimise the contact times
  bool audit = false;                        ///< audit the motion as a robot's plan
};

/// Plans a case over its ground. If `ease` is set, an infeasible case is eased until it has a motion: with a goal up to
/// 0.1 m higher or lower if feet do not reach the ground at the original goal; then with 1.5, 2 and 3 times the
/// duration; with a friction of 0.8, of 1.0, and of 1.2 and 2 times the value that holds a body at rest at the goal; at
/// last with a closer goal. If `timing` is given, the contact times of a motion are then optimised; if constraints stay
/// violated with the given times, other times are tried before easing. If it is audited and no motion passes, it is
/// eased further, if requested, until one does.
CentroidalOutcome RunCase(const CentroidalProblemSet& set, const CentroidalCase& one, const CentroidalTask& task,
                          const RigidBodyOptions& options, const CaseChoices& choices = {});

/// The outcomes as a text table with a summary; with a second table if the timing was optimised.
std::string CentroidalTable(const std::vector<CentroidalOutcome>& outcomes);

}  // namespace gaitwright
