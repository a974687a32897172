// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/trajectory/body_problem_internal.h"
#include "optimisation/whole_body/foot_course_internal.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How far feet may leave the planned paths of their swings.
struct SwingFreedom {
  double most_m = 0.05;      ///< largest distance along each axis
  double clearance_m = 0.0;  ///< smallest height in mid swing; 0 for half of what a planned swing has
  double shift_m = 0.0;      ///< by which the ends of swings may be shifted too, along each axis
};

/// Smallest height of a swing with this freedom in mid swing [m].
double ClearanceToKeep(const SwingTrajectory& swing, const SwingFreedom& freedom);

/// Lets the feet of a problem leave the paths of their swings at its knots. Constraints on a foot's height become
/// one-sided: it may rise by most_m, and sink as long as its underside stays higher than all ground and obstacles that
/// it can reach to the sides, by the clearance. All bounds shrink to zero towards both ends of the swing
/// (ClearanceRamp). Where the planned path itself is not as high as that, less room is given to the sides, and at last
/// none. Rotations stay those of the plan.
void FreeSwings(const RobotModel& model, const MotionPlan& plan, const std::vector<FootCourse>& courses,
                const SwingFreedom& freedom, BodyProblem& problem);

/// Replaces the detours of a plan's swings by those nearest to the motion of its whole body. A swing that would then
/// come closer to a solid than three fifths of its clearance stays as it is.
/// @return how many swings were replaced.
int FitSwings(const RobotModel& model, const SwingFreedom& freedom, MotionPlan& plan);

}  // namespace gaitwright
