// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/hold_goal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "optimisation/centroidal/body_trajectory.h"
#include "optimisation/centroidal/choose_footholds.h"

namespace gaitwright {
namespace {

/// Whether there is a heading in which no force of these friction cones pushes forward. In that case no sum of forces
/// is vertical.
bool OneSided(const std::vector<Vector3>& normals_W, double friction) {
  constexpr int kHeadings = 720;
  const double half = std::atan(friction);
  for (int i = 0; i < kHeadings; ++i) {
    const double heading = 2.0 * std::numbers::pi * i / kHeadings;
    const Vector3 forward(std::cos(heading), std::sin(heading), 0.0);
    if (std::all_of(normals_W.begin(), normals_W.end(), [&](const Vector3& normal) {
          return std::acos(std::clamp(normal.dot(forward), -1.0, 1.0)) - half > 0.5 * std::numbers::pi;
        }))
      return true;
  }
  return false;
}

}  // namespace

double LeastHoldingFriction(const std::vector<Vector3>& normals_W, double most) {
  if (normals_W.empty() || OneSided(normals_W, most)) return std::numeric_limits<double>::infinity();
  double fails = 0.0, holds = most;
  while (holds - fails > 1e-5 * most) {
    const double middle = 0.5 * (fails + holds);
    (OneSided(normals_W, middle) ? fails : holds) = middle;
  }
  return holds;
}

GoalGround LookAtGoal(const Terrain& terrain, const RigidBodyProblem& problem, double edge_margin_m,
                      double tolerance_m) {
  GoalGround ground;
  std::vector<Vector3> held;               // normals of feet that do not move
  std::set<std::set<int>> choices = {{}};  // combinations of patches for the other feet
  const RigidBodyState& goal = problem.goal;
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    if (problem.stances[s].end_s < problem.duration_s) continue;
    if (problem.stances[s].held) {
      held.emplace_back(problem.stances[s].X_WF.linear().col(2));
      ground.friction = std::max(ground.friction, problem.stances[s].friction);
      continue;
    }
    const Vector3 wanted = goal.p_WC + RotationOf(goal.angles_rad) * FootOf(problem, s).p_CF_nominal_B;
    double least = std::numeric_limits<double>::infinity();
    std::set<std::set<int>> longer;
    for (int patch = 0; patch < static_cast<int>(terrain.patches.size()); ++patch) {
      RigidBodyProblem there = problem;
      RigidStance& stance = there.stances[s];
      if (!PutOnPatch(terrain, patch, wanted, edge_margin_m, stance)) continue;
      const double out = LeastOutOfReach(there, s, goal);
      least = std::min(least, out);
      if (out > tolerance_m) continue;
      ground.friction = std::max(ground.friction, stance.friction);
      for (std::set<int> choice : choices) {
        choice.insert(patch);
        longer.insert(std::move(choice));
      }
    }
    choices = std::move(longer);
    if (least <= std::max(tolerance_m, ground.out_of_reach_m)) continue;
    ground.out_of_reach_m = least;
    ground.foot = problem.stances[s].foot;
  }
  if (ground.foot >= 0 || !goal.v_WC.isZero() || !goal.w_WB_B.isZero()) return ground;
  ground.needed_friction = std::numeric_limits<double>::infinity();
  for (const std::set<int>& choice : choices) {
    std::vector<Vector3> normals = held;
    for (const int patch : choice)
      normals.emplace_back(terrain.patches[static_cast<std::size_t>(patch)].X_WT.linear().col(2));
    ground.needed_friction = std::min(ground.needed_friction, LeastHoldingFriction(normals));
  }
  return ground;
}

}  // namespace gaitwright
