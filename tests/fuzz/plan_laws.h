// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"
#include "planning/plan/terrain.h"

namespace gaitwright::fuzz {

/// Laws of every accepted ground: surfaces face up, outlines are convex, grids are complete, sizes are positive, every
/// number is finite and plausible. @throws BrokenLaw.
void CheckTerrainLaws(const Terrain& terrain);

/// Laws of every accepted gait: positive times, phases and duty factors in their ranges.
void CheckGaitLaws(const Gait& gait);

/// Laws of every accepted plan: finite numbers, rotations, sorted times, indices in range; reading it back gives the
/// same.
void CheckPlanLaws(const MotionPlan& plan);

/// A plan of a few rows for a four-legged robot, with a part, ground and trajectories of every kind.
MotionPlan SmallPlan();

}  // namespace gaitwright::fuzz
