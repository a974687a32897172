// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/pipeline/plan_motion.h"
#include "planning/plan/motion_plan.h"
#include "planning/tasks/posture_motion.h"

namespace gaitwright {

/// A plan of a posture motion on level ground. Feet are as in standing, except lifted ones; centre of mass, base and
/// joints outside the legs are as in the keys. The ZMP reference is the multibody ZMP; the audit checks whether it is
/// inside the support. The single part of the plan stands still and has the motion's name.
/// @param options  only the grid, the options of contact forces and `pipeline.com_height_m` are used. The latter is the
///                 reference of the keys' shifts; 0 uses the standing height.
/// Failure kInfeasible `out_of_reach` for a key out of the legs' reach, with the time and the foot.
/// @throws InvalidArgument for an invalid motion (CheckPostureMotion), or zero duration.
Result<MotionPlan> PlanPosture(const RobotModel& model, const PostureMotion& motion, const MotionOptions& options);

/// A plan with joints outside the legs moved as in a posture motion, from `from_s` on; the motion's body shifts and
/// rotations are ignored. Contact forces and the ZMP reference are those of the new motion. Failure kInfeasible as of
/// SolveWholeBody.
/// @throws InvalidArgument for an invalid motion, or one that does not end within the plan.
Result<MotionPlan> WithGesture(const RobotModel& model, const MotionPlan& plan, const PostureMotion& gesture,
                               double from_s, const WholeBodyOptions& options);

}  // namespace gaitwright
