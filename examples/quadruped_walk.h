// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "planning/audit/audit_report.h"
#include "planning/plan/motion_plan.h"
#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// Result of a walk.
struct WalkedQuadruped {
  MotionPlan plan;
  AuditReport audit;
  StabilityReport report;
  double speed_m_s = 0.0;  ///< measured: highest mean over one cycle of the gait
};

/// Plans a walk of 1 m forward, and audits, plays and scores the plan.
/// @param gait  name of the gait, such as trot, pace or crawl; see docs/gaits.md.
/// @throws InvalidArgument if the gait is for another number of feet, or if the robot cannot reach the speed.
WalkedQuadruped WalkQuadruped(const std::string& robot, const std::string& gait, double speed_m_s);

}  // namespace gaitwright::examples
