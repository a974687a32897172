// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/motion_passes.h"

#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "optimisation/centroidal/centre_of_mass.h"
#include "optimisation/pipeline/carried_base.h"
#include "optimisation/pipeline/limit_violation.h"
#include "optimisation/pipeline/robot_body.h"
#include "optimisation/swing/plan_swings.h"
#include "optimisation/swing/planar_swings.h"
#include "optimisation/swing/swing_ground.h"
#include "optimisation/whole_body/reach_height.h"
#include "planning/audit/tolerances.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {
namespace {

/// [m] Tolerance outside of a support. A reference that leaves a line starts on the edge, so that every error shows
/// there.
constexpr double kOutside = 5e-7;
constexpr int kAdapting = 2;    // passes that adapt the body's height
constexpr double kBend = 0.12;  // share of a cycle over which bends of the body's height are spread
constexpr double kFirstReachMargin = 0.03,
                 kReachMargin = 0.02;  // margin of reach in leg lengths: at first, and after the first pass

/// Position of the centre of mass in plan view in the standing posture, with the base's origin at a planar pose.
Vector2 CentreOfMassAt(const RobotModel& model, const PlanarPose& at) {
  return Vector2(at.x_m, at.y_m) + (YawRotation(at.yaw_rad) * StandingCentreOfMass(model)).head<2>();
}

/// Controlled frames of the feet at a time, on their footholds or in swing.
std::vector<Pose> FeetAt(const RobotModel& model, const MotionPass& pass, double time_s) {
  std::vector<Pose> feet;
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    const auto swing = std::find_if(pass.swings.begin(), pass.swings.end(), [&](const SwingTrajectory& s) {
      return s.foot == f && s.start_s < time_s && time_s < s.end_s;
    });
    Pose X_WF = swing != pass.swings.end()
                    ? Evaluate(CurveOf(*swing), time_s).X_WF
                    : pass.footsteps.footholds[static_cast<std::size_t>(FootholdAt(pass.footsteps, f, time_s))].X_WF;
    X_WF.translation() += model.feet[static_cast<std::size_t>(f)].radius * X_WF.linear().col(2);
    feet.push_back(X_WF);
  }
  return feet;
}

/// Violation of a body whose vertical acceleration is so large that it hops: legs that straighten and bend again within
/// one step keep their limits, but controllers do not follow them. It stays below the bound that ends a search, so that
/// such a motion is used if no other body strategy is better.
double HopViolation(const CentroidalTrajectory& motion) {
  constexpr double kLargestAcceleration = 0.1 * kGravity, kMost = 0.04;
  double largest = 0.0;
  for (const Vector3& a_WC : motion.a_WC) largest = std::max(largest, std::abs(a_WC.z()));
  return std::clamp(kMost * (largest / kLargestAcceleration - 1.0), 0.0, kMost);
}

}  // namespace

MotionPasses::MotionPasses(const MotionTask& task, const BodyStrategy& strategy)
    : task_(task),
      model_(task.model),
      body_(task.body),
      in_reach_(strategy.in_reach),
      level_(KindOfGround(task.terrain) <= GroundKind::kLevel),
      footsteps_(task.skeleton.footsteps),
      planes_(PlanesOfLegs(task.model)) {
  is_planar_ = std::any_of(planes_.begin(), planes_.end(), [](const auto& plane) { return plane.has_value(); });
  const FootstepSkeleton& skeleton = task.skeleton;
  expected_roll_.assign(footsteps_.footholds.size(), Vector3::Zero());
  problem_.start_s = skeleton.schedule.start_s();
  problem_.step_s = task.options.pipeline.grid_step_s;
  problem_.samples =
      1 + static_cast<int>(std::lround((skeleton.schedule.end_s() - problem_.start_s) / problem_.step_s));
  problem_.com_height_m = strategy.com_height_m;
  problem_.omega_rad_s = std::sqrt(kGravity / strategy.com_height_m);
  problem_.start_W = CentreOfMassAt(model_, skeleton.path.pose.front());
  problem_.end_W = CentreOfMassAt(model_, skeleton.path.pose.back());
  problem_.zmp_offset.assign(static_cast<std::size_t>(problem_.samples), Vector2::Zero());
  support_ = {problem_.start_W, problem_.end_W, strategy.zmp_inward, problem_.step_s, {}, {}};
  for (const Foothold& foothold : footsteps_.footholds) {
    const Foot& foot = model_.feet[static_cast<std::size_t>(foothold.foot)];
    support_.support_F.push_back(SupportOf(foot, foothold, task.terrain));
  }
  if (strategy.lean_rad != 0.0) body_.Lean(strategy.lean_rad, task.cycle_s);
}

Result<MotionPass> MotionPasses::Run(int& passes, double infeasible) {
  MotionPass best;
  double gain = 1.0;
  const int most = task_.options.pipeline.max_passes;
  bool nears = false;  // the last pass reduced the ZMP error, and the error is still above the audit's limit
  for (passes = 0; passes < most || (nears && passes < 2 * most); ++passes) {
    adapts_ = in_reach_ && passes < kAdapting;
    Result<MotionPass> made = MakePass();
    if (!made) return made;
    const bool rolled = UpdateRolls(made->solution), leaned = UpdateLeans(*made);
    made->settled = rolled && leaned;
    nears = false;
    if (adapts_ || made->BetterThan(best)) {
      best = *made;
      nears = best.settled && best.error_m > tolerance::kZmp;
    } else {
      gain *= 0.5;
      if (gain < 0.1) break;
    }
    if (passes == (in_reach_ ? kAdapting : 0) && best.violation > infeasible) break;
    const bool near = best.error_m < task_.options.pipeline.zmp_tolerance_m && best.outside_m < kOutside;
    if (best.settled && near && !adapts_) break;
    UpdateOffset(*made, gain);
  }
  return best;
}

double MotionPasses::Outside(const MotionPass& pass) const {
  double outside = 0.0;
  for (std::size_t k = 0; k < pass.solution.zmp_W.size(); ++k) {
    const double t = problem_.start_s + static_cast<double>(k) * problem_.step_s;
    const Polygon region = RegionAt(problem_.phases[ZmpPhaseAt(problem_, t)], t);
    if (region.size() >= 3) outside = std::max(outside, -SignedDistance(region, pass.solution.zmp_W[k]));
  }
  return outside;
}

/// Moves the pendulum up by the height of the ground below the body. The resulting change of the ZMP is corrected like
/// all other effects that the pendulum model ignores.
void MotionPasses::FollowGround(CentroidalTrajectory& motion) const {
  for (int k = 0; k < motion.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Motion1 ground = body_.GroundAt(motion.start_s + k * motion.step_s);
    motion.p_WC[i].z() = problem_.com_height_m + ground.value;
    motion.v_WC[i].z() = ground.rate;
    motion.a_WC[i].z() = ground.acceleration;
  }
}

/// Raises or lowers the body where legs do not reach their feet.
void MotionPasses::KeepInReach(MotionPass& pass) {
  const ReachHeight height(model_);
  const FormerMotion former = Former(pass.centroidal);
  reach_.clear();
  for (int k = 0; k < body_.knots(); ++k) {
    const double time_s = body_.KnotTime(k), ground_m = body_.GroundAt(time_s).value;
    const auto change = height.Changes(former.base(time_s), FeetAt(model_, pass, time_s),
                                       former_.base ? kReachMargin : kFirstReachMargin);
    constexpr double kAnything = 10.0;  // [m] no limit here; others check the height
    reach_.push_back({ground_m + (change ? change->low : -kAnything), ground_m + (change ? change->high : kAnything)});
  }
  body_.KeepWithin(reach_, kBend * task_.cycle_s);
  FollowGround(pass.centroidal);
}

/// The whole-body motion. If a leg is out of reach nevertheless, lowers the body around that time.
Result<WholeBodySolution> MotionPasses::SolveBody(MotionPass& pass) {
  constexpr int kTries = 12;
  constexpr double kLower = 0.01;  // share of the leg length
  const WholeBodyProblem problem{&task_.terrain, &task_.skeleton.schedule,
                                 &footsteps_,    &pass.centroidal,
                                 &pass.swings,   [this](double time_s) { return body_.TurningAt(time_s); }};
  for (int attempt = 0;; ++attempt) {
    double unreached_s = 0.0;
    auto solution = SolveWholeBody(model_, problem, expected_roll_, task_.options.whole_body, &unreached_s);
    if (solution || !in_reach_ || attempt == kTries) return solution;
    for (int k = 0; k < body_.knots(); ++k) {
      if (std::abs(body_.KnotTime(k) - unreached_s) > kBend * task_.cycle_s) continue;
      const double lower_m = body_.GroundAt(body_.KnotTime(k)).value - kLower * model_.leg_length_m();
      Bounds& bounds = reach_[static_cast<std::size_t>(k)];
      bounds.high = std::min(bounds.high, lower_m);
      bounds.low = std::min(bounds.low, lower_m);
    }
    body_.KeepWithin(reach_, kBend * task_.cycle_s);
    FollowGround(pass.centroidal);
  }
}

Result<MotionPass> MotionPasses::MakePass() {
  MotionPass pass;
  pass.footsteps = footsteps_;
  problem_.phases = SupportRegions(model_, task_.skeleton.schedule, footsteps_, support_);
  Result<CentreOfMassPlan> com = PlanCentreOfMass(problem_, task_.options.centre_of_mass);
  if (!com) return com.failure();
  pass.centroidal = std::move(com->trajectory);
  FollowGround(pass.centroidal);
  Result<std::vector<SwingTrajectory>> swings =
      PlanSwings(model_, task_.terrain, footsteps_, task_.options.swing, Former(pass.centroidal));
  if (!swings) return swings.failure();
  pass.swings = std::move(*swings);
  if (is_planar_ && leans_by_.base) LeanSwings(planes_, leans_by_.base, pass.swings);
  if (adapts_) KeepInReach(pass);
  Result<WholeBodySolution> solution = SolveBody(pass);
  if (!solution) return solution.failure();
  pass.solution = std::move(*solution);
  if (!level_) former_ = MotionOf(model_, pass.solution.trajectory, pass.swings);
  pass.error_m = 0.0;
  for (std::size_t k = 0; k < pass.solution.zmp_W.size(); ++k) {
    pass.error_m = std::max(pass.error_m, (pass.solution.zmp_W[k] - pass.centroidal.p_WZ[k]).norm());
  }
  pass.outside_m = Outside(pass);
  pass.violation = TotalViolation(model_, pass.solution.trajectory, kRangeMargin);
  if (in_reach_) pass.violation += HopViolation(pass.centroidal);
  return pass;
}

/// The assumed motion for swings over uneven ground: that of the previous pass, or the initial motion of the base.
FormerMotion MotionPasses::Former(const CentroidalTrajectory& motion) const {
  if (level_ || former_.base) return former_;
  return {CarriedBase(model_, body_, motion), {}, {}};
}

/// True if the rolls equal those assumed by the swings.
bool MotionPasses::UpdateRolls(const WholeBodySolution& solution) {
  support_.contact_W = solution.contact_W;
  constexpr double kSettled = 2e-4;
  double change = 0.0;
  for (std::size_t i = 0; i < footsteps_.footholds.size(); ++i) {
    const Vector3 roll = solution.roll_at_liftoff_W[i] - solution.roll_at_touchdown_W[i];
    change = std::max(change, (solution.roll_at_touchdown_W[i] - expected_roll_[i]).norm());
    change = std::max(change, (roll - footsteps_.footholds[i].roll_W).norm());
    expected_roll_[i] = solution.roll_at_touchdown_W[i];
    footsteps_.footholds[i].roll_W = roll;
  }
  if (task_.options.pipeline.end_as_standing) EndAsStanding();
  return change < kSettled;
}

/// True if the base leaned as assumed by the swings of planar legs.
bool MotionPasses::UpdateLeans(const MotionPass& pass) {
  constexpr double kSettled = 2e-4;  // [m]
  if (!is_planar_) return true;
  leans_by_ = MotionOf(model_, pass.solution.trajectory);
  std::vector<SwingTrajectory> swings = pass.swings;
  return LeanSwings(planes_, leans_by_.base, swings) < kSettled;
}

/// Moves the last footholds of rolling feet on level ground back by the distance that they roll in their last stance.
void MotionPasses::EndAsStanding() {
  constexpr double kTime = 1e-6, kUpright = 1.0 - 1e-9;  // [s], cosine
  const double end_s = task_.skeleton.schedule.end_s();
  for (std::size_t i = 0; i < footsteps_.footholds.size(); ++i) {
    Foothold& last = footsteps_.footholds[i];
    const bool ends = last.liftoff_s > end_s - kTime && last.touchdown_s > task_.skeleton.schedule.start_s() + kTime;
    const bool level = last.X_WF.linear().col(2).z() > kUpright;
    if (!ends || !level || model_.feet[static_cast<std::size_t>(last.foot)].radius == 0.0) continue;
    const Vector3 as_standing = task_.skeleton.footsteps.footholds[i].X_WF.translation();
    last.X_WF.translation().head<2>() = (as_standing - last.roll_W).head<2>();
  }
}

void MotionPasses::UpdateOffset(const MotionPass& pass, double gain) {
  for (std::size_t k = 0; k < problem_.zmp_offset.size(); ++k) {
    problem_.zmp_offset[k] += gain * (pass.solution.zmp_W[k] - pass.centroidal.p_WZ[k]);
  }
}

}  // namespace gaitwright
