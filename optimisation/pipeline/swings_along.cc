// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/swings_along.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "optimisation/pipeline/walk_problem.h"
#include "optimisation/swing/free_swings.h"
#include "optimisation/swing/refine_swing.h"
#include "optimisation/swing/swing_guard.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

/// How far a swing foot is out of the reach of its leg along a motion [m].
double StrayOf(const RigidFoot& foot, const SwingTrajectory& swing, double start_s,
               const std::vector<RigidBodySample>& samples, const SwingRoll& roll) {
  std::vector<ReachAt> reach;
  for (const RigidBodySample& sample : samples) {
    const double u = (start_s + sample.time_s - swing.start_s) / (swing.end_s - swing.start_s);
    if (u <= 0.0 || u >= 1.0) continue;
    reach.push_back({u, SidesInWorld(foot.workspace_in_air_B, sample.p_WC, RotationOf(sample.angles_rad), 0.0)});
  }
  return reach.empty() ? 0.0 : OutOfReach(CurveOf(swing), reach, roll);
}

FormerMotion RollingOf(const FormerMotion& former) {
  FormerMotion rolling;
  rolling.roll = former.roll;
  return rolling;
}

bool Overlap(const SwingTrajectory& a, const SwingTrajectory& b) { return a.start_s < b.end_s && b.start_s < a.end_s; }

}  // namespace

MotionVerdict CheckSwings(const MotionTask& task, const PlanOverPatches& motion, const FormerMotion& former) {
  constexpr double kStray = 3e-3;  // [m], for the whole body to make up for
  const RigidBodyProblem& problem = motion.choice.problem;
  const double start_s = task.skeleton.schedule.start_s();
  const std::vector<RigidBodySample> samples = Sample(motion.plan.motion, task.options.pipeline.grid_step_s);
  const SwingGuard guard(task.model, task.terrain, RollingOf(former));
  std::vector<SwingTrajectory> swings, troubled;
  MotionVerdict verdict;
  for (std::size_t i = 0; i < problem.swings.size(); ++i) {
    swings.push_back(SwingOf(problem, motion.plan.motion, i, start_s));
    const SwingTrajectory& swing = swings.back();
    const double stray_m =
        StrayOf(problem.feet[static_cast<std::size_t>(swing.foot)], swing, start_s, samples, guard.RollOf(swing));
    const std::optional<SwingHit> hit = guard.Check(swing, 0.0, false);
    if (stray_m <= kStray && !hit) continue;
    troubled.push_back(swing);
    verdict.stray_m = std::max({verdict.stray_m, stray_m, hit ? std::abs(hit->distance_m) : 0.0});
  }
  verdict.passes = troubled.empty();
  verdict.swings = problem.swings;
  std::vector<int> feet(problem.feet.size());
  std::iota(feet.begin(), feet.end(), 0);
  for (std::size_t i = 0; i < swings.size(); ++i) {
    const bool with_troubled = std::any_of(troubled.begin(), troubled.end(),
                                           [&](const SwingTrajectory& other) { return Overlap(swings[i], other); });
    if (!with_troubled && !problem.swings[i].free) continue;
    const std::vector<RigidSwing> free = FreeSwingsOf(task.terrain, problem, {swings[i]}, feet, start_s);
    if (!free.empty()) verdict.swings[i] = free.front();
  }
  return verdict;
}

bool SwingsTouch(const MotionTask& task, const PlanOverPatches& motion, const FormerMotion& former) {
  const SwingGuard guard(task.model, task.terrain, RollingOf(former));
  const RigidBodyProblem& problem = motion.choice.problem;
  for (std::size_t i = 0; i < problem.swings.size(); ++i) {
    const SwingTrajectory swing = SwingOf(problem, motion.plan.motion, i, task.skeleton.schedule.start_s());
    if (guard.Check(swing, 0.0, false)) return true;
  }
  return false;
}

std::optional<PlanOverPatches> WithSwingsAlong(const MotionTask& task, const PlanOverPatches& motion,
                                               const RigidBodyOptions& options, const FormerMotion& former) {
  RefineRules rules;
  rules.patches = WalkPatchRules(task);
  rules.most_rounds = 4;
  rules.most_halvings = rules.most_changes = 0;
  int checks = 0;
  const Result<RefinedMotion> refined = RefineMotion(task.terrain, motion, options, rules, [&](const auto& attempt) {
    ++checks;
    return Result<MotionVerdict>(CheckSwings(task, attempt, former));
  });
  if (!refined || !refined->passes || checks == 1) return std::nullopt;
  PlanOverPatches found = refined->motion;
  std::vector<RigidSwing> given = found.choice.problem.swings;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i].free) continue;
    const SwingTrajectory swing = SwingOf(found.choice.problem, found.plan.motion, i, 0.0);
    given[i].detour_W = swing.detour_W;
    given[i].lift_m = swing.lift_m;
    given[i].free = false;
    given[i].shares.clear();
    given[i].planes.clear();
  }
  TakeSwings(given, found.choice.problem, found.plan.numbers.x);
  return found;
}

}  // namespace gaitwright
