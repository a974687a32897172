// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/preflight/preflight.h"

namespace gaitwright {

/// A synthetic preflight: a go for a robot with two joints, with trials if requested.
inline Preflight MakeUpPreflight(bool trials = false) {
  Preflight p;
  p.robot = "a<1>";
  p.robot_hash = "robot-hash";
  p.program_version = "9.9";
  p.made_by = "PlanWalk";
  p.motion = "trot & stand";
  p.plan_hash = "motion-hash";
  p.whole_plan_hash = "plan-hash";
  p.duration_s = 2.5;
  p.mass_kg = 12.0;
  p.least_survival = 0.9;
  p.audit.samples = 2500;
  p.audit.margins = {{Law::kJointTorque, 0.5, "knee", 20.0, 25.0, 5.0, 0.2, "N m"},
                     {Law::kJointTorque, 0.75, "hip", 10.0, 25.0, 15.0, 0.6, "N m"},
                     {Law::kFrictionCone, 1.25, "left", 0.5, 0.8, 0.3, {}, "1"}};
  p.assumptions = {"the ground is flat"};
  p.not_checked = {"the battery"};
  if (!trials) return p;
  p.trials.emplace();
  TrialsResult& t = *p.trials;
  t.n = t.different = 100;
  t.survived = t.different_survived = 97;
  t.passed = t.different_passed = 90;
  t.survival = 0.97;
  t.survival_low = 0.915;
  t.survival_high = 0.99;
  t.causes = {{"tipped <over>", 3}};
  t.worst = {{42, "base under 0.4 of its height"}};
  t.disturbances = "mass_scale: 1.1\nfriction: <0.5>\n";
  t.controller = "stabilised";
  p.trial_conditions = {{"play.friction", "0.4", "0.8"}};
  return p;
}

}  // namespace gaitwright
