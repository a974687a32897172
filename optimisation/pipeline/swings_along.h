// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "optimisation/pipeline/motion_passes.h"
#include "optimisation/pipeline/refine_motion.h"

namespace gaitwright {

/// Checks the swings of a walk's rigid body: whether feet touch solids or leave the reach of their legs. The verdict
/// has those swings, and all that are in the air with them, as unknowns.
/// @param former  the rolling of feet in the air; its `roll` may be empty.
MotionVerdict CheckSwings(const MotionTask& task, const PlanOverPatches& motion, const FormerMotion& former);

/// Whether a foot touches a solid in the air.
bool SwingsTouch(const MotionTask& task, const PlanOverPatches& motion, const FormerMotion& former);

/// Plans a motion again together with the swings that touch solids or leave their reach (RefineMotion with
/// CheckSwings). @return the motion over the problem with the swings found, which are given then; nothing if all swings
/// were in order, or if none were found that are.
std::optional<PlanOverPatches> WithSwingsAlong(const MotionTask& task, const PlanOverPatches& motion,
                                               const RigidBodyOptions& options, const FormerMotion& former);

}  // namespace gaitwright
