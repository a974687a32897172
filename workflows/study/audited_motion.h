// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "optimisation/centroidal/plan_over_terrain.h"
#include "planning/audit/audit_report.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A motion with what its audit says.
struct AuditedMotion {
  ChosenFootholds choice;  ///< with the swings that had to be planned along
  RigidBodyPlan plan;
  AuditReport first = {};    ///< of the motion that was given
  AuditReport report = {};   ///< of this one
  std::string refusal = {};  ///< why nothing was left to be done though the audit fails; empty where it passes
  int swings_planned = 0;    ///< rounds in which swings were planned along
  int halvings = 0;          ///< rounds in which breaks were put half as far apart
  int changes = 0;           ///< rounds in which stances took other patches
};

/// Has a motion audited as the plan of a robot (rigid_body_plan.h), and plans it anew until it passes: with breaks half
/// as far apart; where feet in the air go out of their workspaces, with swings that are planned along with it, within
/// reach and beyond planes between them and what is solid (RigidSwing, swing_planes.h); where no such motion is found,
/// with other patches for stances that are in trouble. Up to `most_rounds` times; 0 to have it audited only. Failures
/// as those of RigidBodyMotionPlan.
Result<AuditedMotion> RefineByAudit(const Terrain& ground, const PlanOverPatches& plan, RigidBodyOptions options,
                                    int most_rounds);

}  // namespace gaitwright
