// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"
#include "planning/plan/terrain.h"

namespace gaitwright::fuzz {

/// What is true of every ground that was accepted: surfaces that face up, convex outlines, grids that are full, sizes
/// over zero, every number finite and of a sensible size. @throws BrokenLaw.
void CheckTerrainLaws(const Terrain& terrain);

/// Likewise of a gait: times over zero, phases and shares of contact in their ranges.
void CheckGaitLaws(const Gait& gait);

/// Likewise of a plan: finite numbers, rotations, sorted times, indices in range; and it is read back as it was.
void CheckPlanLaws(const MotionPlan& plan);

/// A plan of a few rows for a robot of four legs, with a part, ground and trajectories of every kind.
MotionPlan SmallPlan();

}  // namespace gaitwright::fuzz
