// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/repair_motion_internal.h"

namespace gaitwright::synthetic {

/// Findings on a motion of 4 s that fails two checks.
inline MotionFindings BadFindings() {
  MotionFindings findings;
  findings.format = MotionFormat::kFramesCsv;
  findings.rows = 400;
  findings.duration_s = 4.0;
  findings.rested.motion.step_s = 0.01;
  findings.rested.file_s.assign(401, 0.0);
  findings.clean.lift_m = 0.012;
  findings.before = AuditReport{};
  findings.before->violations = {{Law::kReach, 1.25, "FL_foot", 0.5, 0.4, "m"},
                                 {Law::kJointTorque, 3.5, "FL_calf_joint", 90.0, 33.5, "N m"}};
  findings.broken = {{Law::kReach, 0.25, {1.0}, {{1.0, 2.0}}},
                     {Law::kJointTorque, 0.5, {2.0, 3.0}, {{2.0, 2.5}, {2.502, 3.0}, {3.25, 4.0}}}};
  return findings;
}

/// A repair of it that takes a second longer and still fails one check.
inline RepairedMotion BadRepair() {
  RepairedMotion repaired;
  const EvenMotion original = Standing(NamedRobot("a1"), 501);
  repaired.plan.robot = "a1";
  repaired.plan.whole_body.step_s = original.step_s;
  repaired.plan.whole_body.q = original.q;
  repaired.plan.whole_body.v = original.v;
  repaired.plan.whole_body.a = original.a;
  repaired.plan.terrain = FlatTerrain();
  repaired.original = std::make_shared<const EvenMotion>(original);
  repaired.after.violations = {{Law::kJointTorque, 4.5, "FL_calf_joint", 40.0, 33.5, "N m"}};
  repaired.broken = {{Law::kJointTorque, 0.1, {4.0}, {{4.4, 4.9}}}};
  repaired.distance.groups = {{"legs", "rad", 0.0625, 0.25, 2.0, "FL_calf_joint", std::vector<float>(501, 0.0625F)},
                              {"base", "m", 0.0155, 0.031, 1.0, "", std::vector<float>(501, 0.0155F)}};
  return repaired;
}

}  // namespace gaitwright::synthetic
