// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "optimisation/centroidal/plan_rigid_body.h"
#include "planning/audit/audit_report.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A motion with what its audit says.
struct AuditedMotion {
  RigidBodyProblem problem;  ///< with the swings that had to be held within reach
  RigidBodyPlan plan;
  AuditReport first;    ///< of the motion that was given
  AuditReport report;   ///< of this one
  std::string refusal;  ///< why nothing was left to be done though the audit fails; empty where it passes
  int swings_held = 0;  ///< rounds in which swings were held within reach
  int halvings = 0;     ///< rounds in which breaks were put half as far apart
};

/// Has a motion audited as the plan of a robot (rigid_body_plan.h), and plans it anew until it passes: where feet in
/// the air go out of their workspaces, with these swings, over the ground as far within reach as they come, held within
/// reach (RigidSwing); else with breaks half as far apart. Up to `most_rounds` times; 0 to have it audited
/// only. Failures as those of RigidBodyMotionPlan.
Result<AuditedMotion> RefineByAudit(const Terrain& ground, const RigidBodyProblem& problem, RigidBodyOptions options,
                                    const RigidBodyPlan& plan, int most_rounds);

}  // namespace gaitwright
