// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/whole_body_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "kinematics/base/cpu_clock.h"
#include "kinematics/model/load_robot.h"
#include "planning/audit/audit.h"
#include "planning/plan/built_in_terrain.h"

namespace gaitwright {
namespace {

constexpr double kFriction = 0.8;

/// The plan of a case; the failure of the stage that has none.
Result<PlannedMotion> PlanCase(const RobotModel& model, const WholeBodyCase& one, const MotionOptions& options) {
  WalkCommand command;
  command.speed_m_s = one.speed_m_s;
  command.distance_m = one.distance_m;
  const Result<Gait> gait = FindGait(model, one.gait, CommandedSpeed(model, command), one.timing);
  if (!gait) return gait.failure();
  return PlanMotion(model, FlatTerrain(kFriction), *gait, command, options);
}

}  // namespace

std::vector<WholeBodyCase> WholeBodyCases(const std::string& filter) {
  std::vector<WholeBodyCase> cases = {
      {"a1-walk", "a1", "crawl", 0.1, 0.5},
      {"a1-trot-1.5", "a1", "trot", 1.5, 5.0},
      {"a1-trot-3.5", "a1", "trot", 3.5, 5.0},
      {"a1-pace-1.5", "a1", "pace", 1.5, 5.0},
      {"a1-bound-2", "a1", "bound", 2.0, 5.0},
      {"a1-gallop-3", "a1", "gallop", 3.0, 5.0},
      {"a1-pronk-1", "a1", "pronk", 1.0, 5.0},
      {"laikago-trot-1", "laikago", "trot", 1.0, 2.0},
      {"laikago-pace-1", "laikago", "pace", 1.0, 2.0},
      {"laikago-bound-1", "laikago", "bound", 1.0, 2.0},
      {"nao-walk", "nao", "walk", 0.08, 0.3},
      {"humanoid-walk", "humanoid", "walk", 0.2, 0.6},
      {"a1-chain-200", "a1", "trot", 0.4, 0.1},
      {"a1-chain-500", "a1", "trot", 0.4, 1.3},
      {"a1-chain-1000", "a1", "trot", 0.4, 3.3},
      {"a1-chain-2000", "a1", "trot", 0.4, 7.3},
  };
  const std::vector<std::pair<std::string, int>> of_tasks = {{"a1", 4}, {"laikago", 4}, {"h1_2", 2}};
  for (const auto& [robot, legs] : of_tasks) {
    for (const WholeBodyCase& task : StepTasks(robot, legs)) cases.push_back(task);
  }
  std::erase_if(cases, [&](const WholeBodyCase& one) { return one.name.find(filter) == std::string::npos; });
  return cases;
}

std::vector<WholeBodyCase> StepTasks(const std::string& robot, int legs) {
  struct Task {
    const char *name, *gait;
    double length_m, height_m, swing_s, between_s;
    int swings;  // one after the other in a cycle
  };
  const std::vector<Task> quadruped = {{"walk", "crawl", 0.25, 0.15, 0.25, 0.02, 4},
                                       {"trot", "trot", 0.15, 0.1, 0.25, 0.02, 2},
                                       {"pace", "pace", 0.15, 0.1, 0.25, 0.05, 2},
                                       {"bound", "bound", 0.15, 0.1, 0.25, 0.05, 2},
                                       {"jump", "jump", 0.3, 0.0, 0.4, 0.6, 1}};
  const std::vector<Task> biped = {{"walk", "walk", 0.6, 0.1, 1.05, 0.3, 2}};
  constexpr double kCycles = 2.0;
  std::vector<WholeBodyCase> tasks;
  if (legs != 2 && legs != 4) return tasks;
  for (const Task& task : legs == 4 ? quadruped : biped) {
    const double cycle_s = task.swings * (task.swing_s + task.between_s);
    const double cycles = task.swings == 1 ? 1.0 : kCycles;
    tasks.push_back({fmt::format("{}-step-{}", robot, task.name),
                     robot,
                     task.gait,
                     task.length_m / cycle_s,
                     cycles * task.length_m,
                     {.cycle_s = cycle_s, .duty_factor = 1.0 - task.swing_s / cycle_s},
                     task.height_m});
  }
  return tasks;
}

double WholeBodyOutcome::MsAnIteration() const {
  return finished && finished->iterations > 0 ? 1e3 * finished->solve_cpu_s / finished->iterations : 0.0;
}

WholeBodyOutcome RunWholeBodyCase(const WholeBodyCase& one, const MotionOptions& options) {
  const Result<RobotModel> model = LoadNamedRobot(one.robot);
  if (model) return RunWholeBodyCase(*model, one, options);
  WholeBodyOutcome outcome;
  outcome.one = one;
  outcome.reason = model.failure().message;
  return outcome;
}

WholeBodyOutcome RunWholeBodyCase(const RobotModel& model, const WholeBodyCase& one, MotionOptions options) {
  options.trajectory.method = "whole-body";
  if (one.swing_height_m > 0.0) options.swing.height_m = one.swing_height_m;
  WholeBodyOutcome outcome;
  outcome.one = one;
  const CpuClock clock;
  const Result<PlannedMotion> planned = PlanCase(model, one, options);
  outcome.planning_cpu_s = clock.elapsed_s();
  if (!planned) {
    outcome.reason = planned.failure().message;
    return outcome;
  }
  if (planned->unfinished) outcome.reason = planned->unfinished->message;
  outcome.finished = planned->finished;
  const Result<AuditReport> audit = Audit(model, planned->plan, {});
  outcome.passes_audit = audit && audit->pass();
  if (audit && !audit->violations.empty() && outcome.reason.empty()) {
    const Violation& first = audit->violations.front();
    outcome.reason = fmt::format("the audit finds {} at {:.3f} s, {}", LawName(first.law), first.at_s, first.where);
  }
  return outcome;
}

std::string WholeBodyTable(const std::vector<WholeBodyOutcome>& outcomes) {
  std::size_t width = 16;
  for (const WholeBodyOutcome& outcome : outcomes) width = std::max(width, outcome.one.name.size());
  std::string text =
      fmt::format("{:<{}} {:>6} {:>7} {:>11} {:>8} {:>14} {:>10} {:>10} {:>8} {:>6}\n", "case", width, "knots",
                  "solves", "iterations", "ms each", "ms, 200 knots", "force m g", "m. m g l", "CPU [s]", "audit");
  for (const WholeBodyOutcome& outcome : outcomes) {
    if (!outcome.finished) {
      text += fmt::format("{:<{}} {}\n", outcome.one.name, width, outcome.reason);
      continue;
    }
    const FinishReport& report = *outcome.finished;
    text += fmt::format("{:<{}} {:>6} {:>7} {:>11} {:>8.1f} {:>14.1f} {:>10.1e} {:>10.1e} {:>8.2f} {:>6}\n",
                        outcome.one.name, width, report.knots, report.solves, report.iterations,
                        outcome.MsAnIteration(), 200.0 * outcome.MsAnIteration() / report.knots, report.residual_force,
                        report.residual_moment, outcome.planning_cpu_s, outcome.passes_audit ? "pass" : "fail");
    if (!outcome.passes_audit) text += fmt::format("{:<{}} {}\n", "", width, outcome.reason);
  }
  return text;
}

}  // namespace gaitwright
