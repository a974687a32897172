// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/pipeline/plan_motion.h"
#include "planning/plan/motion_plan.h"
#include "planning/tasks/posture_motion.h"

namespace gaitwright {

/// A plan of a posture motion on level ground: the feet where they are in standing, but for one that is lifted, the
/// centre of mass and the base as the keys say, the joints that no foot needs likewise. The reference of the ZMP is
/// that of the multibody; whether it is in the support is the audit's to say. Its one part stands still, under the
/// motion's name.
/// @param options  of which the grid, the contact forces' and `pipeline.com_height_m` count, from which the keys'
///        shifts are reckoned; 0 for that of standing.
/// Failure kInfeasible `out_of_reach` for a key that legs do not reach, with the time and the foot.
/// @throws InvalidArgument for a motion that is none (CheckPostureMotion), or of no duration.
Result<MotionPlan> PlanPosture(const RobotModel& model, const PostureMotion& motion, const MotionOptions& options);

/// A plan with joints outside the legs moved over it as a posture motion has them, from `from_s` on; the body's shifts
/// and turns are not looked at. Contact forces and the reference of the ZMP are those of the new motion.
/// Failure kInfeasible as of SolveWholeBody.
/// @throws InvalidArgument for a motion that is none, or does not end within the plan.
Result<MotionPlan> WithGesture(const RobotModel& model, const MotionPlan& plan, const PostureMotion& gesture,
                               double from_s, const WholeBodyOptions& options);

}  // namespace gaitwright
