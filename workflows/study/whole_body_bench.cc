// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/whole_body_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "kinematics/base/cpu_clock.h"
#include "kinematics/model/load_robot.h"
#include "planning/audit/audit.h"
#include "planning/gait/find_gait.h"
#include "planning/plan/built_in_terrain.h"

namespace gaitwright {
namespace {

constexpr double kFriction = 0.8;

/// The plan of a case; the failure of the stage that has none.
Result<PlannedMotion> PlanCase(const RobotModel& model, const WholeBodyCase& one, const MotionOptions& options) {
  WalkCommand command;
  command.speed_m_s = one.speed_m_s;
  command.distance_m = one.distance_m;
  const Result<Gait> gait = FindGait(model, one.gait, CommandedSpeed(model, command), {});
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
  std::erase_if(cases, [&](const WholeBodyCase& one) { return one.name.find(filter) == std::string::npos; });
  return cases;
}

double WholeBodyOutcome::MsAnIteration() const {
  return finished && finished->iterations > 0 ? 1e3 * finished->solve_cpu_s / finished->iterations : 0.0;
}

WholeBodyOutcome RunWholeBodyCase(const WholeBodyCase& one, MotionOptions options) {
  options.trajectory.method = "whole-body";
  WholeBodyOutcome outcome;
  outcome.one = one;
  const Result<RobotModel> model = LoadNamedRobot(one.robot);
  if (!model) {
    outcome.reason = model.failure().message;
    return outcome;
  }
  const CpuClock clock;
  const Result<PlannedMotion> planned = PlanCase(*model, one, options);
  outcome.planning_cpu_s = clock.elapsed_s();
  if (!planned) {
    outcome.reason = planned.failure().message;
    return outcome;
  }
  if (planned->unfinished) outcome.reason = planned->unfinished->message;
  outcome.finished = planned->finished;
  const Result<AuditReport> audit = Audit(*model, planned->plan, {});
  outcome.passes_audit = audit && audit->pass();
  return outcome;
}

std::string WholeBodyTable(const std::vector<WholeBodyOutcome>& outcomes) {
  std::string text =
      fmt::format("{:<16} {:>6} {:>7} {:>11} {:>8} {:>14} {:>10} {:>10} {:>8} {:>6}\n", "case", "knots", "solves",
                  "iterations", "ms each", "ms, 200 knots", "force m g", "m. m g l", "CPU [s]", "audit");
  for (const WholeBodyOutcome& outcome : outcomes) {
    if (!outcome.finished) {
      text += fmt::format("{:<16} {}\n", outcome.one.name, outcome.reason);
      continue;
    }
    const FinishReport& report = *outcome.finished;
    text += fmt::format("{:<16} {:>6} {:>7} {:>11} {:>8.1f} {:>14.1f} {:>10.1e} {:>10.1e} {:>8.2f} {:>6}\n",
                        outcome.one.name, report.knots, report.solves, report.iterations, outcome.MsAnIteration(),
                        200.0 * outcome.MsAnIteration() / report.knots, report.residual_force, report.residual_moment,
                        outcome.planning_cpu_s, outcome.passes_audit ? "pass" : "fail");
  }
  return text;
}

}  // namespace gaitwright
