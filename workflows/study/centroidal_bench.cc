// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/centroidal_bench.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>

#include "optimisation/centroidal/hold_goal.h"
#include "optimisation/centroidal/plan_over_terrain.h"
#include "workflows/study/audited_motion.h"
#include "workflows/study/rigid_body_plan.h"

namespace gaitwright {
namespace {

double CpuMs() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double PeakMemoryMb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::string NameOf(const CentroidalProblemSet& set, const CentroidalCase& one) {
  return fmt::format("{}-{}-{}", set.robots[one.robot].first, one.schedule, set.grounds[one.ground].name);
}

/// The median; 0 for an empty list.
double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

/// Optimises the contact times of a motion.
TimingOutcome Timed(const PlanOverPatches& plan, bool solved, const RigidBodyOptions& options,
                    const TimingOptions& timing) {
  const double start = CpuMs();
  const Result<TimedPlan> timed = OptimiseTiming(plan.choice.problem, options, timing, solved ? &plan.plan : nullptr);
  TimingOutcome outcome;
  outcome.cpu_ms = CpuMs() - start;
  if (!timed) {
    outcome.refusal = timed.failure().message;
    return outcome;
  }
  outcome.mended = timed->mended;
  outcome.cost_before = timed->first_cost;
  outcome.cost = timed->plan.summary.cost;
  outcome.duration_s = timed->problem.duration_s;
  outcome.steps = timed->steps;
  outcome.solves = timed->solves;
  outcome.node_violation = timed->plan.summary.violation;
  outcome.between = FaultsOf(timed->problem, timed->plan.motion, 1e-3);
  outcome.keeps = outcome.node_violation <= options.tolerance && outcome.between.Largest() <= options.fault_tolerance;
  return outcome;
}

/// Audits a motion over a ground.
AuditOutcome Audited(const Terrain& ground, const PlanOverPatches& plan, const RigidBodyOptions& options) {
  constexpr int kMostRounds = 40;
  const double start = CpuMs();
  AuditOutcome outcome;
  const Result<AuditedMotion> audited = RefineByAudit(ground, plan, options, kMostRounds);
  outcome.cpu_ms = CpuMs() - start;
  if (!audited) {
    outcome.refusal = audited.failure().message;
    return outcome;
  }
  outcome.first = audited->first;
  outcome.report = audited->report;
  outcome.refusal = audited->refusal;
  outcome.swings_planned = audited->swings_planned;
  outcome.halvings = audited->halvings;
  outcome.changes = audited->changes;
  return outcome;
}

/// Makes one attempt at a case. @return its last state.
PlanOverPatches Attempt(const CentroidalProblemSet& set, const CentroidalCase& one, const CentroidalTask& task,
                        const RigidBodyOptions& options, CentroidalOutcome& outcome) {
  const CentroidalRobot& robot = set.robots[one.robot].second;
  const Terrain ground = WithFriction(set.grounds[one.ground], task.friction);
  const double start = CpuMs();
  PlanOverPatches last;
  const Result<PlanOverPatches> plan = PlanOverTerrain(
      ground, CentroidalProblem(robot, robot.schedules[one.schedule], ground, task), {}, options, {}, &last);
  outcome.cpu_ms = CpuMs() - start;
  outcome.solved = plan.ok();
  outcome.reason = plan ? "" : plan.failure().message;
  outcome.task = task;
  outcome.variables = last.plan.summary.variables;
  outcome.constraints = last.plan.summary.constraints;
  outcome.iterations = last.plan.summary.iterations;
  outcome.choices = last.choices;
  outcome.cost = last.plan.summary.cost;
  outcome.node_violation = last.plan.summary.violation;
  outcome.between = last.plan.summary.faults;
  return last;
}

/// The ground under the feet at the goal of a task.
GoalGround GoalOf(const CentroidalProblemSet& set, const CentroidalCase& one, const CentroidalTask& task) {
  const CentroidalRobot& robot = set.robots[one.robot].second;
  const Terrain ground = WithFriction(set.grounds[one.ground], task.friction);
  const ChooseFootholdsOptions choosing;
  return LookAtGoal(ground, CentroidalProblem(robot, robot.schedules[one.schedule], ground, task),
                    choosing.edge_margin_m, choosing.misfit_m);
}

/// Goals for easing a task, the smallest change first: the original goal if all feet reach ground there, otherwise a
/// higher or lower one; then a closer goal, where the ground can hold a body at rest, one step before the first such
/// place.
std::vector<CentroidalTask> Goals(const CentroidalProblemSet& set, const CentroidalCase& one,
                                  const CentroidalTask& task) {
  std::vector<CentroidalTask> goals;
  CentroidalTask goal = task;
  for (const double higher : {0.0, -0.05, 0.05, -0.1, 0.1}) {
    goal.higher_m = task.higher_m + higher;
    if (goals.empty() && GoalOf(set, one, goal).foot < 0) goals.push_back(goal);
  }
  goal = task;
  constexpr double kStep = 0.1;
  while (goal.distance_m > 2.0 * kStep) {
    goal.distance_m -= kStep;
    const GoalGround ground = GoalOf(set, one, goal);
    if (ground.foot >= 0 || ground.needed_friction > ground.friction) continue;
    goal.distance_m -= kStep;
    goals.push_back(goal);
    break;
  }
  return goals;
}

/// Easier versions of a case, the smallest change first.
std::vector<CentroidalTask> Eased(const CentroidalProblemSet& set, const CentroidalCase& one,
                                  const CentroidalTask& task) {
  std::vector<CentroidalTask> eased;
  for (const CentroidalTask& goal : Goals(set, one, task)) {
    const double needed = GoalOf(set, one, goal).needed_friction;
    std::vector<double> frictions = {task.friction, 0.8, 1.0};
    // Friction that just holds a body at rest leaves no margin for braking.
    if (needed > task.friction) frictions.insert(frictions.end(), {1.2 * needed, 2.0 * needed});
    for (const double friction : frictions) {
      if (friction < std::max(task.friction, needed)) continue;
      for (const double stretch : {1.0, 1.5, 2.0, 3.0})
        eased.push_back({goal.distance_m, stretch * task.duration_s, friction, goal.higher_m});
    }
  }
  if (!eased.empty() && eased.front() == task) eased.erase(eased.begin());
  return eased;
}

double ForceFaults(const RigidBodyFaults& faults) { return std::max({0.0, faults.friction, faults.unilateral}); }
double FootFaults(const RigidBodyFaults& faults) { return std::max({0.0, faults.reach_m, faults.foothold_m}); }

/// The easier version of a case, as text.
std::string HowEased(const CentroidalTask& task) {
  return fmt::format("{:.1f} m{} in {:.1f} s, mu {:.1f}", task.distance_m,
                     task.higher_m == 0.0 ? "" : fmt::format(" {:+.2f}", task.higher_m), task.duration_s,
                     task.friction);
}

/// "pass", or the first violated check.
std::string FirstOf(const AuditReport& report) {
  if (report.samples == 0) return "no plan";
  if (report.pass()) return "pass";
  const Violation& first = report.violations.front();
  return fmt::format("{} {:.3f} s", LawName(first.law), first.at_s);
}

/// Table of audit results: of motions as first planned, and after repeated planning until they pass. Empty without an
/// audit.
std::string AuditTable(const std::vector<CentroidalOutcome>& outcomes) {
  std::string table;
  std::vector<double> cpu_ms;
  int asked = 0, asked_pass = 0, eased = 0, eased_pass = 0, first_pass = 0, mended = 0;
  for (const CentroidalOutcome& o : outcomes) {
    if (!o.audit) continue;
    const int pass = o.audit->pass() ? 1 : 0;
    (o.eased ? eased : asked) += 1;
    (o.eased ? eased_pass : asked_pass) += pass;
    cpu_ms.push_back(o.audit->cpu_ms);
    first_pass += o.audit->first.samples > 0 && o.audit->first.pass() ? 1 : 0;
    table += fmt::format("{:<8} {:<18} {:<10} {:<24} {:>6} {:>6} {:>7.0f}\n", o.robot, o.schedule, o.ground,
                         FirstOf(o.audit->first), o.audit->swings_planned, o.audit->halvings, o.audit->cpu_ms);
    if (pass == 1) continue;
    table += "         " + AuditText(o.audit->report);
    if (!o.audit->refusal.empty()) table += "         " + o.audit->refusal + "\n";
    if (o.audit->eased) table += fmt::format("         passes if eased to {}\n", HowEased(*o.audit->eased));
    mended += o.audit->eased ? 1 : 0;
  }
  if (cpu_ms.empty()) return "";
  return fmt::format("\n{:<8} {:<18} {:<10} {:<24} {:>6} {:>6} {:>7}\n", "robot", "schedule", "ground",
                     "audit as planned", "swings", "halved", "CPU ms") +
         table +
         fmt::format(
             "{} of {} original motions pass their audit in the end, {} of {} eased ones, {} more if eased for it; {} "
             "of all as first planned; median CPU {:.0f} ms\n",
             asked_pass, asked, eased_pass, eased, mended, first_pass, Median(cpu_ms));
}

/// Table of costs with optimised contact times; empty if they were not optimised.
std::string TimingTable(const std::vector<CentroidalOutcome>& outcomes) {
  constexpr double kMuch = 0.05;
  std::string table =
      fmt::format("\n{:<8} {:<18} {:<10} {:>9} {:>9} {:>6} {:>6} {:>6} {:>7} {:>8} {:>8} {:>8}\n", "robot", "schedule",
                  "ground", "cost", "timed", "fall %", "s", "solves", "CPU ms", "1 kHz", "forces", "feet");
  std::vector<double> falls, cpu_ms;
  int tried = 0, kept = 0, much = 0, mended = 0, without = 0;
  for (const CentroidalOutcome& o : outcomes) {
    if (!o.timing) continue;
    const TimingOutcome& t = *o.timing;
    (o.solved ? tried : without) += 1;
    table += fmt::format("{:<8} {:<18} {:<10} ", o.robot, o.schedule, o.ground);
    if (!t.refusal.empty()) {
      table += t.refusal + "\n";
      continue;
    }
    table += fmt::format("{:>9.4f} {:>9.4f} {:>6.1f} {:>6.3f} {:>6} {:>7.1f} {:>8.1e} {:>8.1e} {:>8.1e}\n",
                         t.cost_before, t.cost, 100.0 * t.Fall(), t.duration_s, t.solves, t.cpu_ms, t.between.Largest(),
                         ForceFaults(t.between), FootFaults(t.between));
    if (!o.solved) {
      mended += t.keeps ? 1 : 0;
      continue;
    }
    falls.push_back(t.Fall());
    cpu_ms.push_back(t.cpu_ms);
    kept += t.keeps ? 1 : 0;
    much += t.Fall() >= kMuch ? 1 : 0;
  }
  if (without > 0)
    table += fmt::format("{} of {} cases that are infeasible with the given timing are feasible with another\n", mended,
                         without);
  if (tried == 0) return without > 0 ? table : "";
  return table + fmt::format(
                     "{} of {} timed motions satisfy all constraints; the cost falls by {:.1f} % in the median and by "
                     "{:.0f} % or more in {}; median CPU {:.1f} ms\n",
                     kept, tried, 100.0 * Median(falls), 100.0 * kMuch, much, Median(cpu_ms));
}

/// Audits a motion of a task.
AuditOutcome AuditOf(const CentroidalProblemSet& set, const CentroidalCase& one, const CentroidalTask& task,
                     const PlanOverPatches& plan, const RigidBodyOptions& options) {
  AuditOutcome outcome = Audited(WithFriction(set.grounds[one.ground], task.friction), plan, options);
  outcome.task = task;
  return outcome;
}

/// Eases a task further until one of its motions passes its audit.
void EaseForAudit(const CentroidalProblemSet& set, const CentroidalCase& one, const RigidBodyOptions& options,
                  AuditOutcome& failed) {
  constexpr int kMostTasks = 6;
  int tasks = 0;
  for (const CentroidalTask& eased : Eased(set, one, failed.task)) {
    CentroidalOutcome attempt;
    const PlanOverPatches plan = Attempt(set, one, eased, options, attempt);
    if (!attempt.solved) continue;
    if (++tasks > kMostTasks) return;
    AuditOutcome outcome = AuditOf(set, one, eased, plan, options);
    failed.cpu_ms += outcome.cpu_ms;
    if (!outcome.pass()) continue;
    failed.eased = eased;
    failed.eased_report = outcome.report;
    return;
  }
}

}  // namespace

std::vector<CentroidalCase> CasesOf(const CentroidalProblemSet& set, const std::string& filter) {
  std::vector<CentroidalCase> cases;
  for (std::size_t ground = 0; ground < set.grounds.size(); ++ground) {
    for (std::size_t robot = 0; robot < set.robots.size(); ++robot) {
      for (std::size_t schedule = 0; schedule < set.robots[robot].second.schedules.size(); ++schedule) {
        const CentroidalCase one{robot, schedule, ground};
        if (NameOf(set, one).find(filter) != std::string::npos) cases.push_back(one);
      }
    }
  }
  return cases;
}

CentroidalOutcome RunCase(const CentroidalProblemSet& set, const CentroidalCase& one, const CentroidalTask& task,
                          const RigidBodyOptions& options, const CaseChoices& choices) {
  const std::optional<TimingOptions>& timing = choices.timing;
  CentroidalOutcome outcome;
  outcome.robot = set.robots[one.robot].first;
  outcome.schedule = fmt::format("{} {}", one.schedule, set.robots[one.robot].second.schedules[one.schedule].name);
  outcome.ground = set.grounds[one.ground].name;
  outcome.task = task;
  PlanOverPatches last = Attempt(set, one, task, options, outcome);
  if (!outcome.solved && timing && last.choices > 0) outcome.timing = Timed(last, false, options, *timing);
  const bool mended = outcome.timing && outcome.timing->keeps;
  if (!outcome.solved && choices.ease && !mended) {
    const CentroidalOutcome asked = outcome;
    for (const CentroidalTask& eased : Eased(set, one, task)) {
      last = Attempt(set, one, eased, options, outcome);
      if (outcome.solved) break;
    }
    outcome.reason = asked.reason;
    outcome.cpu_ms = asked.cpu_ms;
    outcome.eased = outcome.solved;
    if (!outcome.solved) outcome = asked;
  }
  if (outcome.solved && timing) outcome.timing = Timed(last, true, options, *timing);
  if (outcome.solved && choices.audit) outcome.audit = AuditOf(set, one, outcome.task, last, options);
  if (outcome.audit && !outcome.audit->pass() && choices.ease) EaseForAudit(set, one, options, *outcome.audit);
  outcome.peak_memory_mb = PeakMemoryMb();
  return outcome;
}

std::string CentroidalTable(const std::vector<CentroidalOutcome>& outcomes) {
  std::string table =
      fmt::format("{:<8} {:<18} {:<10} {:<28} {:>5} {:>5} {:>7} {:>8} {:>8} {:>8} {:>8} {:>6}\n", "robot", "schedule",
                  "ground", "", "vars", "iter", "CPU ms", "nodes", "1 kHz", "forces", "feet", "MB");
  std::vector<double> cpu_ms;
  int solved = 0, eased = 0;
  for (const CentroidalOutcome& o : outcomes) {
    const std::string how = !o.solved ? "no motion" : o.eased ? HowEased(o.task) : "solved";
    table +=
        fmt::format("{:<8} {:<18} {:<10} {:<16} {:>5} {:>5} {:>7.1f} {:>8.1e} {:>8.1e} {:>8.1e} {:>8.1e} {:>6.0f}\n",
                    o.robot, o.schedule, o.ground, how, o.variables, o.iterations, o.cpu_ms, o.node_violation,
                    o.between.Largest(), ForceFaults(o.between), FootFaults(o.between), o.peak_memory_mb);
    if (!o.reason.empty()) table += fmt::format("         original task: {}\n", o.reason);
    solved += o.solved && !o.eased ? 1 : 0;
    eased += o.eased ? 1 : 0;
    if (o.solved && !o.eased) cpu_ms.push_back(o.cpu_ms);
  }
  table += fmt::format("{} of {} cases solved as given, {} more if eased; median CPU of solved cases {:.1f} ms\n",
                       solved, outcomes.size(), eased, Median(cpu_ms));
  return table + AuditTable(outcomes) + TimingTable(outcomes);
}

}  // namespace gaitwright
