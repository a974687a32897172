// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/plan_over_terrain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/stability/polygon.h"
#include "optimisation/centroidal/body_trajectory.h"

namespace gaitwright {
namespace {

/// Violation of each stance: distances out of region and out of reach [m], and force beyond friction [0.1 m g].
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

/// Distance in plan view of a stance's foot from the nearest possible foothold on a patch.
double Far(const Terrain& terrain, const PlanOverPatches& plan, std::size_t s, int patch, double edge_margin_m) {
  const Vector3 p_W = plan.plan.motion.X_WF[s].translation();
  RigidStance on = plan.choice.problem.stances[s];
  if (!PutOnPatch(terrain, patch, p_W, edge_margin_m, on)) return std::numeric_limits<double>::infinity();
  return (on.X_WF.translation() - p_W).head<2>().norm();
}

/// A stance and the stances of the same time on the same patch.
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

class PatchSearch {
 public:
  PatchSearch(const Terrain& terrain, const ChooseFootholdsOptions& choosing, const RigidBodyOptions& planning,
              const PatchSearchOptions& search)
      : terrain_(terrain), choosing_(choosing), planning_(planning), search_(search) {}

  Result<PlanOverPatches> Run(const RigidBodyProblem& problem) {
    const Result<ChosenFootholds> choice = ChooseFootholds(terrain_, problem, choosing_);
    if (!choice) return choice.failure();
    best_.choice = *choice;
    Result<RigidBodyPlan> plan = Try(best_);
    planning_.screening = search_.screening_steps;
    while (!plan && steps_ < search_.most_steps) {
      if (!TryOthers(plan)) break;
    }
    best_.choices = choices_;
    best_.plan.summary.iterations = steps_;
    if (!plan) {
      Failure failure = plan.failure();
      if (choices_ > 1) failure.message += fmt::format("; this is the best of {} choices of patches", choices_);
      return failure;
    }
    return best_;
  }

  const PlanOverPatches& best() const { return best_; }

 private:
  Result<RigidBodyPlan> Try(PlanOverPatches& tried) {
    ++choices_;
    Result<RigidBodyPlan> plan = PlanRigidBody(tried.choice.problem, planning_, &tried.plan);
    steps_ += tried.plan.summary.iterations;
    return plan;
  }

  /// Plans other patches until a choice is better, which then becomes the best one. @return false if none is better.
  bool TryOthers(Result<RigidBodyPlan>& plan) {
    for (const PatchChange& change : PatchChanges(terrain_, best_, choosing_.edge_margin_m, search_.near_m)) {
      if (steps_ >= search_.most_steps) return false;
      PlanOverPatches other = best_;
      other.choice = Changed(terrain_, best_, change, choosing_.edge_margin_m);
      Result<RigidBodyPlan> planned = Try(other);
      if (!planned && other.plan.summary.violations >= search_.better * best_.plan.summary.violations) continue;
      best_ = std::move(other);
      plan = std::move(planned);
      return true;
    }
    return false;
  }

  const Terrain& terrain_;
  const ChooseFootholdsOptions& choosing_;
  RigidBodyOptions planning_;
  const PatchSearchOptions& search_;
  PlanOverPatches best_;
  int steps_ = 0, choices_ = 0;
};

}  // namespace

std::vector<PatchChange> PatchChanges(const Terrain& terrain, const PlanOverPatches& plan, double edge_margin_m,
                                      double near_m) {
  constexpr double kNone = 1e-4;
  const ChosenFootholds& choice = plan.choice;
  const std::vector<double> trouble = TroubleOf(choice.problem, plan.plan.motion);
  std::vector<PatchChange> changes;
  for (std::size_t s = 0; s < trouble.size(); ++s) {
    if (choice.problem.stances[s].held || trouble[s] < kNone) continue;
    for (int patch = 0; patch < static_cast<int>(terrain.patches.size()); ++patch) {
      if (patch == choice.patches[s]) continue;
      const double far = Far(terrain, plan, s, patch, edge_margin_m);
      if (far > near_m) continue;
      changes.push_back({far / trouble[s], {s}, patch});
      const std::vector<std::size_t> together = Together(choice, s);
      if (together.size() > 1 && together.front() == s) changes.push_back({0.99 * far / trouble[s], together, patch});
    }
  }
  std::sort(changes.begin(), changes.end(), [](const PatchChange& a, const PatchChange& b) { return a.rank < b.rank; });
  return changes;
}

ChosenFootholds Changed(const Terrain& terrain, const PlanOverPatches& plan, const PatchChange& change,
                        double edge_margin_m) {
  ChosenFootholds choice = plan.choice;
  for (const std::size_t s : change.stances) {
    PutOnPatch(terrain, change.patch, plan.plan.motion.X_WF[s].translation(), edge_margin_m, choice.problem.stances[s]);
    choice.patches[s] = change.patch;
  }
  FitBodyTrajectory(choice.problem, choice.problem.way);
  return choice;
}

OptionFields PatchSearchOptions::Fields() {
  return {{"near_m", &near_m, "m", 0.0, 10.0, "Largest distance from a foot at which another patch is tried for it."},
          {"better", &better, "1", 0.0, 1.0,
           "A change of patches is accepted if the sum of violations falls below this share of the former sum."},
          {"screening_steps", &screening_steps, "1", 1, 10000,
           "Number of iterations after which a solve that compares patches is stopped if it is still infeasible."},
          {"most_steps", &most_steps, "1", 1, 100000,
           "Total number of iterations after which no other patches are tried."}};
}

Result<PlanOverPatches> PlanOverTerrain(const Terrain& terrain, const RigidBodyProblem& problem,
                                        const ChooseFootholdsOptions& choosing, const RigidBodyOptions& planning,
                                        const PatchSearchOptions& search, PlanOverPatches* last) {
  ChooseFootholdsOptions choosing_checked = choosing;
  RigidBodyOptions planning_checked = planning;
  PatchSearchOptions search_checked = search;
  CheckOptions(Joined({choosing_checked.Fields(), planning_checked.Fields(), search_checked.Fields()}));
  PatchSearch patches(terrain, choosing, planning, search);
  Result<PlanOverPatches> plan = patches.Run(problem);
  if (last != nullptr) *last = patches.best();
  return plan;
}

}  // namespace gaitwright
