// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/pipeline/plan_motion.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// A foot and where it is put: a step of somebody's own planner.
struct PlacedStep {
  int foot = 0;      ///< index into RobotModel::feet
  PlanarPose place;  ///< of the contact point or the sole's middle in W; yaw beyond that of standing
};

/// How long steps take that are taken one after the other [s].
struct StepTimes {
  double swing_s = 0.5, pause_s = 0.1;
};

/// The steps as a file of footsteps has them (docs/import.md): step k in line k, so that failures name it.
/// @throws InvalidArgument for a foot that the robot does not have.
std::string FootstepsYaml(const RobotModel& model, const std::vector<PlacedStep>& steps, const StepTimes& times);

/// Plans the motion of all the rest over steps, from standing at the origin on. Its audit is the caller's to make.
/// Failure as of PlanFootstepFile. @throws as FootstepsYaml.
Result<MotionPlan> PlanOverSteps(const RobotModel& model, const Terrain& terrain, const std::vector<PlacedStep>& steps,
                                 const StepTimes& times = {}, const MotionOptions& options = {});

}  // namespace gaitwright
