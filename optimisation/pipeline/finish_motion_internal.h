// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/whole_body/finish_problem_internal.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How a plan is finished by the trajectory optimisation of the whole body.
///
/// Tuning
///   the motion strays far from the plan        raise near
///   motors are near their limits               raise effort
///   a fast motion is refused for its residual   lower knot_step_s
struct FinishOptions {
  double knot_step_s = 0.01;
  double residual = 1e-3;
  int max_refinements = 3;
  int max_iterations = 60;
  double near = 1.0;
  double effort = 0.3;
  double friction_use = 0.9;  ///< set by whole_body.friction_use

  OptionFields Fields() {
    return WithBasics(
        {},
        {{"knot_step_s", &knot_step_s, "s", 0.001, 0.05, "Longest time between knots of the trajectory optimisation."},
         {"residual", &residual, "1", 1e-6, 0.02,
          "Largest unbalanced force between knots divided by the weight, and moment divided by the weight times the "
          "leg length; intervals above it are halved."},
         {"max_refinements", &max_refinements, "1", 0, 6, "How often intervals between knots may be halved."},
         {"max_iterations", &max_iterations, "1", 1, 1000, "Maximum number of iterations of each solve."},
         {"near", &near, "1", 1e-3, 1e3, "Weight on the distance of base and joints from the plan to be finished."},
         {"effort", &effort, "1", 0.0, 1e3, "Weight on the efforts of motors, as shares of their limits."}});
  }
};

/// How a plan was finished.
struct FinishReport {
  int knots = 0, variables = 0, refinements = 0;
  int iterations = 0;            ///< of all solves
  double solve_cpu_s = 0.0;      ///< in these
  double residual_force = 0.0;   ///< at 1 kHz, over the weight
  double residual_moment = 0.0;  ///< at 1 kHz, over the weight times the leg's length
  double residual_at_s = 0.0;
  std::string summary;  ///< one line
};

/// Largest unbalanced wrench on the base of a plan at 1 kHz: what its motion needs and its contact forces do not give.
///
/// Where little presses, a small moment moves the zero-moment point far, off the line between two feet: `by_interval`
/// counts that too, so that 1e-3 is 0.7 of what the audit lets pass.
struct PlanResidual {
  double force = 0.0;                    ///< over the weight
  double moment = 0.0;                   ///< over the weight times the leg's length
  double at_s = 0.0;                     ///< of the larger one
  std::vector<double> by_interval = {};  ///< the larger one, between times that were asked for
};
PlanResidual ResidualOf(const RobotModel& model, const MotionPlan& plan, const std::vector<double>& knots_s);

/// Why FinishMotion does not take a plan; empty if it does.
std::string ReasonNotFinished(const RobotModel& model, const MotionPlan& plan);

/// Makes a plan dynamically consistent: the motion of the whole body and the forces on its feet are optimised together
/// over the plan's contacts, near the plan's motion. Footholds, swings and times stay, but that feet that roll land
/// by as much aside as they roll more or less. Forces rise from zero after touch-down and fall to zero before lift-off.
///
/// Failure kInfeasible names the constraint, the joint or foot and the time that forbid the motion.
/// @throws InvalidArgument as ReasonNotFinished says: for a plan without motion or of another robot, and for one in
/// which the robot hangs or lies.
Result<MotionPlan> FinishMotion(const RobotModel& model, const MotionPlan& plan, const FinishOptions& options,
                                FinishReport* report = nullptr);

/// The rows of a plan from a trajectory over knots: its whole body, centre of mass, zero-moment point, footholds of
/// feet that roll and swings between them.
struct FinishedTrajectory {
  const BodyProblem& problem;
  const ChainSpline& spline;
  MatrixX points;
  std::vector<VectorX> forces;
};
void SetRows(const RobotModel& model, const FinishedTrajectory& finished, double step_s, MotionPlan& plan);
void SetFootholds(const FootRolls& rolls, const std::vector<FootCourse>& courses, MotionPlan& plan);
void SetCentroidal(const RobotModel& model, MotionPlan& plan);

}  // namespace gaitwright
