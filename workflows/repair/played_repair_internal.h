// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "workflows/repair/repair_report_internal.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// A repaired motion with the playback of its plan.
struct PlayedRepair {
  RepairedMotion repaired;
  std::optional<PlayedWalk> played = {};  ///< without samples in its logs; empty if it was not asked for

  RepairResult ResultOf(const RobotModel& model) const {
    return {model, repaired.findings, &repaired, played ? &*played : nullptr};
  }
};

/// Repairs a motion and plays its plan in all engines (ProvingEngine), which also decide what has to be slowed.
/// @param plays  false: the audit alone decides.
Result<PlayedRepair> RepairAndPlay(const RobotModel& model, const RepairRequest& request, bool plays);

}  // namespace gaitwright
