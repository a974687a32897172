// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/audit/audit_report.h"
#include "planning/plan/motion_plan.h"
#include "playback/score/stability_report.h"
#include "workflows/exchange/placed_steps.h"

namespace gaitwright::examples {

/// What came of one's own footsteps.
struct WalkedSteps {
  MotionPlan plan;
  AuditReport audit;
  StabilityReport report;
  double miss_m = 0.0;  ///< from a step to the nearest touch-down of its foot as measured, the largest
};

/// Plans the motion of all the rest over footsteps on level ground, and audits, plays and scores it.
/// @throws InvalidArgument with the reason, for steps that cannot be taken.
WalkedSteps WalkSteps(const RobotModel& model, const std::vector<PlacedStep>& steps);

}  // namespace gaitwright::examples
