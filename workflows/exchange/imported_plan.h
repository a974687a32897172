// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "planning/plan/motion_plan.h"
#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// What was worked out on the way to a plan, and what is odd about it.
struct ImportNotes {
  std::vector<DerivedPart> derived;
  std::vector<std::string> warnings;
};

/// The plan of a motion on its grid: contacts, footholds and swings from the feet, the centre of mass and the ZMP from
/// the model, forces and torques as given or by inverse dynamics. Provenance is left to the caller.
/// @param goal  where the base was to end, from where it starts; nothing for where it ends.
/// @throws InvalidArgument for feet that are far from the ground in most rows, or never stand, and for
/// accelerations or torques that no robot has.
MotionPlan PlanOfMotion(const RobotModel& model, const Terrain& terrain, EvenMotion motion,
                        const ImportOptions& options, const std::optional<PlanarPose>& goal, ImportNotes& notes);

}  // namespace gaitwright
