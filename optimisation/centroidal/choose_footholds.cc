// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/choose_footholds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/polygon.h"
#include "optimisation/centroidal/body_trajectory.h"
#include "optimisation/centroidal/hold_goal.h"

namespace gaitwright {
namespace {

/// Half size to which an infinite patch is cut [m].
constexpr double kFar = 100.0;

Polygon OutlineOf(const TerrainPatch& patch) {
  if (!patch.outline_T.empty()) return patch.outline_T;
  return {{-kFar, -kFar}, {kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}};
}

/// The part of a patch, around the place nearest to p, that no other patch covers. For each covering patch, the part
/// beyond one side is kept: the side from which the place is farthest outside.
Polygon FreePart(const Terrain& terrain, std::size_t patch, const Vector3& p_W, double margin_m) {
  const TerrainPatch& own = terrain.patches[patch];
  Polygon part = Shrunk(OutlineOf(own), margin_m);
  for (std::size_t other = 0; other < terrain.patches.size() && part.size() >= 3; ++other) {
    const TerrainPatch& above = terrain.patches[other];
    if (other == patch || above.outline_T.empty()) continue;
    const Pose X_own = own.X_WT.inverse() * above.X_WT;
    Polygon outline;
    double height = 0.0;
    for (const Vector2& corner : above.outline_T) {
      const Vector3 q = X_own * Vector3(corner.x(), corner.y(), 0.0);
      outline.emplace_back(q.head<2>());
      height += q.z() / static_cast<double>(above.outline_T.size());
    }
    if (height <= 1e-6) continue;
    const Vector2 at = NearestPoint(part, (own.X_WT.inverse() * p_W).head<2>());
    double farthest = -std::numeric_limits<double>::infinity();
    Vector2 normal = Vector2::UnitX();
    double least = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector2 along = outline[(i + 1) % outline.size()] - outline[i];
      const Vector2 outward = Vector2(along.y(), -along.x()).normalized();
      if (const double out = outward.dot(at - outline[i]); out > farthest) {
        farthest = out;
        normal = outward;
        least = outward.dot(outline[i]) + margin_m;
      }
    }
    part = Clipped(part, normal, least);
  }
  return part;
}

class Chooser {
 public:
  Chooser(const Terrain& terrain, const RigidBodyProblem& problem, const ChooseFootholdsOptions& options)
      : terrain_(terrain), options_(options), patches_(problem.stances.size(), -1) {
    result_.problem = problem;
  }

  Result<ChosenFootholds> Run() {
    if (const std::optional<Failure> failure = GoalNotHeld()) return *failure;
    trajectory_ = StraightPath(terrain_, result_.problem, options_.spacing_s);
    // Paths and patches are fitted to each other in turn until the patches no longer change.
    constexpr int kRounds = 5;
    for (int round = 0; round < kRounds; ++round) {
      if (!TakeBestPatches()) break;
      Fit();
    }
    for (std::size_t s = 0; s < stances().size(); ++s) {
      if (!stances()[s].held && patches_[s] < 0) return NoRoom(stances()[s]);
    }
    HoldAtGoal();
    TryOthers();
    const BodyTrajectoryMisfit misfit = OutOfReach(result_.problem, trajectory_);
    if (misfit.largest_m > options_.infeasible_m) return Infeasible(misfit);
    result_.misfit_m = misfit.largest_m;
    result_.problem.path = trajectory_;
    result_.patches = patches_;
    return result_;
  }

 private:
  std::vector<RigidStance>& stances() { return result_.problem.stances; }

  Failure Infeasible(const BodyTrajectoryMisfit& misfit) const {
    const RigidStance& stance = result_.problem.stances[static_cast<std::size_t>(misfit.stance)];
    Vector3 first = trajectory_.p_WC.back(), last = trajectory_.p_WC.back();
    for (std::size_t k = trajectory_.time_s.size(); k-- > 0;) {
      if (trajectory_.time_s[k] >= stance.start_s) first = trajectory_.p_WC[k];
      if (trajectory_.time_s[k] >= stance.end_s) last = trajectory_.p_WC[k];
    }
    return {
        FailureKind::kInfeasible,
        FailureCode::kOutOfReach,
        "ChooseFootholds",
        fmt::format("foot {} is on the ground from {:.2f} to {:.2f} s while the body moves {:.2f} m; on the best path "
                    "found, it is {:.3f} m outside its workspace at {:.2f} s",
                    stance.foot, stance.start_s, stance.end_s, (last - first).norm(), misfit.largest_m, misfit.at_s),
        {"allow more time, a shorter path or shorter stances"}};
  }

  /// Failure if all patches are covered by others.
  static Failure NoRoom(const RigidStance& stance) {
    return {
        FailureKind::kInfeasible,
        FailureCode::kNoPatches,
        "ChooseFootholds",
        fmt::format("no patch has room for foot {} from {:.2f} to {:.2f} s", stance.foot, stance.start_s, stance.end_s),
        {"give the ground larger patches, or lower edge_margin_m"}};
  }

  /// At the end, each standing foot must reach ground from the body's goal, and that ground must hold the body.
  std::optional<Failure> GoalNotHeld() const {
    const GoalGround ground = LookAtGoal(terrain_, result_.problem, options_.edge_margin_m, options_.misfit_m);
    if (ground.foot >= 0) {
      return Failure{FailureKind::kInfeasible,
                     FailureCode::kGoalOutOfReach,
                     "ChooseFootholds",
                     fmt::format("at the goal, foot {} is {:.3f} m outside its workspace on every patch", ground.foot,
                                 ground.out_of_reach_m),
                     {"choose another height or tilt of the body at the goal"}};
    }
    if (ground.needed_friction <= ground.friction) return std::nullopt;
    return Failure{FailureKind::kInfeasible,
                   FailureCode::kGoalNotHeld,
                   "ChooseFootholds",
                   fmt::format("no contact forces can hold the body at rest at the goal: the ground within reach is "
                               "too steep for a friction of {:.2f}; {:.2f} is needed",
                               ground.friction, ground.needed_friction),
                   {"choose a goal on less steep ground, or more friction"}};
  }

  /// Whether friction holds a body at rest on the patches of the final stances.
  bool IsHeld() const {
    std::vector<Vector3> normals;
    double friction = 0.0;
    for (const RigidStance& stance : result_.problem.stances) {
      if (stance.end_s < result_.problem.duration_s) continue;
      normals.emplace_back(stance.X_WF.linear().col(2));
      friction = std::max(friction, stance.friction);
    }
    return LeastHoldingFriction(normals) <= friction;
  }

  /// If the final patches cannot hold a body at rest, moves the foot whose other patch has the lowest cost.
  void HoldAtGoal() {
    const RigidBodyState& goal = result_.problem.goal;
    if (!goal.v_WC.isZero() || !goal.w_WB_B.isZero() || IsHeld()) return;
    double least = std::numeric_limits<double>::infinity();
    std::pair<std::size_t, int> best{0, -1};
    for (std::size_t s = 0; s < stances().size(); ++s) {
      if (stances()[s].held || stances()[s].end_s < result_.problem.duration_s) continue;
      const RigidStance before = stances()[s];
      const int patch_before = patches_[s];
      for (int patch = 0; patch < static_cast<int>(terrain_.patches.size()); ++patch) {
        if (!Put(s, patch, WantedFoothold(result_.problem, trajectory_, s)) || !IsHeld()) continue;
        const double misfit = StanceMisfit(result_.problem, trajectory_, s);
        if (misfit >= least) continue;
        least = misfit;
        best = {s, patch};
      }
      stances()[s] = before;
      patches_[s] = patch_before;
    }
    if (best.second < 0) return;
    Put(best.first, best.second, WantedFoothold(result_.problem, trajectory_, best.first));
    Fit();
  }

  void Fit() {
    FitBodyTrajectory(result_.problem, trajectory_);
    ++result_.trials;
  }

  /// Calls PutOnPatch and stores the patch.
  bool Put(std::size_t s, int patch, const Vector3& p_W) {
    if (!PutOnPatch(terrain_, patch, p_W, options_.edge_margin_m, stances()[s])) return false;
    patches_[s] = patch;
    return true;
  }

  /// The patches by their cost for a stance on the present path, best first.
  std::vector<int> Ranked(std::size_t s) {
    const RigidStance before = stances()[s];
    const int patch_before = patches_[s];
    std::vector<std::pair<double, int>> ranked;
    for (int patch = 0; patch < static_cast<int>(terrain_.patches.size()); ++patch) {
      if (Put(s, patch, WantedFoothold(result_.problem, trajectory_, s)))
        ranked.emplace_back(StanceMisfit(result_.problem, trajectory_, s), patch);
    }
    stances()[s] = before;
    patches_[s] = patch_before;
    std::sort(ranked.begin(), ranked.end());
    std::vector<int> patches;
    for (const auto& [misfit, patch] : ranked) patches.push_back(patch);
    return patches;
  }

  /// @return true if any stance has changed its patch.
  bool TakeBestPatches() {
    bool changed = false;
    for (std::size_t s = 0; s < stances().size(); ++s) {
      if (stances()[s].held) continue;
      const std::vector<int> ranked = Ranked(s);
      if (ranked.empty() || ranked.front() == patches_[s]) continue;
      Put(s, ranked.front(), WantedFoothold(result_.problem, trajectory_, s));
      changed = true;
    }
    return changed;
  }

  /// The free stances that are out of reach, the farthest first.
  std::vector<std::size_t> Troubled() {
    std::vector<double> trouble(stances().size(), 0.0);
    for (std::size_t s = 0; s < stances().size(); ++s)
      trouble[s] = OutOfReach(result_.problem, trajectory_, s).largest_m;
    std::vector<std::size_t> order;
    for (std::size_t s = 0; s < stances().size(); ++s) {
      if (!stances()[s].held) order.push_back(s);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return trouble[a] > trouble[b]; });
    return order;
  }

  /// Moves one stance at a time to another patch if that reduces the distances out of reach, until nothing improves.
  void TryOthers() {
    bool better = true;
    while (better && result_.trials < options_.max_trials &&
           OutOfReach(result_.problem, trajectory_).largest_m > options_.misfit_m) {
      better = false;
      for (const std::size_t s : Troubled()) {
        const std::vector<int> ranked = Ranked(s);
        for (std::size_t i = 0; i < std::min<std::size_t>(3, ranked.size()) && !better; ++i) {
          if (ranked[i] != patches_[s] && result_.trials < options_.max_trials) better = Improves(s, ranked[i]);
        }
        if (better || result_.trials >= options_.max_trials) break;
      }
    }
  }

  bool Improves(std::size_t s, int patch) {
    const double before = OutOfReach(result_.problem, trajectory_).sum;
    const BodyTrajectory kept_trajectory = trajectory_;
    const std::vector<RigidStance> kept = stances();
    const std::vector<int> patches = patches_;
    Put(s, patch, WantedFoothold(result_.problem, trajectory_, s));
    Fit();
    if (OutOfReach(result_.problem, trajectory_).sum < 0.95 * before) return true;
    trajectory_ = kept_trajectory;
    stances() = kept;
    patches_ = patches;
    return false;
  }

  const Terrain& terrain_;
  const ChooseFootholdsOptions& options_;
  ChosenFootholds result_;
  std::vector<int> patches_;  // by stance
  BodyTrajectory trajectory_;
};

}  // namespace

bool PutOnPatch(const Terrain& terrain, int patch, const Vector3& p_W, double edge_margin_m, RigidStance& stance) {
  const TerrainPatch& on = terrain.patches[static_cast<std::size_t>(patch)];
  const Polygon part = FreePart(terrain, static_cast<std::size_t>(patch), p_W, edge_margin_m);
  if (part.size() < 3) return false;
  const Vector2 at = NearestPoint(part, (on.X_WT.inverse() * p_W).head<2>());
  stance.X_WF = on.X_WT * Eigen::Translation3d(at.x(), at.y(), 0.0);
  stance.friction = on.friction;
  stance.region_F.clear();
  for (const Vector2& corner : part) stance.region_F.emplace_back(corner - at);
  return true;
}

OptionFields ChooseFootholdsOptions::Fields() {
  return {{"edge_margin_m", &edge_margin_m, "m", 0.0, 1.0, "Smallest distance of a foothold to an edge of its patch."},
          {"spacing_s", &spacing_s, "s", 0.01, 1.0,
           "Distance between the positions of the body at which reach is checked."},
          {"misfit_m", &misfit_m, "m", 0.0, 1.0,
           "Distance of a foothold outside its foot's workspace above which other patches are tried for it."},
          {"infeasible_m", &infeasible_m, "m", 0.0, 10.0,
           "Distance of a foothold outside its foot's workspace above which the problem is refused as infeasible."},
          {"max_trials", &max_trials, "1", 1, 1000, "Maximum number of paths of the body that are fitted."}};
}

Result<ChosenFootholds> ChooseFootholds(const Terrain& terrain, const RigidBodyProblem& problem,
                                        const ChooseFootholdsOptions& options) {
  CheckRigidBodyProblem(problem);
  ChooseFootholdsOptions checked = options;
  CheckOptions(checked.Fields());
  const double margin = options.edge_margin_m;
  if (std::none_of(terrain.patches.begin(), terrain.patches.end(),
                   [&](const TerrainPatch& patch) { return Shrunk(OutlineOf(patch), margin).size() >= 3; })) {
    return Failure{
        FailureKind::kInfeasible,
        FailureCode::kNoPatches,
        "ChooseFootholds",
        fmt::format("ground '{}' has no patch with space for a foot {:.3f} m from its edges", terrain.name, margin),
        {"add patches to the ground, or lower edge_margin_m"}};
  }
  return Chooser(terrain, problem, options).Run();
}

}  // namespace gaitwright
