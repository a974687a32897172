// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "optimisation/centroidal/plan_over_terrain.h"
#include "planning/audit/audit_report.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A motion with the result of its audit.
struct AuditedMotion {
  ChosenFootholds choice;  ///< including swings that were planned together with the body
  RigidBodyPlan plan;
  AuditReport first = {};    ///< audit of the given motion
  AuditReport report = {};   ///< audit of this motion
  std::string refusal = {};  ///< why no further repair was possible although the audit fails; empty if it passes
  int swings_planned = 0;    ///< rounds in which swings were planned together with the body
  int halvings = 0;          ///< rounds in which the node spacing was halved
  int changes = 0;           ///< rounds in which stances were moved to other patches
};

/// RefineMotion by the audit of the motion as the plan of a robot (rigid_body_plan.h), in at most `most_rounds` rounds;
/// 0 only audits. Failures as of RigidBodyMotionPlan.
Result<AuditedMotion> RefineByAudit(const Terrain& ground, const PlanOverPatches& plan, RigidBodyOptions options,
                                    int most_rounds);

}  // namespace gaitwright
