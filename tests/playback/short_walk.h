// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "optimisation/pipeline/plan_motion.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {

/// A plan of a few steps on flat ground, from the planner.
inline MotionPlan ShortWalk(const RobotModel& model, const std::string& gait, int steps, double step_length_m) {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kSteps;
  command.steps = steps;
  command.step_length_m = step_length_m;
  const Gait fitted = FindGait(model, gait, model.nominal_speed_m_s, {}).value();
  return PlanMotion(model, FlatTerrain(), fitted, command, {}).value().plan;
}

}  // namespace gaitwright
