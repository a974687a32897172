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

/// How well motors can make corrections while a plan is played.
enum class Room {
  kNoPlan,    ///< or not a sound one
  kNone,      ///< the optimisation needed the room that its limits leave (FinishReport::keeps_room)
  kAsSolved,  ///< the optimisation left it
  kAmple,     ///< efforts are far below their limits
};

/// The room that the optimisation of a whole body left; kAmple for plans that needed none.
Room RoomOf(const Result<PlannedWalk>& planned);

}  // namespace gaitwright
