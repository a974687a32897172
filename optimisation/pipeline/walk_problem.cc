// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/walk_problem.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "kinematics/stability/polygon.h"
#include "optimisation/pipeline/fitted_options.h"

namespace gaitwright {
namespace {

constexpr double kWorkspaceMargin = 0.03;  // margin as a share of the legs' workspaces

/// The swings between the stances of a walk.
std::vector<RigidSwing> SwingsOf(const RigidBodyProblem& problem, double from_s, const FlightSwings& shapes) {
  std::vector<RigidSwing> swings;
  for (std::size_t from = 0; from < problem.stances.size(); ++from) {
    for (std::size_t to = from + 1; to < problem.stances.size(); ++to) {
      const RigidStance &a = problem.stances[from], &b = problem.stances[to];
      if (a.foot != b.foot) continue;
      const FlightSwing shape = shapes.At(from_s + a.end_s, from_s + b.start_s);
      swings.push_back({from, to, shape.lift_m, shape.cruise});
      break;
    }
  }
  return swings;
}

/// Frees the footholds of feet without soles between start and goal: they may move on their patches, near their present
/// places and as far from edges as they may roll.
void FreeFootholds(const MotionTask& task, RigidBodyProblem& problem) {
  const PatchRules rules = WalkPatchRules(task);
  for (std::size_t i = 0; i < problem.stances.size(); ++i) {
    RigidStance& stance = problem.stances[i];
    const Foothold& foothold = task.skeleton.footsteps.footholds[i];
    const Foot& foot = task.model.feet[static_cast<std::size_t>(stance.foot)];
    const bool within = stance.start_s > 0.0 && stance.end_s < problem.duration_s;
    const bool on_patch = foothold.patch < static_cast<int>(task.terrain.patches.size());
    if (!stance.held || !within || !on_patch || foot.has_sole()) continue;
    stance.held = !rules.put(foothold.patch, foothold.X_WF.translation(), stance);
  }
}

}  // namespace

bool HasFreeFootholds(const MotionTask& task) {
  return task.options.footholds == "free" && KindOfGround(task.terrain) != GroundKind::kFlat;
}

StandingBody CarriedBody(const RobotModel& model, const Crouch* crouch) {
  StandingBody body = BodyOf(model, kWorkspaceMargin);
  if (crouch == nullptr) return body;
  body.p_SB = crouch->p_SB;
  if (crouch->highest_m == 0.0) return body;
  for (RigidFoot& foot : body.feet) foot.workspace_B.push_back({-Vector3::UnitZ(), crouch->highest_m});
  return body;
}

PatchRules WalkPatchRules(const MotionTask& task) {
  constexpr double kNear = 0.25;  // of the leg
  const double near_m = kNear * task.model.leg_length_m();
  const FootholdOptions& foothold = task.options.footsteps.foothold;
  const double least_up = std::cos(foothold.slope_deg * std::numbers::pi / 180.0);
  PatchRules rules;
  rules.fits_path = false;
  rules.put = [=, &task](int patch, const Vector3& p_W, RigidStance& stance) {
    if (task.terrain.patches[static_cast<std::size_t>(patch)].X_WT.linear()(2, 2) < least_up) return false;
    const Foot& foot = task.model.feet[static_cast<std::size_t>(stance.foot)];
    RigidStance put = stance;
    if (!PutOnPatch(task.terrain, patch, p_W, foothold.margin_m + foot.radius, put)) return false;
    for (const Vector2& normal : {Vector2(1, 0), Vector2(0, 1), Vector2(-1, 0), Vector2(0, -1)})
      put.region_F = Clipped(put.region_F, normal, -near_m);
    if (put.region_F.size() < 3) return false;
    put.friction *= task.options.whole_body.friction_use;
    stance = std::move(put);
    return true;
  };
  return rules;
}

std::vector<int> PatchesOf(const MotionTask& task, const RigidBodyProblem& problem) {
  std::vector<int> patches;
  for (std::size_t i = 0; i < problem.stances.size(); ++i)
    patches.push_back(problem.stances[i].held ? -1 : task.skeleton.footsteps.footholds[i].patch);
  return patches;
}

RigidBodyProblem WalkProblem(const MotionTask& task, const StandingBody& body, const Crouch* crouch,
                             const FlightSwings& shapes) {
  RigidBodyProblem problem = ProblemOf(task.model, body, task.terrain, task.skeleton, task.body);
  for (RigidStance& stance : problem.stances) stance.friction *= task.options.whole_body.friction_use;
  if (HasFreeFootholds(task)) FreeFootholds(task, problem);
  if (crouch != nullptr) problem.rise_max_m_s = crouch->fastest_m_s;
  problem.swings = SwingsOf(problem, task.skeleton.schedule.start_s(), shapes);
  return problem;
}

RigidBodyOptions WalkOptions(const MotionTask& task, const RigidBodyProblem& problem) {
  RigidBodyOptions options =
      FittedOptions(task.model, LongestFlight(task.skeleton.schedule), problem.rise_max_m_s, task.options.rigid_body);
  options.grid_s = task.options.pipeline.grid_step_s;
  return options;
}

}  // namespace gaitwright
