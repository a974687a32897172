// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/rigid_body_passes.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/centroidal/body_limits.h"
#include "optimisation/centroidal/plan_over_terrain.h"
#include "optimisation/pipeline/leg_motors.h"
#include "optimisation/pipeline/limit_violation.h"
#include "optimisation/pipeline/mean_height.h"
#include "optimisation/pipeline/names_of_feet.h"
#include "optimisation/pipeline/roll_moments.h"
#include "optimisation/pipeline/swings_along.h"
#include "optimisation/pipeline/walk_problem.h"
#include "optimisation/swing/free_swings.h"
#include "optimisation/swing/plan_swings.h"

namespace gaitwright {
namespace {

constexpr double kFollows = 0.05;  // share of the leg length: correction of the body's motion for swings out of reach

/// Rotation of the base in a motion at a row.
BaseTurning TurningOf(const RigidBodySample& sample, const Matrix3& inertia_B) {
  const Matrix3 R = RotationOf(sample.angles_rad);
  const Vector3& w = sample.w_WB_B;
  const Vector3 alpha = inertia_B.inverse() * (R.transpose() * sample.torque_W - w.cross(inertia_B * w));
  return {R, R * w, R * alpha};
}

/// By row and foot: the share of the weight that the foot carries in a motion.
std::vector<std::vector<double>> LoadsOf(const RigidBodyProblem& problem, const RigidBodyMotion& motion,
                                         const std::vector<RigidBodySample>& samples) {
  std::vector<std::vector<double>> loads(samples.size(), std::vector<double>(problem.feet.size(), 0.0));
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const auto& forces = motion.intervals[samples[k].interval].forces;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const RigidStance& stance = problem.stances[forces[i].stance];
      loads[k][static_cast<std::size_t>(stance.foot)] +=
          samples[k].force_W[i].dot(stance.X_WF.linear().col(2)) / (problem.mass_kg * kGravity);
    }
  }
  return loads;
}

/// Rows at which any foot presses on the ground.
std::vector<bool> PressingIn(const std::vector<std::vector<double>>& loads) {
  constexpr double kPresses = 0.02;  // share of the weight
  std::vector<bool> presses;
  for (const std::vector<double>& row : loads)
    presses.push_back(std::accumulate(row.begin(), row.end(), 0.0) > kPresses);
  return presses;
}

double Largest(const std::vector<PointWrench>& residuals, double weight_n) {
  double largest = 0.0;
  for (const PointWrench& w : residuals)
    largest = std::max({largest, w.force_W.norm() / weight_n, w.moment_W.norm() / weight_n});
  return largest;
}

}  // namespace

RigidBodyPasses::RigidBodyPasses(const MotionTask& task, const Crouch* crouch)
    : task_(task),
      model_(task.model),
      body_(CarriedBody(task.model, crouch)),
      clearance_(task.model, task.terrain),
      shapes_(task.model, task.skeleton.schedule, task.options.swing),
      problem_(WalkProblem(task, body_, crouch, shapes_)),
      uneven_(KindOfGround(task.terrain) != GroundKind::kFlat),
      free_(HasFreeFootholds(task)),
      mending_(free_ ? Mending::kRolling : Mending::kNone),
      patches_(PatchesOf(task, problem_)) {
  expected_roll_.assign(problem_.stances.size(), Vector3::Zero());
  roll_ = expected_roll_;
}

Result<MotionPass> RigidBodyPasses::Run(int& passes) {
  constexpr int kFreePasses = 2;  // passes with free footholds; then they are fixed
  constexpr int kMending = 3;     // passes after swings have changed
  // Over uneven ground, swings need to know the motion of the legs over fixed footholds.
  const int at_least = uneven_ ? kFreePasses + 1 : 1;
  if (const auto failure = ReasonBeyondLegs(problem_, task_.options.whole_body.friction_use))
    return WithNamesOfFeet(model_, *failure);
  MotionPass best;
  int most = task_.options.pipeline.max_body_passes, least = std::min(at_least, most);
  for (passes = 0; passes < most;) {
    Result<MotionPass> made = MakePass();
    if (!made && passes > 0) break;  // the audit decides whether the last one is good enough
    if (!made) return made;
    ++passes;
    Learn(*made);
    if (passes == kFreePasses) HoldFootholds(made->footsteps);
    if (made->settled || !best.settled) best = std::move(*made);
    if (passes < least || (!best.settled && passes < most)) continue;
    if (!MendSwings()) break;
    least = most = passes + kMending;
    best.settled = false;
  }
  return best;
}

/// On uneven ground, if feet in the air touch solids: by knowing how they roll, then by swings that are planned
/// together with the body, once each. @return whether passes should go on.
bool RigidBodyPasses::MendSwings() {
  if (!uneven_ || !numbers_ || mending_ == Mending::kAlong) return false;
  const PlanOverPatches now{{problem_, patches_}, {motion_, {}, *numbers_}};
  if (mending_ == Mending::kNone) {
    if (!SwingsTouch(task_, now, former_)) return false;
    mending_ = Mending::kRolling;
    return true;
  }
  mending_ = Mending::kAlong;
  RigidBodyOptions options = Options();
  options.method = "interior-point";
  std::optional<PlanOverPatches> found = WithSwingsAlong(task_, now, options, former_);
  if (!found) return false;
  former_.swings.clear();
  for (std::size_t i = 0; i < found->choice.problem.swings.size(); ++i)
    former_.swings.push_back(SwingOf(found->choice.problem, found->plan.motion, i, task_.skeleton.schedule.start_s()));
  problem_ = std::move(found->choice.problem);
  numbers_ = std::move(found->plan.numbers);
  return true;
}

RigidBodyOptions RigidBodyPasses::Options() const {
  RigidBodyOptions options = WalkOptions(task_, problem_);
  if (free_) options.method = "interior-point";
  return options;
}

void RigidBodyPasses::HoldFootholds(const FootstepPlan& footsteps) {
  for (std::size_t i = 0; i < problem_.stances.size(); ++i) {
    problem_.stances[i].X_WF = footsteps.footholds[i].X_WF;
    problem_.stances[i].held = true;
  }
  holds_ = true;
}

FootstepPlan RigidBodyPasses::FootstepsOf(const RigidBodyMotion& motion) const {
  FootstepPlan footsteps = task_.skeleton.footsteps;
  for (std::size_t i = 0; i < footsteps.footholds.size(); ++i) {
    footsteps.footholds[i].X_WF = motion.X_WF[i];
    footsteps.footholds[i].roll_W = roll_[i];
    if (patches_[i] >= 0) footsteps.footholds[i].patch = patches_[i];
  }
  return footsteps;
}

void RigidBodyPasses::SetCentroidal(const std::vector<RigidBodySample>& samples, MotionPass& pass) const {
  CentroidalTrajectory& c = pass.centroidal;
  c.start_s = task_.skeleton.schedule.start_s();
  c.step_s = task_.options.pipeline.grid_step_s;
  for (const RigidBodySample& sample : samples) {
    c.p_WC.push_back(sample.p_WC);
    c.v_WC.push_back(sample.v_WC);
    c.a_WC.push_back(sample.a_WC);
  }
  c.omega_rad_s = std::sqrt(kGravity / MeanHeightOverFeet(c, pass.footsteps, static_cast<int>(model_.feet.size())));
}

/// Positions of a swing foot that the last motion allows, with a margin, for the next motion.
std::vector<ReachSide> RigidBodyPasses::ReachAt(int foot, double time_s) const {
  const double at = (time_s - task_.skeleton.schedule.start_s()) / task_.options.pipeline.grid_step_s;
  const auto row = std::clamp<long>(std::lround(at), 0, static_cast<long>(samples_.size()) - 1);
  const RigidBodySample& sample = samples_[static_cast<std::size_t>(row)];
  return SidesInWorld(problem_.feet[static_cast<std::size_t>(foot)].workspace_in_air_B, sample.p_WC,
                      RotationOf(sample.angles_rad), kFollows * model_.leg_length_m());
}

/// With free footholds: plans over the patches on which constraints are violated least.
Result<RigidBodyPlan> RigidBodyPasses::PlanFree(const RigidBodyOptions& options, RigidBodyPlan& last) {
  constexpr double kNear = 0.5;  // share of the leg length: distance of another patch
  if (!free_ || holds_) return PlanRigidBody(problem_, options, &last);
  PatchSearchOptions search;
  search.near_m = kNear * model_.leg_length_m();
  PlanOverPatches best;
  const Result<PlanOverPatches> plan =
      PlanOverChoice(task_.terrain, {problem_, patches_}, WalkPatchRules(task_), options, search, &best);
  problem_ = std::move(best.choice.problem);
  patches_ = std::move(best.choice.patches);
  last = std::move(best.plan);
  if (!plan) return plan.failure();
  return last;
}

/// Plans with the wanted clearance from the ground; if no motion keeps it, with the required clearance. A motion with
/// small violations is accepted in a pass, because the next pass corrects it; the audit checks the final motion.
Result<RigidBodyPlan> RigidBodyPasses::PlanClear(const RigidBodyOptions& options) {
  constexpr double kLittle = 3e-3;  // m, rad, m g
  while (true) {
    problem_.clearances = clearance_.Wanted();
    RigidBodyPlan last;
    if (numbers_) {
      Result<RigidBodyPlan> plan = PlanRigidBodyFrom(problem_, options, *numbers_);
      if (plan) return plan;
    }
    Result<RigidBodyPlan> plan = PlanFree(options, last);
    if (plan) return plan;
    if (!problem_.clearances.empty() && clearance_.Ease()) continue;
    if (last.summary.violation < kLittle) return last;
    return plan;
  }
}

Result<MotionPass> RigidBodyPasses::MakePass() {
  const RigidBodyOptions options = Options();
  Result<RigidBodyPlan> plan = PlanClear(options);
  if (!plan) return WithNamesOfFeet(model_, plan.failure());
  motion_ = std::move(plan->motion);
  if (holds_) numbers_ = std::move(plan->numbers);
  samples_ = Sample(motion_, task_.options.pipeline.grid_step_s);
  MotionPass pass;
  pass.footsteps = FootstepsOf(motion_);
  SetCentroidal(samples_, pass);
  std::function<std::vector<ReachSide>(int, double)> reach;
  if (uneven_) reach = [this](int foot, double time_s) { return ReachAt(foot, time_s); };
  const FormerMotion known = mending_ == Mending::kNone ? FormerMotion() : former_;
  Result<std::vector<SwingTrajectory>> swings =
      PlanSwings(model_, task_.terrain, pass.footsteps, task_.options.swing,
                 {{},
                  known.roll,
                  known.swings,
                  [&](const SwingTrajectory& swing) { return shapes_.At(swing.start_s, swing.end_s).lift_m; },
                  [&](const SwingTrajectory& swing) { return shapes_.At(swing.start_s, swing.end_s).cruise; },
                  reach});
  if (!swings) return swings.failure();
  pass.swings = std::move(*swings);
  const auto loads = LoadsOf(problem_, motion_, samples_);
  const auto row = [&](double time_s) {
    const double at = (time_s - pass.centroidal.start_s) / pass.centroidal.step_s;
    return static_cast<std::size_t>(std::clamp<long>(std::lround(at), 0, static_cast<long>(samples_.size()) - 1));
  };
  const WholeBodyProblem problem{
      &task_.terrain,
      &task_.skeleton.schedule,
      &pass.footsteps,
      &pass.centroidal,
      &pass.swings,
      [&](double time_s) { return TurningOf(samples_[row(time_s)], problem_.inertia_B); },
      [&](int foot, double time_s) { return loads[row(time_s)][static_cast<std::size_t>(foot)]; }};
  Result<WholeBodySolution> solution = SolveWholeBody(model_, problem, expected_roll_, task_.options.whole_body);
  if (!solution) return solution.failure();
  pass.solution = std::move(*solution);
  pass.centroidal.p_WZ = HeldOverFlights(pass.solution.pressure_W, PressingIn(loads));
  pass.error_m = Largest(pass.solution.residual_W, model_.weight_n());
  pass.violation = TotalViolation(model_, pass.solution.trajectory, kRangeMargin);
  pass.lacks_m = clearance_.Look(pass.solution.trajectory, samples_);
  pass.settled = pass.lacks_m <= 0.0;
  return pass;
}

/// Sets the legs' angular momentum and its rate: those of the whole body less those of the rigid body.
void RigidBodyPasses::UpdateLegMotion(const WholeBodyTrajectory& rows, DynamicsScratch& scratch) {
  VectorX needed;
  const std::size_t n = samples_.size();
  const std::vector<Vector3> roll_moment = RollMoments(problem_, motion_, samples_);
  Vector3 by_roll = Vector3::Zero();
  problem_.leg_momentum_W.resize(n, Vector3::Zero());
  problem_.leg_torque_W.resize(n, Vector3::Zero());
  for (std::size_t k = 0; k < n; ++k) {
    InverseDynamics(model_, rows.q[k], rows.v[k], rows.a[k], scratch, needed);
    const Vector3 arm = scratch.p_WB[0] - CentreOfMass(model_, scratch);
    const Vector3 of_box = RotationOf(samples_[k].angles_rad) * problem_.inertia_B * samples_[k].w_WB_B;
    if (k > 0) by_roll += 0.5 * rows.step_s * (roll_moment[k - 1] + roll_moment[k]);
    problem_.leg_momentum_W[k] = CentroidalMomentum(model_, scratch).tail<3>() - of_box - by_roll;
    problem_.leg_torque_W[k] =
        needed.segment<3>(3) + arm.cross(needed.head<3>()) - samples_[k].torque_W - roll_moment[k];
  }
}

/// Stores the swing paths over the ground, whose lift may exceed the bump, or which may have a detour.
void RigidBodyPasses::LearnSwings(const std::vector<SwingTrajectory>& swings) {
  constexpr double kSame = 1e-9;  // [s]
  const double start_s = task_.skeleton.schedule.start_s();
  for (RigidSwing& rigid : problem_.swings) {
    const RigidStance& from = problem_.stances[rigid.from];
    const auto made = std::find_if(swings.begin(), swings.end(), [&](const SwingTrajectory& swing) {
      return swing.foot == from.foot && std::abs(swing.start_s - start_s - from.end_s) < kSame;
    });
    if (made == swings.end()) continue;
    rigid.lift_m = made->lift_m;
    rigid.detour_W = made->detour_W;
  }
}

/// Stores the motion of the legs and the rolling of the feet.
void RigidBodyPasses::Learn(const MotionPass& pass) {
  const WholeBodySolution& solution = pass.solution;
  DynamicsScratch scratch(model_);
  LearnSwings(pass.swings);
  if (uneven_) former_ = MotionOf(model_, solution.trajectory, pass.swings);
  const double step_s = pass.centroidal.step_s;
  for (std::size_t i = 0; i < problem_.stances.size(); ++i) {
    RigidStance& stance = problem_.stances[i];
    expected_roll_[i] = solution.roll_at_touchdown_W[i];
    roll_[i] = solution.roll_at_liftoff_W[i] - solution.roll_at_touchdown_W[i];
    const std::vector<Vector3>& contact = solution.contact_W[static_cast<std::size_t>(stance.foot)];
    const auto first = static_cast<std::size_t>(std::lround(stance.start_s / step_s));
    const auto last = static_cast<std::size_t>(std::lround(stance.end_s / step_s));
    stance.moved_W.clear();
    stance.motors.clear();
    for (std::size_t k = first; k <= last; ++k) {
      stance.moved_W.push_back(contact[k] - contact[first]);
      stance.motors.push_back(MotorLimitsOf(model_, solution.trajectory, k, stance.foot, scratch));
    }
  }
  UpdateLegMotion(solution.trajectory, scratch);
}

}  // namespace gaitwright
