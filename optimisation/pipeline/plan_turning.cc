// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "optimisation/pipeline/plan_turning_internal.h"
#include "optimisation/pipeline/turning_leap_internal.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/robot_of_plan.h"

namespace gaitwright {
namespace {

Failure NoTurn(const std::string& reason) {
  return {FailureKind::kInfeasible, FailureCode::kCommand, "PlanMotion", reason, {}};
}

/// A straight swing between any two footholds of a foot.
std::vector<SwingTrajectory> StraightSwings(const FootstepPlan& footsteps, int feet) {
  std::vector<SwingTrajectory> swings;
  for (int foot = 0; foot < feet; ++foot) {
    const Foothold* before = nullptr;
    for (const Foothold& foothold : footsteps.footholds) {
      if (foothold.foot != foot) continue;
      if (before != nullptr)
        swings.push_back({foot, before->liftoff_s, foothold.touchdown_s, before->X_WF, foothold.X_WF});
      before = &foothold;
    }
  }
  return swings;
}

/// Why the contacts are not those of one turn, or "".
std::string NotOneTurn(const MotionTask& task) {
  const auto moving = [](const MotionPart& part) { return !StandsStill(part.gait); };
  const std::vector<MotionPart>& parts = task.skeleton.parts;
  const auto flight = [](const ContactPhase& phase) { return phase.stance == 0; };
  const std::vector<ContactPhase>& phases = task.skeleton.schedule.phases;
  if (std::count_if(parts.begin(), parts.end(), moving) != 1)
    return "a turn of the body is planned without other parts";
  if (KindOfGround(task.terrain) != GroundKind::kFlat) return "turns of the body are planned on flat ground only";
  if (std::count_if(phases.begin(), phases.end(), flight) != 1) return "the body turns over in exactly one flight";
  return "";
}

}  // namespace

bool TurnsOver(const std::vector<WalkPart>& parts) {
  return std::any_of(parts.begin(), parts.end(), [](const WalkPart& part) { return TurnsOver(part.gait); });
}

double StandingForTurn(const RobotModel& model) {
  const LeapShape shape = LeapShapeOf(model);
  return shape.push_s + shape.crouch_s;
}

TrajectoryOptions TurningOptions(TrajectoryOptions options) {
  constexpr double kNearer = 0.3, kLeastEffort = 1.0, kFineKnots = 0.005;  // [s]
  constexpr int kLeastIterations = 150;
  options.near *= kNearer;
  options.effort = std::max(options.effort, kLeastEffort);
  options.knot_step_s = std::min(options.knot_step_s, kFineKnots);
  options.max_iterations = std::max(options.max_iterations, kLeastIterations);
  return options;
}

Result<MotionPass> GuessTurn(const MotionTask& task) {
  if (const std::string reason = NotOneTurn(task); !reason.empty()) return NoTurn(reason);
  const auto turning = std::find_if(task.skeleton.parts.begin(), task.skeleton.parts.end(),
                                    [](const MotionPart& part) { return TurnsOver(part.gait); });
  MotionPlan plan;
  plan.parts = task.skeleton.parts;
  plan.schedule = task.skeleton.schedule;
  plan.footsteps = task.skeleton.footsteps;
  plan.swings = StraightSwings(plan.footsteps, static_cast<int>(task.model.feet.size()));
  const Vector3 turn_W = 2.0 * std::numbers::pi * Vector3(turning->gait.roll_turns, turning->gait.pitch_turns, 0.0);
  if (auto failure =
          SetTurningLeap(task.model, turn_W, LeapShapeOf(task.model), task.options.pipeline.grid_step_s, plan))
    return *failure;
  MotionPass pass;
  pass.footsteps = std::move(plan.footsteps);
  pass.swings = std::move(plan.swings);
  pass.solution.trajectory = std::move(plan.whole_body);
  return pass;
}

}  // namespace gaitwright
