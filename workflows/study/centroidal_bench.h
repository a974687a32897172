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

/// A robot's schedule on a ground, by their numbers in a set.
struct CentroidalCase {
  std::size_t robot = 0, schedule = 0, ground = 0;
};

/// How the times of contacts were made better.
struct TimingOutcome {
  std::string refusal;  ///< why there was nothing to be done; empty where there was
  bool keeps = false;   ///< all laws, at 1 kHz too
  bool mended = false;  ///< what has no motion at the times that are asked for
  double cost_before = 0.0, cost = 0.0;
  double duration_s = 0.0;
  int steps = 0, solves = 0;
  double cpu_ms = 0.0;          ///< beyond that of the first motion
  double node_violation = 0.0;  ///< as in CentroidalOutcome
  RigidBodyFaults between;

  /// By how much of what it was the cost fell.
  double Fall() const { return cost_before > 0.0 ? 1.0 - cost / cost_before : 0.0; }
};

/// What the audit says of the motion of a case.
struct AuditOutcome {
  CentroidalTask task;                                ///< whose motion it was
  std::string refusal;                                ///< why there is no plan to be audited; empty where there is
  AuditReport first;                                  ///< of the motion as it was planned
  AuditReport report;                                 ///< of the last one
  int swings_planned = 0, halvings = 0, changes = 0;  ///< rounds until then (AuditedMotion)
  double cpu_ms = 0.0;                                ///< of all audits, and of planning anew
  /// Where no motion of the task passes: a task that it was eased to of which one does, and what the audit says of it.
  std::optional<CentroidalTask> eased = {};
  AuditReport eased_report = {};

  bool pass() const { return report.samples > 0 && report.pass(); }
};

/// How a case went.
struct CentroidalOutcome {
  std::string robot, schedule, ground;
  CentroidalTask task;  ///< what was asked for, or what it was eased to
  bool solved = false, eased = false;
  std::string reason;  ///< why it was not solved as it was asked for; empty where it was
  int variables = 0, constraints = 0;
  int iterations = 0;   ///< over all choices of patches
  int choices = 0;      ///< of patches that were planned for
  double cpu_ms = 0.0;  ///< of choosing footholds and planning, as asked for
  double cost = 0.0;
  double node_violation = 0.0;          ///< largest of a constraint, in m, rad, rad/s and m g
  RigidBodyFaults between;              ///< at 1 kHz
  double peak_memory_mb = 0.0;          ///< of the process so far
  std::optional<TimingOutcome> timing;  ///< where it was asked for and there is a motion
  std::optional<AuditOutcome> audit;    ///< likewise; of the motion before its times were made better
};

/// All cases of a set whose name, "robot-schedule-ground" such as "hyq-1-gap", holds `filter`.
std::vector<CentroidalCase> CasesOf(const CentroidalProblemSet& set, const std::string& filter = "");

/// What is done with a case besides planning it as asked for.
struct CaseChoices {
  bool ease = false;                         ///< where it has no motion
  std::optional<TimingOptions> timing = {};  ///< find better times
  bool audit = false;                        ///< have the motion audited as a plan of a robot
};

/// Plans over the ground. A case that has no motion as it is asked for is eased where `ease` is set, until it has one:
/// to a goal up to 0.1 m higher or lower where feet reach no ground from the one asked for; then half as long again,
/// twice and three times as long; with a friction of 0.8, of 1.0, and of 1.2 times and twice what holds a body at rest
/// at the goal; at last to a goal less far away. A motion that is found is then given times that suit it better, if
/// `timing` is given; where laws stay unmet as asked for, other times are tried before it is eased. Where it is audited
/// and none passes, it is eased on, if that is asked for, until one does.
CentroidalOutcome RunCase(const CentroidalProblemSet& set, const CentroidalCase& one, const CentroidalTask& task,
                          const RigidBodyOptions& options, const CaseChoices& choices = {});

/// The outcomes as a table for people, and what they come to; with a second one where times were variables.
std::string CentroidalTable(const std::vector<CentroidalOutcome>& outcomes);

}  // namespace gaitwright
