// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// The options as requested, where "as-needed" means held; with `other` free footholds instead of held ones, or held
/// instead of free ones.
MotionOptions WithFootholds(MotionOptions options, bool other);

/// Whether both may be tried: footholds as-needed or free, on ground that is not flat.
bool MayMoveFeet(const MotionOptions& options, const Terrain& terrain);

/// The motion with its audit, or the reason why there is no motion. If the audit fails only because motion and forces
/// do not agree, FinishPlanned optimises the motion of the whole body; the result is used if it is sound.
/// @param only_sound  a motion that violates limits is returned without an audit, because it is not sound anyway.
Result<PlannedWalk> Audited(const RobotModel& model, Result<PlannedMotion> motion, const MotionOptions& options,
                            const AuditOptions& audit_options = {}, bool only_sound = false);

/// Whether a plan passes its audit and motors have room for the corrections of controllers: plans that need 92 % of a
/// torque, the limit at the knots of an optimisation, end with torques at their limits when they are played.
bool KeepsRoom(const PlannedWalk& planned);

}  // namespace gaitwright
