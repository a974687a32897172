// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/pipeline/plan_motion.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// A foot and its position: a step of an external planner.
struct PlacedStep {
  int foot = 0;      ///< index into RobotModel::feet
  PlanarPose place;  ///< contact point or middle of the sole in W; yaw relative to the standing posture
};

/// Times of steps that are made in sequence [s].
struct StepTimes {
  double swing_s = 0.5, pause_s = 0.1;
};

/// The steps as a footstep file (docs/import.md), with step k in line k, so that failures name the step.
/// @throws InvalidArgument for a foot that the robot does not have.
std::string FootstepsYaml(const RobotModel& model, const std::vector<PlacedStep>& steps, const StepTimes& times);

/// Plans a whole-body motion over steps, from standing at the origin. The plan is not audited. Failure as of
/// PlanFootstepFile. @throws as FootstepsYaml does.
Result<MotionPlan> PlanOverSteps(const RobotModel& model, const Terrain& terrain, const std::vector<PlacedStep>& steps,
                                 const StepTimes& times = {}, const MotionOptions& options = {});

}  // namespace gaitwright
