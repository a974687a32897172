// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "planning/audit/audit_report.h"
#include "planning/plan/motion_plan.h"
#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// What came of a walk.
struct WalkedQuadruped {
  MotionPlan plan;
  AuditReport audit;
  StabilityReport report;
  double speed_m_s = 0.0;  ///< as measured: the highest mean over a whole cycle of the gait
};

/// The whole way of a walk: 1 m ahead is planned, and the plan is audited, played in physics and scored.
/// @param gait  such as trot, pace or crawl, see docs/gaits.md.
/// @throws InvalidArgument with the reason, for a gait of another number of feet or a speed that the robot cannot
/// reach.
WalkedQuadruped WalkQuadruped(const std::string& robot, const std::string& gait, double speed_m_s);

}  // namespace gaitwright::examples
