// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/pipeline/plan_motion.h"
#include "optimisation/pipeline/solve_windows_internal.h"
#include "optimisation/trajectory/solved_trajectory_internal.h"
#include "optimisation/whole_body/finish_problem_internal.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Largest unbalanced wrench on the base of a plan at 1 kHz: what its motion needs and its contact forces do not give.
struct PlanResidual {
  double force = 0.0;   ///< over the weight
  double moment = 0.0;  ///< over the weight times the leg's length
  double at_s = 0.0;    ///< of the larger one

  double largest() const { return std::max(force, moment); }
};
PlanResidual ResidualOf(const RobotModel& model, const MotionPlan& plan);

/// Why FinishMotion does not take a plan; empty if it does.
std::string ReasonNotFinished(const RobotModel& model, const MotionPlan& plan);

/// Makes a plan dynamically consistent: the motion of the whole body and the forces on its feet are optimised together
/// over the plan's contacts, near the plan's motion. Footholds, swings and times stay unless the options choose them
/// (ChooseContacts). Only feet that roll land beside their footholds, by the change of their roll. Forces rise from
/// zero after touch-down and fall to zero before lift-off.
///
/// Failure kInfeasible names the constraint, the joint or foot and the time that forbid the motion.
/// @throws InvalidArgument as ReasonNotFinished says: for a plan without motion or of another robot, and for one in
/// which the robot hangs or lies.
///
/// @param friction_use  share of the friction coefficient that forces may use (WholeBodyOptions).
/// @param end_as_standing  feet that roll land so that they end at their places of the standing posture
/// (PipelineOptions); otherwise they end beside these by what they have rolled.
Result<MotionPlan> FinishMotion(const RobotModel& model, const MotionPlan& plan, const TrajectoryOptions& options,
                                double friction_use = 0.9, FinishReport* report = nullptr,
                                bool end_as_standing = false);

/// How far FollowMotion has come: windows of the present solve.
struct FollowProgress {
  int solve = 1, done = 0, all = 1;
};

/// How FollowMotion stays near a motion.
struct FollowOptions {
  BodyWeights weights;
  double friction_use = 0.9;
  /// Distance that pressure keeps from the edges of soles [m], at most half the distance from the sole's middle to
  /// the edge. It is given up if there is no solution with it.
  double sole_margin_m = 0.0;
  double effort_use = 0.92;  ///< share of motors' limits; given up likewise
  int least_per_swing = 24;  ///< knots over a swing: with fewer, feet leave its path after lift-off
  WindowOptions windows;
  std::function<void(BodyProblem&)> prepare;  ///< changes the problem before it is solved, such as its weights
  std::function<void(const FollowProgress&)> progress;
  SolveRecord* record = nullptr;  ///< keeps the solves of a motion in several windows; may be null
};

/// What FollowMotion did.
struct FollowReport : FinishReport {
  int windows = 1;                   ///< in which it was solved
  std::vector<double> unmet_s = {};  ///< without a solution: times at which constraints stay violated, in order
};

/// Like FinishMotion, for a motion that nobody planned: it may be far from dynamically consistent, so that a solve is
/// not ended early, and the first posture is free.
Result<MotionPlan> FollowMotion(const RobotModel& model, const MotionPlan& plan, const TrajectoryOptions& options,
                                const FollowOptions& follow, FollowReport* report = nullptr);

/// Replaces a plan by the finished one (FinishMotion), with its warnings, figures and summary; otherwise sets
/// `unfinished`. A plan that FinishMotion does not take stays as it is.
void FinishPlanned(const RobotModel& model, const MotionOptions& options, PlannedMotion& planned);

/// Sets the rows of a plan to a solved trajectory; then its footholds of feet that roll with the swings between them;
/// then its centre of mass and zero-moment point.
void SetRows(const RobotModel& model, const SolvedTrajectory& solved, double step_s, MotionPlan& plan);
void SetFootholds(const FootRolls& rolls, const std::vector<FootCourse>& courses, MotionPlan& plan);
void SetCentroidal(const RobotModel& model, MotionPlan& plan);

}  // namespace gaitwright
