// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "optimisation/search/plan_walk.h"
#include "planning/gait/load_gaits.h"

namespace gaitwright {

/// Result of a few cheap passes for a walk that is planned as the motion of a rigid body.
struct FirstLook {
  std::optional<Failure> refusal;  ///< nothing if a plan may exist
  double ease = 0.7;     ///< factor of the speed at which a plan may exist, estimated from the limit violations
  bool solved = false;   ///< whether an optimisation problem was solved
  bool planned = false;  ///< there is a motion; a refusal comes from its audit
};

/// Evaluates a walk by a few passes of the interior-point method. Constraints and limits that are clearly violated
/// there were also violated in all full plans that were compared, which take about ten times as long. On level ground,
/// the start of a long walk is evaluated (StartOfWalk): clearly violated limits do not depend on the length of the
/// walk. If another constraint is violated, more time to accelerate may help, so with `whole` the complete walk is
/// evaluated. Without `whole` (to find a speed for a message), no limit may be violated. The work is limited to two
/// passes for each, so the result is deterministic.
FirstLook LookAt(const RobotModel& model, const Terrain& terrain, const WalkRequest& request, const Gait& gait,
                 const WalkCommand& command, bool whole);

/// Factor of the speed at which a plan may keep its limits, estimated from the violated ones: joint speeds are
/// proportional to the speed, torques and accelerations to its square.
double EaseOf(const AuditReport& audit);

}  // namespace gaitwright
