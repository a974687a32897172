// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/centroidal/plan_over_terrain.h"

namespace gaitwright {

/// What a check of the whole robot finds in a rigid body's motion.
struct MotionVerdict {
  bool passes = false;
  double stray_m = 0.0;                 ///< largest distance of a swing foot out of its reach, or into a solid [m]
  std::vector<RigidSwing> swings = {};  ///< its swings as unknowns (FreeSwingsOf)
};

/// Checks a motion that satisfies the constraints of its problem.
using MotionJudge = std::function<Result<MotionVerdict>(const PlanOverPatches& motion)>;

/// How a motion may be planned again.
struct RefineRules {
  PatchRules patches;
  PatchSearchOptions search = {};
  int most_rounds = 40;   ///< 0 only checks
  int most_halvings = 2;  ///< of the node spacing
  int most_changes = 12;  ///< of patches
};

/// A motion after refinement.
struct RefinedMotion {
  PlanOverPatches motion;    ///< the last one that satisfies its constraints; with swings planned together with it
  bool passes = false;       ///< its check
  std::string refusal = {};  ///< why no further refinement was possible although the check fails; empty if it passes
  int swings_planned = 0;    ///< rounds in which swings were planned together with the body
  int halvings = 0;          ///< rounds in which the node spacing was halved
  int changes = 0;           ///< rounds in which stances were moved to other patches
};

/// Checks a motion and plans it again until it passes: with half the node spacing; if swing feet leave their
/// workspaces, with swings planned together with the body, within reach and separated from solids by planes
/// (RigidSwing, free_swings.h); if no such motion is found, with other patches for the violated stances
/// (PatchChoices). Failures as of `judge`.
Result<RefinedMotion> RefineMotion(const Terrain& ground, const PlanOverPatches& motion, RigidBodyOptions options,
                                   const RefineRules& rules, const MotionJudge& judge);

}  // namespace gaitwright
