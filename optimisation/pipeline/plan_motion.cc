// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/plan_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "kinematics/base/version.h"
#include "kinematics/dynamics/dynamics.h"
#include "optimisation/pipeline/body_strategy_search.h"
#include "optimisation/pipeline/crouch.h"
#include "optimisation/pipeline/dynamic_motion.h"
#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/pipeline/gait_timing.h"
#include "optimisation/pipeline/limit_violation.h"
#include "optimisation/pipeline/motion_passes.h"
#include "optimisation/pipeline/options_of_robot_internal.h"
#include "optimisation/pipeline/plan_turning_internal.h"
#include "optimisation/pipeline/rigid_body_passes.h"
#include "optimisation/pipeline/robot_body.h"
#include "optimisation/pipeline/tipped_sole.h"
#include "optimisation/pipeline/turning_leap_internal.h"
#include "optimisation/swing/swing_ground.h"
#include "planning/footsteps/can_walk.h"
#include "planning/plan/robot_of_plan.h"

namespace gaitwright {
namespace {

/// True if the robot stands on a single sole at some time.
bool StandsOnOneSole(const RobotModel& model, const ContactSchedule& schedule) {
  return std::any_of(schedule.phases.begin(), schedule.phases.end(), [&](const ContactPhase& phase) {
    return std::has_single_bit(phase.stance) &&
           model.feet[static_cast<std::size_t>(std::countr_zero(phase.stance))].has_sole();
  });
}

/// The motion of a rigid body, crouched as far as flights need it.
Result<MotionPass> RunDynamic(const MotionTask& task, const std::optional<Crouch>& crouch, int& passes) {
  if (!crouch) return RigidBodyPasses(task).Run(passes);
  const MotionTask crouched{crouch->model, task.terrain, task.skeleton, task.options, task.body, task.cycle_s};
  return RigidBodyPasses(crouched, &*crouch).Run(passes);
}

/// Whether short stances, or short flights near the motors' speed limits, have too few rows of the grid. A grid with
/// half the time step has enough.
bool WantsFinerGrid(const FootstepPlan& footsteps, const std::optional<Crouch>& crouch, double step_s) {
  constexpr double kRows = 20.0, kLeast = 0.002;
  double brief_s = crouch && crouch->flight_s > 0.0 ? crouch->flight_s : std::numeric_limits<double>::infinity();
  for (const Foothold& foothold : footsteps.footholds)
    brief_s = std::min(brief_s, foothold.liftoff_s - foothold.touchdown_s);
  return brief_s < kRows * step_s && step_s >= kLeast;
}

double SlowestCycle(const std::vector<WalkPart>& parts) {
  double longest = 0.0;
  for (const WalkPart& part : parts) {
    if (!StandsStill(part.gait)) longest = std::max(longest, part.gait.cycle_s);
  }
  return longest;
}

}  // namespace

OptionFields TrajectoryOptions::Fields() {
  return WithBasics(
      {"method"},
      {{"method",
        &method,
        "",
        0.0,
        0.0,
        "Planner of the whole body: 'whole-body' optimises its motion and contact forces together; 'as-needed' does so "
        "for rigid-body gaits and infeasible plans of passes.",
        {"as-needed", "whole-body"}},
       {"knot_step_s", &knot_step_s, "s", 0.001, 0.05, "Longest time between knots of the optimisation."},
       {"residual", &residual, "1", 1e-6, 0.02,
        "Largest unbalanced force divided by the weight, and moment divided by the weight times the leg length, "
        "at 1 kHz; solves are repeated until it is reached."},
       {"max_solves", &max_solves, "1", 1, 20, "Maximum number of solves."},
       {"max_iterations", &max_iterations, "1", 1, 1000, "Maximum number of iterations of each solve."},
       {"near", &near, "1", 1e-3, 1e3, "Weight on the distance of base and joints from the plan of the passes."},
       {"effort", &effort, "1", 0.0, 1e3, "Weight on the efforts of motors, as shares of their limits."},
       {"power", &power, "1", 0.0, 1e3,
        "Weight on the power of each motor, as a share of m g sqrt(g l) with leg length l."},
       {"timing",
        &timing,
        "",
        0.0,
        0.0,
        "Contact times of an optimised whole body: 'optimised' makes them variables; the total duration stays.",
        {"fixed", "optimised"}},
       {"most_change", &most_change, "1", 0.01, 1.0,
        "Largest change of the rate of time for timing=optimised: phases become shorter or longer by up to this "
        "share."},
       {"footholds",
        &footholds,
        "",
        0.0,
        0.0,
        "Footholds of an optimised whole body: 'free' moves those on planes together with the motion.",
        {"fixed", "free"}},
       {"most_shift_m", &most_shift_m, "m", 0.001, 1.0,
        "Largest shift along each axis: of a foothold for footholds=free, in its contact frame; of a swing foot for "
        "swings=free."},
       {"swings",
        &swings,
        "",
        0.0,
        0.0,
        "Paths of swing feet of an optimised whole body: 'free' plans them with the motion, 'as-needed' only in "
        "flights "
        "whose motors cannot lift the feet as usual.",
        {"as-needed", "planned", "free"}},
       {"clearance_m", &clearance_m, "m", 0.0, 0.5,
        "Smallest height of feet in mid swing for swings=free; 0: swing.clearance_m, or half of the planned height if "
        "that is 0."},
       {"heel_off_rad", &heel_off_rad, "rad", 0.0, 1.2,
        "Pitch of a sole about its front edge at the lift-off of the longest step; 0: as far as a plan needs it. "
        "Without flight only."},
       {"heel_off_share", &heel_off_share, "1", 0.1, 1.0,
        "Time in which a heel rises before lift-off, as a share of the shortest double support."},
       {"self_distance_m", &self_distance_m, "m", 0.0, 0.1,
        "Distance at knots of links that would touch otherwise; at most half of their distance in the standing "
        "posture. 0: links may touch."},
       {"cycles",
        &cycles,
        "",
        0.0,
        0.0,
        "Steady cycles of a walk: 'periodic' optimises the whole body so that each repeats the one before exactly.",
        {"free", "periodic"}}});
}

OptionFields TrajectoryOptions::FollowFields() {
  OptionFields fields = Fields();
  std::erase_if(fields, [](const OptionField& field) {
    constexpr std::string_view kUsed[] = {"knot_step_s", "residual", "max_solves", "max_iterations", "self_distance_m"};
    return std::ranges::find(kUsed, field.key) == std::end(kUsed);
  });
  return fields;
}

FootstepOptions StandingOptions(const MotionOptions& options) {
  FootstepOptions footsteps = options.footsteps;
  footsteps.grid_s = options.pipeline.grid_step_s;
  if (options.trajectory.finishes_all()) footsteps.search.heel_off_rad = options.trajectory.heel_off_rad;
  if (options.centre_of_mass.method == "preview") footsteps.settling_s = options.centre_of_mass.preview_s;
  return footsteps;
}

Provenance ProvenanceOf(MotionOptions options) {
  Provenance provenance{Version(), "PlanMotion", {}, 0};
  for (const OptionField& field : options.Fields()) provenance.options.emplace_back(field.key, OptionText(field));
  return provenance;
}

Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                 const WalkCommand& command, const MotionOptions& options) {
  return PlanMotion(model, terrain, {{gait, command}}, options);
}

namespace {

/// Warns of options for rigid-body motions that have no effect because the motion is planned with the pendulum.
void WarnOfIdleOptions(const MotionOptions& options, std::vector<std::string>& warnings) {
  const auto warn = [&](const char* key, const std::string& value) {
    warnings.push_back(
        fmt::format("{}={} has no effect: this gait has no flight and is planned with the pendulum model; "
                    "set centre_of_mass.method=rigid-body to use it",
                    key, value));
  };
  if (options.timing != MotionOptions().timing) warn("timing", options.timing);
  if (options.footholds == "free") warn("footholds", options.footholds);
}

/// The plan of a pass.
PlannedMotion PlannedBy(const MotionTask& task, MotionPass pass, bool dynamic, int passes) {
  PlannedMotion planned;
  planned.passes = passes;
  MotionPlan& plan = planned.plan;
  SetRobot(task.model, plan);
  plan.provenance = ProvenanceOf(task.options);
  plan.parts = task.skeleton.parts;
  plan.goal = task.skeleton.goal;
  plan.terrain = task.terrain;
  plan.schedule = task.skeleton.schedule;
  plan.footsteps = std::move(pass.footsteps);
  plan.centroidal = std::move(pass.centroidal);
  plan.swings = std::move(pass.swings);
  plan.whole_body = std::move(pass.solution.trajectory);
  plan.warnings = task.skeleton.warnings;
  if (!dynamic) WarnOfIdleOptions(task.options, plan.warnings);
  planned.limit_violation = TotalViolation(task.model, plan.whole_body, 0.0);
  const auto limits = LimitWarnings(task.model, plan.whole_body);
  plan.warnings.insert(plan.warnings.end(), limits.begin(), limits.end());
  const std::string left = dynamic ? fmt::format("contact forces leave at most {:.1e} m g unbalanced", pass.error_m)
                                   : fmt::format("multibody ZMP within {:.1f} mm of its reference", 1e3 * pass.error_m);
  (dynamic ? planned.residual : planned.zmp_error_max_m) = pass.error_m;
  planned.summary = fmt::format("{:.2f} s, {} footholds, {} passes, {}", plan.duration_s(),
                                plan.footsteps.footholds.size(), planned.passes, left);
  return planned;
}

Result<PlannedMotion> PlanDynamic(const MotionTask& task, const std::optional<Crouch>& crouch) {
  int passes = 0;
  Result<MotionPass> pass = RunDynamic(task, crouch, passes);
  if (!pass) return pass.failure();
  if (auto tipped = TippedSole(task.model, task.terrain, pass->solution.trajectory)) return *tipped;
  PlannedMotion planned = PlannedBy(task, std::move(*pass), true, passes);
  FinishPlanned(task.model, task.options, planned);
  return planned;
}

/// Plans a motion in which the body turns over: the optimisation of the whole body from a first guess.
Result<PlannedMotion> PlanTurning(const MotionTask& task) {
  Result<MotionPass> pass = GuessTurn(task);
  if (!pass) return pass.failure();
  pass->error_m = 0.0;
  PlannedMotion planned = PlannedBy(task, std::move(*pass), true, 1);
  MotionOptions options = task.options;
  options.trajectory = TurningOptions(options.trajectory);
  FinishPlanned(task.model, options, planned);
  if (planned.unfinished) return *planned.unfinished;
  FitSwings(task.model, planned.plan);
  return planned;
}

/// Plans by passes of the pendulum with the best body posture that is found. With trajectory.method=whole-body a motion
/// is finished by the whole body; if it violates limits even then, other postures are tried.
class PendulumPlan {
 public:
  explicit PendulumPlan(const MotionTask& task) : task_(task) {}

  Result<PlannedMotion> Run() {
    Result<MotionPass> pass = FindBodyStrategy(Problem(), Trials());
    if (!pass) return pass.failure();
    const bool is_tried = pass->violation == tried_violation_;
    if (is_tried && tried_ && !tried_->unfinished) return std::move(*tried_);
    PlannedMotion planned = PlannedBy(task_, std::move(*pass), false, passes_);
    if (is_tried && tried_)
      planned.unfinished = tried_->unfinished;
    else if (finishes_)
      FinishPlanned(task_.model, task_.options, planned);
    if (auto tipped = TippedSole(task_.model, task_.terrain, planned.plan.whole_body)) return *tipped;
    return planned;
  }

 private:
  BodyStrategyProblem Problem() const {
    return {StandingCentreOfMass(task_.model).z(),
            task_.options.pipeline.com_height_m,
            task_.options.pipeline.zmp_inward,
            KindOfGround(task_.terrain) > GroundKind::kLevel,
            StandsOnOneSole(task_.model, task_.skeleton.schedule),
            task_.options.pipeline.allow_limits};
  }

  BodyStrategyTrials Trials() {
    return {[this](const BodyStrategy& strategy, double infeasible) {
              return MotionPasses(task_, strategy).Run(passes_, infeasible);
            },
            [this](const BodyStrategy& strategy) { return MotionPasses(task_, strategy).RunOnce().ok(); },
            [this](const MotionPass& pass) { return Mends(pass); }};
  }

  /// Whether the whole body finishes a motion within its limits.
  bool Mends(const MotionPass& pass) {
    if (!finishes_) return false;
    tried_ = PlannedBy(task_, pass, false, passes_);
    tried_violation_ = pass.violation;
    FinishPlanned(task_.model, task_.options, *tried_);
    return tried_->finished && tried_->limit_violation < kSlightViolation;
  }

  const MotionTask& task_;
  // Passes let soles without an ankle roll joint tilt.
  const bool finishes_ = task_.options.trajectory.finishes_all() || HasTiltingSole(task_.model);
  int passes_ = 0;
  std::optional<PlannedMotion> tried_;  // by Mends
  double tried_violation_ = -1.0;       // of the motion that was tried
};

/// Plans a motion over fixed footsteps, by passes of the pendulum or of the rigid body.
Result<PlannedMotion> PlanOver(const MotionTask& task, bool dynamic, const std::optional<Crouch>& crouch) {
  return dynamic ? PlanDynamic(task, crouch) : PendulumPlan(task).Run();
}

/// The crouch for a schedule; nothing for a pendulum's motion.
Result<std::optional<Crouch>> CrouchOf(const RobotModel& model, const ContactSchedule& schedule,
                                       const MotionOptions& options) {
  if (!IsDynamic(schedule, options.centre_of_mass)) return std::optional<Crouch>{};
  return CrouchFor(model, schedule, options.pipeline.com_height_m);
}

/// With periodic cycles, cycles of whole steps of the grid: contact times are rounded to it.
std::vector<WalkPart> OnGrid(std::vector<WalkPart> parts, const MotionOptions& options) {
  const double step_s = options.pipeline.grid_step_s;
  for (WalkPart& part : parts) {
    if (options.trajectory.cycles == "periodic")
      part.gait.cycle_s = step_s * std::max(1.0, std::round(part.gait.cycle_s / step_s));
  }
  return parts;
}

}  // namespace

Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const std::vector<WalkPart>& given,
                                 const MotionOptions& asked) {
  MotionOptions checked = asked;
  CheckOptions(checked.Fields());
  const std::vector<WalkPart> parts = OnGrid(given, asked);
  const bool stands = std::any_of(parts.begin(), parts.end(), [](const WalkPart& p) { return StandsStill(p.gait); });
  if (std::optional<Failure> falls = ReasonCannotStand(model); falls && stands) return *falls;
  const MotionOptions options = OptionsOf(model, asked);
  FootstepOptions footsteps = StandingOptions(options);
  if (TurnsOver(parts)) footsteps.settling_s = std::max(footsteps.settling_s, StandingForTurn(model));
  Result<FootstepSkeleton> skeleton = PlanSequence(model, terrain, parts, footsteps);
  if (!skeleton) return skeleton.failure();
  const double cycle_s = SlowestCycle(parts);
  const BodyPath body(model, *skeleton, cycle_s);
  const bool dynamic = IsDynamic(skeleton->schedule, options.centre_of_mass);
  if (dynamic && !TurnsOver(parts) && options.timing == "optimised")
    return PlanAtBestTimes(model, terrain, parts, options);
  const Result<std::optional<Crouch>> crouch = CrouchOf(model, skeleton->schedule, options);
  if (!crouch) return crouch.failure();
  if (TurnsOver(parts)) return PlanTurning({model, terrain, *skeleton, options, body, cycle_s});
  if (dynamic && WantsFinerGrid(skeleton->footsteps, *crouch, options.pipeline.grid_step_s)) {
    checked.pipeline.grid_step_s *= 0.5;
    return PlanMotion(model, terrain, parts, checked);
  }
  return PlanOver({model, terrain, *skeleton, options, body, cycle_s}, dynamic, *crouch);
}

Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const FootstepSkeleton& skeleton,
                                 double cycle_s, const MotionOptions& asked) {
  MotionOptions checked = asked;
  CheckOptions(checked.Fields());
  const MotionOptions options = OptionsOf(model, asked);
  const BodyPath body(model, skeleton, cycle_s);
  const Result<std::optional<Crouch>> crouch = CrouchOf(model, skeleton.schedule, options);
  if (!crouch) return crouch.failure();
  return PlanOver({model, terrain, skeleton, options, body, cycle_s},
                  IsDynamic(skeleton.schedule, options.centre_of_mass), *crouch);
}

}  // namespace gaitwright
