// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "optimisation/centroidal/choose_footholds.h"
#include "optimisation/centroidal/plan_rigid_body.h"

namespace gaitwright {

/// A motion with its footholds.
struct PlanOverPatches {
  ChosenFootholds choice;
  RigidBodyPlan plan;
  int choices = 0;  ///< number of patch choices that were planned
};

/// Tuning
///   a motion is refused although other footholds allow one   raise most_steps, near_m
///   too long is spent on what has no motion                  lower most_steps
struct PatchSearchOptions {
  double near_m = 0.6;
  double better = 0.95;
  int early_check_steps = 30;  ///< option `screening_steps`
  int most_steps = 150;

  OptionFields Fields();
};

/// How stances may change between the patches of a ground.
struct PatchRules {
  /// Puts a stance on a patch, as near as possible to a position in W. @return false if it cannot stand there.
  std::function<bool(int patch, const Vector3& p_W, RigidStance& stance)> put;
  bool fits_path = true;  ///< the problem's path is fitted to the footholds; else it stays as it is
};

/// Massless legs: stances anywhere on patches, `edge_margin_m` from their edges (PutOnPatch).
PatchRules RulesOf(const Terrain& terrain, double edge_margin_m);

/// Stances that change to another patch together.
struct PatchChange {
  double rank = 0.0;  ///< distance of the patch divided by the violation
  std::vector<std::size_t> stances = {};
  int patch = 0;
};

/// For a plan with violated constraints: changes of violated stances (region, reach or friction) to other patches
/// within near_m, alone or together with stances of the same time; the lowest rank first.
std::vector<PatchChange> PatchChanges(const Terrain& terrain, const PlanOverPatches& plan, const PatchRules& rules,
                                      double near_m);

/// The choices of patches that are tried for a motion with violated constraints. Each starts from the best attempt so
/// far, and none is given twice.
class PatchChoices {
 public:
  /// @param terrain  outlives this.
  PatchChoices(const Terrain& terrain, PatchRules rules, const PatchSearchOptions& search)
      : terrain_(terrain), rules_(std::move(rules)), search_(search) {}

  /// Takes an attempt as the best one if it is the first, or if its violations are less than search.better of the best
  /// one's. @return whether it was taken.
  bool Offer(const PlanOverPatches& attempt);

  /// The next change of the best attempt; nothing if there is no other patch near the violated stances.
  std::optional<ChosenFootholds> Next();

  bool has_best() const { return best_.has_value(); }

 private:
  const Terrain& terrain_;
  const PatchRules rules_;
  const PatchSearchOptions search_;
  std::optional<PlanOverPatches> best_;
  std::vector<PatchChange> changes_;  // of the best attempt
  std::size_t next_ = 0;              // of these
  std::set<std::vector<int>> tried_;  // patches, by stance
};

}  // namespace gaitwright
