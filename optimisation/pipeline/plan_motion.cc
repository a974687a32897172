// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/plan_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "kinematics/base/version.h"
#include "kinematics/dynamics/dynamics.h"
#include "optimisation/pipeline/crouch.h"
#include "optimisation/pipeline/dynamic_motion.h"
#include "optimisation/pipeline/limit_excess.h"
#include "optimisation/pipeline/motion_passes.h"
#include "optimisation/pipeline/rigid_body_passes.h"
#include "optimisation/pipeline/robot_body.h"
#include "optimisation/pipeline/tipped_sole.h"
#include "optimisation/swing/swing_ground.h"
#include "planning/plan/robot_of_plan.h"

namespace gaitwright {
namespace {

/// True where the robot stands on one sole alone for a while.
bool StandsOnOneSole(const RobotModel& model, const ContactSchedule& schedule) {
  return std::any_of(schedule.phases.begin(), schedule.phases.end(), [&](const ContactPhase& phase) {
    return std::has_single_bit(phase.stance) &&
           model.feet[static_cast<std::size_t>(std::countr_zero(phase.stance))].has_sole();
  });
}

/// Finds how the body is carried over its feet. The ZMP on one sole runs a little inward of its middle, and
/// twice as far where joints come past their limits otherwise, as ankles and hips do that bend sideways. The centre of
/// mass is at the height asked for, or that of standing. Over ground that is not level it is higher or lower for a
/// while where legs do not reach otherwise, and a body on single soles leans forward where that is not enough, which
/// bends a hip less that is behind. Last, it is ever lower while that helps some foot that cannot reach or joints that
/// are past their limits, as knees are that straighten. Where nothing keeps all limits, what has the least excess.
class Carriages {
 public:
  explicit Carriages(const MotionTask& task) : task_(task), zmp_inward_(task.options.pipeline.zmp_inward) {}

  int passes() const { return passes_; }  ///< of the last carriage tried

  Result<MotionPass> Run() {
    // More than what the passes after the first can mend; such plans are finished only for those who want them.
    constexpr double kHopeless = 0.05, kForever = std::numeric_limits<double>::infinity();
    const double hopeless = task_.options.pipeline.allow_limits ? kForever : kHopeless;
    const double standing = StandingCentreOfMass(task_.model).z();
    const double asked = task_.options.pipeline.com_height_m, height = asked > 0.0 ? asked : standing;
    Result<MotionPass> best = At(height).Run(passes_, hopeless);
    if (Excess(best) == 0.0) return best;
    if (!best && best.failure().code != FailureCode::kOutOfReach) return best;
    if (!IsLevelAndBare(task_.terrain)) KeepInReach(height, hopeless, best);
    if (Excess(best) > 0.0 && StandsOnOneSole(task_.model, task_.skeleton.schedule)) MoveInward(height, hopeless, best);
    if (asked == 0.0 && Excess(best) > 0.0) Lower(standing, hopeless, best);
    return best;
  }

 private:
  static constexpr double kLean = 0.1;  // [rad]

  MotionPasses At(double height_m) const { return {task_, {height_m, zmp_inward_, in_reach_, lean_rad_}}; }

  double Excess(const Result<MotionPass>& pass) const {
    return pass ? pass->excess : std::numeric_limits<double>::infinity();
  }

  void KeepInReach(double height_m, double hopeless, Result<MotionPass>& best) {
    in_reach_ = true;
    const bool helps = Take(At(height_m).Run(passes_, hopeless), best);
    if (Excess(best) > 0.0 && StandsOnOneSole(task_.model, task_.skeleton.schedule)) {
      lean_rad_ = kLean;
      if (Take(At(height_m).Run(passes_, hopeless), best)) return;
      lean_rad_ = 0.0;
    }
    in_reach_ = helps;
  }

  /// Takes what has less excess.
  bool Take(Result<MotionPass> other, Result<MotionPass>& best) const {
    if (Excess(other) >= Excess(best)) return false;
    best = std::move(other);
    return true;
  }

  void MoveInward(double height_m, double hopeless, Result<MotionPass>& best) {
    const double preferred = zmp_inward_;
    zmp_inward_ = 2.0 * preferred;
    if (!best || preferred == 0.0) return;  // what is out of reach stays so
    if (!Take(At(height_m).Run(passes_, hopeless), best)) zmp_inward_ = preferred;
  }

  void Lower(double standing, double hopeless, Result<MotionPass>& best) {
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
      Result<MotionPass> lower = At(share * standing).Run(passes_, hopeless);
      const double excess = Excess(lower);
      without_gain = excess < least || !lower ? 0 : without_gain + 1;
      gain = !lower ? gain : std::max(0.0, least - excess);
      if (excess >= least) continue;
      best = std::move(lower);
      least = excess;
    }
  }

  const MotionTask& task_;
  int passes_ = 0;
  double zmp_inward_;
  bool in_reach_ = false;
  double lean_rad_ = 0.0;
};

/// With preview control the plan stands one preview longer at both ends, so that it starts and ends at rest.
FootstepOptions StandingOptions(const MotionOptions& options) {
  FootstepOptions footsteps = options.footsteps;
  footsteps.grid_s = options.pipeline.grid_step_s;
  if (options.centre_of_mass.method == "preview") footsteps.settling_s = options.centre_of_mass.preview_s;
  return footsteps;
}

/// The motion of a rigid body on legs, crouched as far as flights need it.
Result<MotionPass> RunDynamic(const MotionTask& task, const std::optional<Crouch>& crouch, int& passes) {
  if (!crouch) return RigidBodyPasses(task).Run(passes);
  const MotionTask crouched{crouch->model, task.terrain, task.skeleton, task.options, task.body, task.cycle_s};
  return RigidBodyPasses(crouched, &*crouch).Run(passes);
}

/// Whether brief stances, or brief flights near the motors' greatest speed, have too few rows of the grid, as may be
/// had with half as far between them.
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

Provenance MakeProvenance(MotionOptions options) {
  Provenance provenance{Version(), "PlanMotion", {}, 0};
  for (const OptionField& field : options.Fields()) provenance.options.emplace_back(field.key, OptionText(field));
  return provenance;
}

}  // namespace

Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                 const WalkCommand& command, const MotionOptions& options) {
  return PlanMotion(model, terrain, {{gait, command}}, options);
}

namespace {

/// The plan of a motion over what is settled, by a pendulum's passes or those of a rigid body.
Result<PlannedMotion> PlanOver(const MotionTask& task, bool dynamic, const std::optional<Crouch>& crouch) {
  PlannedMotion planned;
  Result<MotionPass> pass = MotionPass{};
  if (dynamic) {
    pass = RunDynamic(task, crouch, planned.passes);
  } else {
    Carriages carriages(task);
    pass = carriages.Run();
    planned.passes = carriages.passes();
  }
  if (!pass) return pass.failure();
  const RobotModel& model = task.model;
  if (auto tipped = TippedSole(model, task.terrain, pass->solution.trajectory)) return *tipped;
  MotionPlan& plan = planned.plan;
  SetRobot(model, plan);
  plan.provenance = MakeProvenance(task.options);
  plan.parts = task.skeleton.parts;
  plan.goal = task.skeleton.goal;
  plan.terrain = task.terrain;
  plan.schedule = task.skeleton.schedule;
  plan.footsteps = std::move(pass->footsteps);
  plan.centroidal = std::move(pass->centroidal);
  plan.swings = std::move(pass->swings);
  plan.whole_body = std::move(pass->solution.trajectory);
  plan.warnings = task.skeleton.warnings;
  planned.limit_excess = TotalExcess(model, plan.whole_body, 0.0);
  const auto limits = LimitWarnings(model, plan.whole_body);
  plan.warnings.insert(plan.warnings.end(), limits.begin(), limits.end());
  const std::string left = dynamic
                               ? fmt::format("contacts give all of the motion but {:.1e} m g", pass->error_m)
                               : fmt::format("multibody ZMP within {:.1f} mm of its reference", 1e3 * pass->error_m);
  (dynamic ? planned.residual : planned.zmp_error_max_m) = pass->error_m;
  planned.summary = fmt::format("{:.2f} s, {} footholds, {} passes, {}", plan.duration_s(),
                                plan.footsteps.footholds.size(), planned.passes, left);
  return planned;
}

/// How low a body crouches for a schedule; nothing for a pendulum's motion.
Result<std::optional<Crouch>> CrouchOf(const RobotModel& model, const ContactSchedule& schedule,
                                       const MotionOptions& options) {
  if (!IsDynamic(schedule, options.centre_of_mass)) return std::optional<Crouch>{};
  return CrouchFor(model, schedule, options.pipeline.com_height_m);
}

}  // namespace

Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const std::vector<WalkPart>& parts,
                                 const MotionOptions& options) {
  MotionOptions checked = options;
  CheckOptions(checked.Fields());
  Result<FootstepSkeleton> skeleton = PlanSequence(model, terrain, parts, StandingOptions(options));
  if (!skeleton) return skeleton.failure();
  const double cycle_s = SlowestCycle(parts);
  const BodyPath body(model, *skeleton, cycle_s);
  const bool dynamic = IsDynamic(skeleton->schedule, options.centre_of_mass);
  const Result<std::optional<Crouch>> crouch = CrouchOf(model, skeleton->schedule, options);
  if (!crouch) return crouch.failure();
  if (dynamic && WantsFinerGrid(skeleton->footsteps, *crouch, options.pipeline.grid_step_s)) {
    checked.pipeline.grid_step_s *= 0.5;
    return PlanMotion(model, terrain, parts, checked);
  }
  return PlanOver({model, terrain, *skeleton, options, body, cycle_s}, dynamic, *crouch);
}

Result<PlannedMotion> PlanMotion(const RobotModel& model, const Terrain& terrain, const FootstepSkeleton& skeleton,
                                 double cycle_s, const MotionOptions& options) {
  MotionOptions checked = options;
  CheckOptions(checked.Fields());
  const BodyPath body(model, skeleton, cycle_s);
  const Result<std::optional<Crouch>> crouch = CrouchOf(model, skeleton.schedule, options);
  if (!crouch) return crouch.failure();
  return PlanOver({model, terrain, skeleton, options, body, cycle_s},
                  IsDynamic(skeleton.schedule, options.centre_of_mass), *crouch);
}

}  // namespace gaitwright
