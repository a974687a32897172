// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/audit/audit_report.h"
#include "planning/plan/motion_plan.h"
#include "playback/score/stability_report.h"
#include "workflows/exchange/placed_steps.h"

namespace gaitwright::examples {

/// Result of a walk over given footsteps.
struct WalkedSteps {
  MotionPlan plan;
  AuditReport audit;
  StabilityReport report;
  double miss_m = 0.0;  ///< largest distance of a step from the nearest measured touch-down of its foot
};

/// Plans the rest of the motion over footsteps on level ground, and audits, plays and scores it.
/// @throws InvalidArgument if the robot cannot take these steps.
WalkedSteps WalkSteps(const RobotModel& model, const std::vector<PlacedStep>& steps);

}  // namespace gaitwright::examples
