// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "optimisation/search/plan_walk.h"
#include "planning/gait/load_gaits.h"

namespace gaitwright {

/// What a few cheap passes tell of a walk that is planned as the motion of a rigid body.
struct FirstLook {
  std::optional<Failure> refusal;  ///< nothing where there may be a plan
  double ease = 0.7;               ///< share of the pace at which it may be otherwise, by how far limits are passed
  bool solved = false;             ///< whether anything had to be solved to know
  bool planned = false;            ///< there is a motion; its audit refuses it where anything does
};

/// Looks at a walk by few passes of the interior-point method alone: what stays unmet or far past limits there was so
/// in all full plans that were compared, which take some ten times as long. On level ground the start of a long walk is
/// looked at (StartOfWalk). Limits that it passes by far are passed at that pace however long the walk is; where
/// another law stays unmet, which more time to gain speed may mend, all of it is looked at with `whole`; without it,
/// for a pace to name, nothing may be past a limit. The work is bounded by passes, three for each, so that the answer
/// is always the same.
FirstLook LookAt(const RobotModel& model, const Terrain& terrain, const WalkRequest& request, const Gait& gait,
                 const WalkCommand& command, bool whole);

/// The share of a pace at which a plan may keep its limits, from those it breaks: speeds of joints go with the pace,
/// their torques with its square, which is that of accelerations.
double EaseOf(const AuditReport& audit);

}  // namespace gaitwright
