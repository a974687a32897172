// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/trajectory/body_problem_internal.h"
#include "optimisation/whole_body/foot_course_internal.h"

namespace gaitwright {

/// What turns a plan into a BodyProblem.
struct FinishSettings {
  double knot_step_s = 0.01;
  double friction_use = 0.9;
  BodyWeights weights;
  BodyLimitUse use;
  bool end_as_standing = false;  ///< feet that roll end at their places of the standing posture
};

/// Knots over a schedule: at all its changes, and at most so far apart in between, half as far while heels rise; where
/// the plan's rows are, if they are at the changes. @param least_per_swing  knots over a swing of any foot are at least
/// as dense as this many over the swing; 0: no such limit. @param also_s  further times at which there are knots.
std::vector<double> KnotTimesOf(const MotionPlan& plan, double knot_step_s, int least_per_swing = 0,
                                const std::vector<double>& also_s = {});

/// Rows of a foot's position and rotation that no other foot's rows before it fix already, in the standing posture: a
/// leg that cannot roll its ankle has no row for it. By foot of a leg.
std::vector<std::array<bool, 6>> FreeFootRows(const RobotModel& model);

/// The problem of a plan's motion over knots: its footholds and swings are held, its base and joints are what the
/// motion is to be near, and its forces are free.
/// The first posture is that of the plan, and the motion is at rest at both ends.
BodyProblem ProblemOf(const RobotModel& model, const MotionPlan& plan, const std::vector<FootCourse>& courses,
                      const std::vector<double>& knots_s, const FinishSettings& settings);

/// Sets where feet that roll are to be, from what they roll over a motion.
void SetRolledGoals(const RobotModel& model, const WholeBodyTrajectory& motion, const FootRolls& rolls,
                    const std::vector<FootCourse>& courses, BodyProblem& problem);

/// Control points of the spline through the references of a problem, at rest at both ends.
MatrixX FirstPoints(const BodyProblem& problem);

/// What the foot of a course has rolled when it touches down on each of its footholds. @param roll_W  by row of the
/// plan's motion, as in FootRolls.
std::vector<Vector3> RolledAtTouchdowns(const MotionPlan& plan, const FootCourse& course,
                                        const std::vector<Vector3>& roll_W);

/// Forces at the knots of a problem in units of the weight: those of a plan's wrenches, shared evenly among the points
/// of a foot; where it has none, the weight shared evenly.
std::vector<VectorX> FirstForces(const RobotModel& model, const MotionPlan& plan, const BodyProblem& problem);

}  // namespace gaitwright
