// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/patch_choices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/stability/polygon.h"
#include "optimisation/centroidal/body_trajectory.h"

namespace gaitwright {
namespace {

/// How far stances are from what they must keep: out of region and reach [m], and beyond friction [0.1 m g], by stance.
std::vector<double> TroubleOf(const RigidBodyProblem& problem, const RigidBodyMotion& motion) {
  std::vector<double> trouble(problem.stances.size(), 0.0);
  for (const RigidBodySample& sample : Sample(motion, 0.01)) {
    const std::vector<RigidBodyInterval::Force>& forces = motion.intervals[sample.interval].forces;
    const Matrix3 R_BW = RotationOf(sample.angles_rad).transpose();
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const std::size_t s = forces[i].stance;
      const RigidStance& stance = problem.stances[s];
      const Vector3 p_B = R_BW * (motion.X_WF[s].translation() - sample.p_WC);
      for (const WorkspaceSide& side : FootOf(problem, s).workspace_B)
        trouble[s] = std::max(trouble[s], side.normal.dot(p_B) - side.offset);
      const Vector3 f_F = stance.X_WF.linear().transpose() * sample.force_W[i] / (motion.mass_kg * kGravity);
      trouble[s] = std::max(trouble[s], 0.1 * (f_F.head<2>().norm() - stance.friction * f_F.z()));
    }
  }
  for (std::size_t s = 0; s < trouble.size(); ++s) {
    const RigidStance& stance = problem.stances[s];
    if (stance.held || stance.region_F.empty()) continue;
    const Vector3 moved = (stance.X_WF.inverse() * motion.X_WF[s]).translation();
    trouble[s] += std::max(0.0, -SignedDistance(stance.region_F, moved.head<2>()));
  }
  return trouble;
}

/// How far a stance's foot is in plan view from where it could stand on a patch.
double Far(const PlanOverPatches& plan, std::size_t s, int patch, const PatchRules& rules) {
  const Vector3 p_W = plan.plan.motion.X_WF[s].translation();
  RigidStance on = plan.choice.problem.stances[s];
  if (!rules.put(patch, p_W, on)) return std::numeric_limits<double>::infinity();
  return (on.X_WF.translation() - p_W).head<2>().norm();
}

/// A stance and those that last as long as it on the same patch.
std::vector<std::size_t> Together(const ChosenFootholds& choice, std::size_t s) {
  const std::vector<RigidStance>& stances = choice.problem.stances;
  std::vector<std::size_t> together;
  for (std::size_t other = 0; other < stances.size(); ++other) {
    if (!stances[other].held && choice.patches[other] == choice.patches[s] &&
        std::abs(stances[other].start_s - stances[s].start_s) < 1e-4 &&
        std::abs(stances[other].end_s - stances[s].end_s) < 1e-4)
      together.push_back(other);
  }
  return together;
}

/// The footholds of a plan with such a change, and a path fitted to them; nothing if a stance has no room there.
std::optional<ChosenFootholds> Changed(const PlanOverPatches& plan, const PatchChange& change,
                                       const PatchRules& rules) {
  ChosenFootholds choice = plan.choice;
  for (const std::size_t s : change.stances) {
    if (!rules.put(change.patch, plan.plan.motion.X_WF[s].translation(), choice.problem.stances[s]))
      return std::nullopt;
    choice.patches[s] = change.patch;
  }
  if (rules.fits_path) FitBodyTrajectory(choice.problem, choice.problem.path);
  return choice;
}

}  // namespace

PatchRules RulesOf(const Terrain& terrain, double edge_margin_m) {
  PatchRules rules;
  rules.put = [&terrain, edge_margin_m](int patch, const Vector3& p_W, RigidStance& stance) {
    return PutOnPatch(terrain, patch, p_W, edge_margin_m, stance);
  };
  return rules;
}

std::vector<PatchChange> PatchChanges(const Terrain& terrain, const PlanOverPatches& plan, const PatchRules& rules,
                                      double near_m) {
  constexpr double kNone = 1e-4;
  const ChosenFootholds& choice = plan.choice;
  const std::vector<double> trouble = TroubleOf(choice.problem, plan.plan.motion);
  std::vector<PatchChange> changes;
  for (std::size_t s = 0; s < trouble.size(); ++s) {
    if (choice.problem.stances[s].held || trouble[s] < kNone) continue;
    for (int patch = 0; patch < static_cast<int>(terrain.patches.size()); ++patch) {
      if (patch == choice.patches[s]) continue;
      const double far = Far(plan, s, patch, rules);
      if (far > near_m) continue;
      changes.push_back({far / trouble[s], {s}, patch});
      const std::vector<std::size_t> together = Together(choice, s);
      if (together.size() > 1 && together.front() == s) changes.push_back({0.99 * far / trouble[s], together, patch});
    }
  }
  std::sort(changes.begin(), changes.end(), [](const PatchChange& a, const PatchChange& b) { return a.rank < b.rank; });
  return changes;
}

OptionFields PatchSearchOptions::Fields() {
  return {{"near_m", &near_m, "m", 0.0, 10.0, "Largest distance from a foot at which another patch is tried for it."},
          {"better", &better, "1", 0.0, 1.0,
           "Share of the former sum of violations that a change of patches must stay below to be accepted."},
          {"screening_steps", &early_check_steps, "1", 1, 10000,
           "Iterations after which an infeasible solve that compares patches is stopped."},
          {"most_steps", &most_steps, "1", 1, 100000,
           "Total number of iterations after which no other patches are tried."}};
}

bool PatchChoices::Offer(const PlanOverPatches& attempt) {
  tried_.insert(attempt.choice.patches);
  if (best_ && attempt.plan.summary.violations >= search_.better * best_->plan.summary.violations) return false;
  best_ = attempt;
  changes_ = PatchChanges(terrain_, *best_, rules_, search_.near_m);
  next_ = 0;
  return true;
}

std::optional<ChosenFootholds> PatchChoices::Next() {
  while (best_ && next_ < changes_.size()) {
    std::optional<ChosenFootholds> changed = Changed(*best_, changes_[next_++], rules_);
    if (changed && tried_.insert(changed->patches).second) return changed;
  }
  return std::nullopt;
}

}  // namespace gaitwright
