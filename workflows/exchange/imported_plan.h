// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "planning/plan/motion_plan.h"
#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// Notes on derived data and on oddities of an imported motion.
struct ImportNotes {
  std::vector<DerivedPart> derived;
  std::vector<std::string> warnings;
};

/// The plan of a motion on its grid: contacts, footholds and swings from the feet, the centre of mass and the ZMP from
/// the model, forces and torques from the file or by inverse dynamics. The caller sets the provenance.
/// @param goal  intended end of the base, relative to its start; empty: its actual end.
/// @throws InvalidArgument for feet that are far from the ground in most rows or never in stance, and for implausible
/// accelerations or torques.
MotionPlan PlanOfMotion(const RobotModel& model, const Terrain& terrain, EvenMotion motion,
                        const ImportOptions& options, const std::optional<PlanarPose>& goal, ImportNotes& notes);

}  // namespace gaitwright
