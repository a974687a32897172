// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/restaged_plan.h"

#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/centroidal/centre_of_mass.h"
#include "optimisation/pipeline/support_regions.h"
#include "optimisation/whole_body/body_path.h"
#include "optimisation/whole_body/solve_whole_body.h"

namespace gaitwright {
namespace {

/// For straight walks on level ground only: the base neither turns nor tilts.
BodyPath StraightForward(const RobotModel& maker, const MotionPlan& plan) {
  constexpr double kEven = 0.1;  // [s] time over which the tilt is averaged; it is zero here
  FootstepSkeleton skeleton;
  skeleton.path.time_s = {plan.schedule.start_s(), plan.schedule.end_s()};
  skeleton.path.pose.resize(2);
  skeleton.schedule = plan.schedule;
  skeleton.footsteps = plan.footsteps;
  return {maker, skeleton, kEven};
}

void PutSwingsOnFootholds(MotionPlan& plan) {
  constexpr double kTime = 1e-6;
  for (SwingTrajectory& swing : plan.swings) {
    const auto at = [&](double time_s) -> const Foothold& {
      return plan.footsteps.footholds[static_cast<std::size_t>(FootholdAt(plan.footsteps, swing.foot, time_s))];
    };
    const Foothold &from = at(swing.start_s - kTime), &to = at(swing.end_s + kTime);
    swing.X_WF_start = from.X_WF;
    swing.X_WF_start.translation() += from.roll_W;
    swing.X_WF_end = to.X_WF;
  }
}

WholeBodySolution SolveAnew(const RobotModel& maker, MotionPlan& plan) {
  constexpr int kPasses = 6;  // until the rolling of spheres has converged
  const BodyPath body = StraightForward(maker, plan);
  std::vector<Foothold>& footholds = plan.footsteps.footholds;
  std::vector<Vector3> expected_roll(footholds.size(), Vector3::Zero());
  WholeBodySolution solution;
  for (int pass = 0; pass < kPasses; ++pass) {
    PutSwingsOnFootholds(plan);
    const WholeBodyProblem problem{&plan.terrain,   &plan.schedule,
                                   &plan.footsteps, &plan.centroidal,
                                   &plan.swings,    [&body](double time_s) { return body.TurningAt(time_s); }};
    solution = SolveWholeBody(maker, problem, expected_roll, WholeBodyOptions{}).value();
    double change = 0.0;
    for (std::size_t i = 0; i < footholds.size(); ++i) {
      const Vector3 roll = solution.roll_at_liftoff_W[i] - solution.roll_at_touchdown_W[i];
      change = std::max(change, (solution.roll_at_touchdown_W[i] - expected_roll[i]).norm());
      change = std::max(change, (roll - footholds[i].roll_W).norm());
      footholds[i].roll_W = roll;
    }
    expected_roll = solution.roll_at_touchdown_W;
    if (change < 1e-5) break;
  }
  PutSwingsOnFootholds(plan);
  plan.whole_body = solution.trajectory;
  return solution;
}

/// The pendulum problem whose solution is the plan's centre of mass.
ZmpProblem ProblemOf(const MotionPlan& plan) {
  const CentroidalTrajectory& c = plan.centroidal;
  ZmpProblem problem;
  problem.start_s = c.start_s;
  problem.step_s = c.step_s;
  problem.samples = c.size();
  problem.omega_rad_s = c.omega_rad_s;
  problem.com_height_m = kGravity / (c.omega_rad_s * c.omega_rad_s);
  problem.start_W = c.p_WC.front().head<2>();
  problem.end_W = c.p_WC.back().head<2>();
  for (std::size_t k = 0; k < c.p_WC.size(); ++k) {
    const Vector2 pendulum = (c.p_WC[k] - c.a_WC[k] / (c.omega_rad_s * c.omega_rad_s)).head<2>();
    problem.zmp_offset.push_back(c.p_WZ[k] - pendulum);
  }
  return problem;
}

}  // namespace

MotionPlan WithWholeBodyAnew(const RobotModel& maker, MotionPlan plan) {
  plan.centroidal.p_WZ = SolveAnew(maker, plan).zmp_W;
  return plan;
}

MotionPlan WithMotionAnew(const RobotModel& maker, MotionPlan plan) {
  constexpr int kPasses = 3;  // until the multibody ZMP has converged to its reference
  ZmpProblem problem = ProblemOf(plan);
  SupportInputs support;
  support.start_W = problem.start_W;
  support.end_W = problem.end_W;
  support.step_s = problem.step_s;
  for (int pass = 0; pass < kPasses; ++pass) {
    problem.phases = SupportRegions(maker, plan.schedule, plan.footsteps, support);
    plan.centroidal = PlanCentreOfMass(problem, CentreOfMassOptions{}).value().trajectory;
    const WholeBodySolution solution = SolveAnew(maker, plan);
    support.contact_W = solution.contact_W;
    for (std::size_t k = 0; k < problem.zmp_offset.size(); ++k)
      problem.zmp_offset[k] += solution.zmp_W[k] - plan.centroidal.p_WZ[k];
  }
  return plan;
}

void ShiftZmp(const Vector2& shift_W, int first_phase, int last_phase, MotionPlan& plan) {
  ZmpProblem problem = ProblemOf(plan);
  problem.start_W = problem.end_W = Vector2::Zero();
  problem.zmp_offset.assign(problem.zmp_offset.size(), Vector2::Zero());
  const ContactPhase& before = plan.schedule.phases[static_cast<std::size_t>(first_phase - 1)];
  const ContactPhase& after = plan.schedule.phases[static_cast<std::size_t>(last_phase + 1)];
  std::vector<Vector2> shifts;
  for (int k = 0; k < problem.samples; ++k) {
    const double t = problem.start_s + k * problem.step_s;
    const double rise = SmoothStep((t - before.start_s) / (before.end_s - before.start_s)).value;
    const double fall = SmoothStep((after.end_s - t) / (after.end_s - after.start_s)).value;
    shifts.push_back(std::min(rise, fall) * shift_W);
  }
  const CentroidalTrajectory shift = PendulumMotion(problem, shifts);
  for (std::size_t k = 0; k < shifts.size(); ++k) {
    plan.centroidal.p_WC[k].head<2>() += shift.p_WC[k].head<2>();
    plan.centroidal.v_WC[k].head<2>() += shift.v_WC[k].head<2>();
    plan.centroidal.a_WC[k].head<2>() += shift.a_WC[k].head<2>();
    plan.centroidal.p_WZ[k] += shifts[k];
  }
}

}  // namespace gaitwright
