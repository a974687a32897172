// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/plan_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "kinematics/base/version.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/zero_moment_point.h"
#include "kinematics/trajectory/cubic_spline.h"
#include "optimisation/pipeline/carried_base.h"
#include "optimisation/pipeline/limit_excess.h"
#include "optimisation/pipeline/support_regions.h"
#include "optimisation/pipeline/tipped_sole.h"
#include "optimisation/swing/swing_ground.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {
namespace {

/// Centre of mass of the standing posture over level ground with the base origin at a planar pose.
Vector3 StandingCentreOfMass(const RobotModel& model, const PlanarPose& at) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  const Vector3 p_BC = CentreOfMass(model, scratch);
  Vector3 p_WC = YawRotation(at.yaw_rad) * p_BC;
  p_WC += Vector3(at.x_m, at.y_m, 0.0);
  return p_WC;
}

/// One pass: what was tried and how far its ZMP is from its reference.
///
/// A pass is settled when the feet rolled as the pass itself had taken them to. One that is not has footholds and
/// swings aimed with rolls that are not its own, so that its motion does not end where it should, whatever its ZMP
/// does: any settled pass is better. Among unsettled ones the newest is, being aimed with the freshest rolls; among
/// settled ones that whose ZMP is nearest to its reference.
struct Pass {
  CentroidalTrajectory centroidal;
  std::vector<SwingTrajectory> swings;
  FootstepPlan footsteps;
  WholeBodySolution solution;
  double error_m = std::numeric_limits<double>::infinity();
  double excess = 0.0;     ///< past limits of joints, summed in shares of the limits
  double outside_m = 0.0;  ///< of supports with area, by the multibody ZMP; on a line its error is all there is
  bool settled = false;

  bool BetterThan(const Pass& former) const {
    if (settled != former.settled) return settled;
    return !settled || error_m < former.error_m;
  }
};

/// How the body is carried.
struct Carriage {
  double com_height_m = 0.0;  ///< over the ground under the body
  double zmp_inward = 0.0;    ///< see SupportRegions
};

/// What all passes share.
struct Task {
  const RobotModel& model;
  const Terrain& terrain;
  const FootstepSkeleton& skeleton;
  const MotionOptions& options;
  const BodyPath& body;
};

/// Plans the stages after the footsteps again and again, feeding back what the multibody did.
class Passes {
 public:
  Passes(const Task& task, const Carriage& carriage)
      : model_(task.model),
        terrain_(task.terrain),
        skeleton_(task.skeleton),
        options_(task.options),
        body_(task.body),
        level_(IsLevelAndBare(task.terrain)),
        footsteps_(task.skeleton.footsteps) {
    expected_roll_.assign(footsteps_.footholds.size(), Vector3::Zero());
    const Vector3 start = StandingCentreOfMass(model_, skeleton_.path.pose.front());
    const Vector3 end = StandingCentreOfMass(model_, skeleton_.path.pose.back());
    problem_.start_s = skeleton_.schedule.start_s();
    problem_.step_s = options_.pipeline.grid_step_s;
    problem_.samples =
        1 + static_cast<int>(std::lround((skeleton_.schedule.end_s() - problem_.start_s) / problem_.step_s));
    problem_.com_height_m = carriage.com_height_m;
    problem_.omega_rad_s = std::sqrt(kGravity / carriage.com_height_m);
    problem_.start_W = start.head<2>();
    problem_.end_W = end.head<2>();
    support_ = {problem_.start_W, problem_.end_W, carriage.zmp_inward, problem_.step_s, {}, {}};
    for (const Foothold& foothold : footsteps_.footholds) {
      const Foot& foot = model_.feet[static_cast<std::size_t>(foothold.foot)];
      support_.support_F.push_back(SupportOf(foot, foothold, terrain_));
    }
    problem_.zmp_offset.assign(static_cast<std::size_t>(problem_.samples), Vector2::Zero());
  }

  /// One pass without corrections, enough to see which limits are kept.
  Result<Pass> RunOnce() { return MakePass(); }

  /// Passes until the ZMP is on its reference; a first one farther past limits than `hopeless` stays the only one.
  Result<Pass> Run(int& passes, double hopeless) {
    Pass best;
    double gain = 1.0;
    for (passes = 0; passes < options_.pipeline.max_passes; ++passes) {
      Result<Pass> made = MakePass();
      if (!made) return made;
      made->settled = UpdateRolls(made->solution);
      if (made->BetterThan(best)) {
        best = *made;
      } else {
        gain *= 0.5;
        if (gain < 0.1) break;
      }
      if (passes == 0 && best.excess > hopeless) break;
      const bool near = best.error_m < options_.pipeline.zmp_tolerance_m && best.outside_m < kOutside;
      if (best.settled && near) break;
      UpdateOffset(*made, gain);
    }
    return best;
  }

 private:
  /// [m] Out of a support. A reference that hands over from a line starts on the edge, so that every error shows there.
  static constexpr double kOutside = 5e-7;

  double Outside(const Pass& pass) const {
    double outside = 0.0;
    for (std::size_t k = 0; k < pass.solution.zmp_W.size(); ++k) {
      const double t = problem_.start_s + static_cast<double>(k) * problem_.step_s;
      const Polygon region = RegionAt(problem_.phases[ZmpPhaseAt(problem_, t)], t);
      if (region.size() >= 3) outside = std::max(outside, -SignedDistance(region, pass.solution.zmp_W[k]));
    }
    return outside;
  }

  /// Lifts the pendulum onto the ground that the body is carried over. What that changes of the ZMP is made good like
  /// all that the pendulum leaves out.
  void FollowGround(CentroidalTrajectory& motion) const {
    for (int k = 0; k < motion.size(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      const Motion1 ground = body_.GroundAt(motion.start_s + k * motion.step_s);
      motion.p_WC[i].z() += ground.value;
      motion.v_WC[i].z() = ground.rate;
      motion.a_WC[i].z() = ground.acceleration;
    }
  }

  Result<Pass> MakePass() {
    Pass pass;
    pass.footsteps = footsteps_;
    problem_.phases = SupportRegions(model_, skeleton_.schedule, footsteps_, support_);
    Result<CentreOfMassPlan> com = PlanCentreOfMass(problem_, options_.centre_of_mass);
    if (!com) return com.failure();
    pass.centroidal = std::move(com->trajectory);
    FollowGround(pass.centroidal);
    Result<std::vector<SwingTrajectory>> swings =
        PlanSwings(model_, terrain_, footsteps_, options_.swing, Former(pass.centroidal));
    if (!swings) return swings.failure();
    pass.swings = *swings;
    const WholeBodyProblem problem{&terrain_, &skeleton_.schedule, &footsteps_, &pass.centroidal, &pass.swings, &body_};
    Result<WholeBodySolution> solution = SolveWholeBody(model_, problem, expected_roll_, options_.whole_body);
    if (!solution) return solution.failure();
    pass.solution = std::move(*solution);
    if (!level_) former_ = MotionOf(model_, pass.solution.trajectory, pass.swings);
    pass.error_m = 0.0;
    for (std::size_t k = 0; k < pass.solution.zmp_W.size(); ++k) {
      pass.error_m = std::max(pass.error_m, (pass.solution.zmp_W[k] - pass.centroidal.p_WZ[k]).norm());
    }
    pass.outside_m = Outside(pass);
    pass.excess = TotalExcess(model_, pass.solution.trajectory);
    return pass;
  }

  /// What swings over ground that is not level reckon with: the pass before, or where the base is carried at first.
  FormerMotion Former(const CentroidalTrajectory& motion) const {
    if (level_ || former_.base) return former_;
    return {CarriedBase(model_, body_, motion), {}, {}};
  }

  /// True when the rolls are what the swings were aimed by.
  bool UpdateRolls(const WholeBodySolution& solution) {
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
    return change < kSettled;
  }

  void UpdateOffset(const Pass& pass, double gain) {
    for (std::size_t k = 0; k < problem_.zmp_offset.size(); ++k) {
      problem_.zmp_offset[k] += gain * (pass.solution.zmp_W[k] - pass.centroidal.p_WZ[k]);
    }
  }

  const RobotModel& model_;
  const Terrain& terrain_;
  const FootstepSkeleton& skeleton_;
  const MotionOptions& options_;
  const BodyPath& body_;
  const bool level_;
  FormerMotion former_;  // over ground that is not level
  FootstepPlan footsteps_;
  std::vector<Vector3> expected_roll_;
  ZmpProblem problem_;
  SupportInputs support_;
};

/// True where the robot stands on one sole alone for a while.
bool StandsOnOneSole(const RobotModel& model, const ContactSchedule& schedule) {
  return std::any_of(schedule.phases.begin(), schedule.phases.end(), [&](const ContactPhase& phase) {
    return std::has_single_bit(phase.stance) &&
           model.feet[static_cast<std::size_t>(std::countr_zero(phase.stance))].has_sole();
  });
}

/// Finds how the body is carried over its feet. The ZMP on one sole runs a little inward of its middle, and
/// twice as far where joints come past their limits otherwise, as ankles and hips do that bend sideways. The centre of
/// mass is at the height asked for, or that of standing and then ever lower while that helps some foot that cannot
/// reach or joints that are past their limits, as knees are that straighten. Where nothing keeps all limits, what has
/// the least excess.
class Carriages {
 public:
  explicit Carriages(const Task& task) : task_(task), zmp_inward_(task.options.pipeline.zmp_inward) {}

  int passes() const { return passes_; }  ///< of the last carriage tried

  Result<Pass> Run() {
    // More than what the passes after the first can mend; such plans are finished only for those who want them.
    constexpr double kHopeless = 0.05, kForever = std::numeric_limits<double>::infinity();
    const double hopeless = task_.options.pipeline.allow_limits ? kForever : kHopeless;
    const double standing = StandingCentreOfMass(task_.model, task_.skeleton.path.pose.front()).z();
    const double asked = task_.options.pipeline.com_height_m, height = asked > 0.0 ? asked : standing;
    Result<Pass> best = At(height).Run(passes_, hopeless);
    if (Excess(best) == 0.0) return best;
    if (!best && best.failure().code != "out_of_reach") return best;
    if (StandsOnOneSole(task_.model, task_.skeleton.schedule)) MoveInward(height, hopeless, best);
    if (asked == 0.0 && Excess(best) > 0.0) Lower(standing, hopeless, best);
    return best;
  }

 private:
  Passes At(double height_m) const { return {task_, {height_m, zmp_inward_}}; }

  double Excess(const Result<Pass>& pass) const {
    return pass ? pass->excess : std::numeric_limits<double>::infinity();
  }

  void MoveInward(double height_m, double hopeless, Result<Pass>& best) {
    const double preferred = zmp_inward_;
    zmp_inward_ = 2.0 * preferred;
    if (!best || preferred == 0.0) return;  // what is out of reach stays so
    Result<Pass> inward = At(height_m).Run(passes_, hopeless);
    if (Excess(inward) < Excess(best)) {
      best = std::move(inward);
    } else {
      zmp_inward_ = preferred;
    }
  }

  void Lower(double standing, double hopeless, Result<Pass>& best) {
    constexpr double kStep = 0.02, kLowest = 0.8;  // of the standing height
    constexpr int kPatience = 2;                   // heights without gain
    // What is out of reach at the lowest is so at all heights.
    if (!best && !At(kLowest * standing).RunOnce()) return;
    double least = Excess(best), gain = std::numeric_limits<double>::infinity();
    int without_gain = 0;
    for (double share = 1.0 - kStep; share >= kLowest && least > 0.0 && without_gain < kPatience; share -= kStep) {
      // Lowering helps less and less.
      const double steps_left = std::round((share - kLowest) / kStep) + 1.0;
      if (least - gain * steps_left > (least > hopeless ? hopeless : 0.0)) break;
      Result<Pass> lower = At(share * standing).Run(passes_, hopeless);
      const double excess = Excess(lower);
      without_gain = excess < least || !lower ? 0 : without_gain + 1;
      gain = !lower ? gain : std::max(0.0, least - excess);
      if (excess >= least) continue;
      best = std::move(lower);
      least = excess;
    }
  }

  const Task& task_;
  int passes_ = 0;
  double zmp_inward_;
};

/// With preview control the plan stands one preview longer at both ends, so that it starts and ends at rest.
FootstepOptions StandingOptions(const MotionOptions& options) {
  FootstepOptions footsteps = options.footsteps;
  footsteps.grid_s = options.pipeline.grid_step_s;
  if (options.centre_of_mass.method == "preview") {
    footsteps.initial_stand_s += options.centre_of_mass.preview_s;
    footsteps.final_stand_s += options.centre_of_mass.preview_s;
  }
  return footsteps;
}

Provenance MakeProvenance(MotionOptions options) {
  Provenance provenance{Version(), "PlanMotion", {}, 0};
  for (const OptionField& field : options.Fields()) provenance.options.emplace_back(field.key, OptionText(field));
  return provenance;
}

}  // namespace

Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                 const WalkCommand& command, const MotionOptions& options) {
  MotionOptions checked = options;
  CheckOptions(checked.Fields());
  Result<FootstepSkeleton> skeleton = PlanFootsteps(model, terrain, gait, command, StandingOptions(options));
  if (!skeleton) return skeleton.failure();
  PlannedMotion planned;
  const BodyPath body(model, *skeleton, gait.cycle_s);
  const Task task{model, terrain, *skeleton, options, body};
  Carriages carriages(task);
  Result<Pass> pass = carriages.Run();
  planned.passes = carriages.passes();
  if (!pass) return pass.failure();
  if (auto tipped = TippedSole(model, terrain, pass->solution.trajectory)) return *tipped;
  MotionPlan& plan = planned.plan;
  plan.robot = model.name;
  plan.robot_hash = model.hash;
  plan.urdf_text = model.urdf_text;
  plan.yaml_text = model.yaml_text;
  plan.meshes = model.meshes;
  plan.provenance = MakeProvenance(options);
  plan.command = command;
  plan.goal = skeleton->goal;
  plan.terrain = terrain;
  plan.gait = gait;
  plan.schedule = skeleton->schedule;
  plan.footsteps = std::move(pass->footsteps);
  plan.centroidal = std::move(pass->centroidal);
  plan.swings = std::move(pass->swings);
  plan.whole_body = std::move(pass->solution.trajectory);
  plan.warnings = skeleton->warnings;
  planned.limit_excess = pass->excess;
  const auto limits = LimitWarnings(model, plan.whole_body);
  plan.warnings.insert(plan.warnings.end(), limits.begin(), limits.end());
  planned.zmp_error_max_m = pass->error_m;
  planned.summary =
      fmt::format("{:.2f} s, {} footholds, {} passes, multibody ZMP within {:.1f} mm of its reference",
                  plan.duration_s(), plan.footsteps.footholds.size(), planned.passes, 1e3 * pass->error_m);
  return planned;
}

}  // namespace gaitwright
