// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/gait_timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "optimisation/centroidal/gait_phases.h"
#include "optimisation/centroidal/optimise_timing.h"
#include "optimisation/pipeline/compare_motions.h"
#include "optimisation/pipeline/dynamic_motion.h"
#include "optimisation/pipeline/gait_cycle.h"
#include "optimisation/pipeline/walk_problem.h"
#include "optimisation/whole_body/body_path.h"
#include "planning/footsteps/plan_sequence.h"

namespace gaitwright {
namespace {

constexpr double kLeastSwing = 0.7;  // share of a swing's time: legs have mass, which OptimiseTiming ignores

/// The gait of one part with optimised times.
struct TimedGait {
  Gait gait;
  double cost_before, cost;
  int solves;
};

Failure NoTimes(const std::string& why) {
  return {FailureKind::kInfeasible, FailureCode::kNoTiming, "OptimiseGaits", why, {"timing=fixed"}};
}

/// On level ground, a walk straight forward is shortened to the length needed to optimise its cycles.
std::vector<WalkPart> Shortened(const Terrain& terrain, std::vector<WalkPart> parts) {
  constexpr double kCycles = 6.0;
  if (parts.size() > 1 || KindOfGround(terrain) != GroundKind::kFlat) return parts;
  WalkCommand& command = parts.front().command;
  const bool straight = command.lateral_speed_m_s == 0.0 && command.yaw_rate_rad_s == 0.0 && command.speed_m_s > 0.0;
  if (command.extent == WalkCommand::Extent::kDistance && straight)
    command.distance_m = std::min(command.distance_m, kCycles * command.speed_m_s * parts.front().gait.cycle_s);
  return parts;
}

Result<TimedGait> OptimiseGait(const RobotModel& model, const Terrain& terrain, const std::vector<WalkPart>& whole,
                               std::size_t part, const MotionOptions& options) {
  const std::vector<WalkPart> parts = Shortened(terrain, whole);
  const Result<FootstepSkeleton> skeleton = PlanSequence(model, terrain, parts, StandingOptions(options));
  if (!skeleton) return skeleton.failure();
  const double cycle_s = parts[part].gait.cycle_s;
  const BodyPath path(model, *skeleton, cycle_s);
  // If no posture is fast enough for the flights, shorter flights are searched without a crouch.
  const Result<std::optional<Crouch>> found = CrouchFor(model, skeleton->schedule, options.pipeline.com_height_m);
  const Crouch* crouch = found && *found ? &**found : nullptr;
  const MotionTask task{crouch != nullptr ? crouch->model : model, terrain, *skeleton, options, path, cycle_s};
  const FlightSwings shapes(task.model, skeleton->schedule, options.swing);
  const RigidBodyProblem problem = WalkProblem(task, CarriedBody(task.model, crouch), crouch, shapes);
  std::optional<CycleTies> tied = TiesOf(*skeleton, part, SwitchTimes(problem), options.pipeline.grid_step_s);
  if (!tied) return NoTimes(fmt::format("contacts of gait '{}' do not follow its cycle", parts[part].gait.name));
  const TimingOptions& timing = options.timing_bounds;
  const VectorX& given_s = tied->ties.parts_s;
  tied->ties.shortest_s = given_s.cwiseMin(timing.shortest_s);
  RigidBodyOptions planning = WalkOptions(task, problem);
  planning.method = "interior-point";
  planning.grid_s = 0.0;
  Result<TimedPlan> timed = OptimiseTiming(problem, planning, timing, nullptr, &tied->ties);
  if (!timed) return timed.failure();
  const double share = tied->cycle.ShareKeepingSwings(timed->parts_s, timing.shortest_swing_s, kLeastSwing);
  if (share == 0.0) return TimedGait{parts[part].gait, timed->first_cost, timed->first_cost, timed->solves};
  if (share < 1.0) {
    const VectorX nearer_s = given_s + share * (timed->parts_s - given_s);
    tied->ties.shortest_s = given_s.cwiseMin(nearer_s);
    const int solves = timed->solves;
    timed = OptimiseTiming(problem, planning, timing, nullptr, &tied->ties);
    if (!timed) return timed.failure();
    timed->solves += solves;
  }
  return TimedGait{tied->cycle.With(timed->parts_s), timed->first_cost, timed->plan.summary.cost, timed->solves};
}

double MeanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Interpolates between two similar gaits with different times: share 0 is the first, 1 the second.
Gait Between(const Gait& from, const Gait& to, double share) {
  Gait gait = to;
  for (std::size_t i = 0; i < gait.phase.size(); ++i) {
    gait.duty_factor[i] = from.duty_factor[i] + share * (to.duty_factor[i] - from.duty_factor[i]);
    const double change = to.phase[i] - from.phase[i];
    const double phase = from.phase[i] + share * (change - std::round(change));
    gait.phase[i] = phase - std::floor(phase);
  }
  return gait;
}

std::vector<WalkPart> Between(const std::vector<WalkPart>& from, const std::vector<WalkPart>& to, double share) {
  std::vector<WalkPart> between = to;
  for (std::size_t k = 0; k < to.size(); ++k) between[k].gait = Between(from[k].gait, to[k].gait, share);
  return between;
}

MotionFigures FiguresOf(const RobotModel& model, const PlannedMotion& planned) {
  return {planned.limit_violation, planned.residual, TorqueUseOf(model, planned.plan.whole_body)};
}

/// Adds adjustments for the changed times. The reason is that the plan with the gaits' own times is refused, or costs
/// more.
void ReportTimes(const std::vector<WalkPart>& from, const std::vector<WalkPart>& to, FailureCode why,
                 MotionPlan& plan) {
  for (std::size_t k = 0; k < to.size(); ++k) {
    if (to[k].gait == from[k].gait) continue;
    const std::string part = to.size() > 1 ? fmt::format("{}: {}", k + 1, to[k].gait.name) : "";
    plan.adjustments.push_back(
        {"gait.duty_factor", MeanOf(from[k].gait.duty_factor), MeanOf(to[k].gait.duty_factor), "1", why, part});
  }
}

}  // namespace

Result<TimedGaits> OptimiseGaits(const RobotModel& model, const Terrain& terrain, const std::vector<WalkPart>& parts,
                                 const MotionOptions& options) {
  TimedGaits timed;
  timed.parts = parts;
  std::optional<Failure> refusal;
  int optimised = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (StandsStill(parts[k].gait) || !IsDynamic(parts[k].gait, options.centre_of_mass)) continue;
    const Result<TimedGait> gait = OptimiseGait(model, terrain, timed.parts, k, options);
    if (!gait) {
      refusal = gait.failure();
      continue;
    }
    ++optimised;
    timed.parts[k].gait = gait->gait;
    timed.cost_before += gait->cost_before;
    timed.cost += gait->cost;
    timed.solves += gait->solves;
  }
  if (optimised > 0) return timed;
  return refusal ? *refusal : NoTimes("no gait is planned as the motion of a rigid body");
}

Result<PlannedMotion> PlanAtBestTimes(const RobotModel& model, const Terrain& terrain,
                                      const std::vector<WalkPart>& parts, const MotionOptions& options) {
  MotionOptions at_fixed = options;
  at_fixed.timing = "fixed";
  Result<PlannedMotion> best = PlanMotion(model, terrain, parts, at_fixed);
  const FailureCode why = !best                         ? best.failure().code
                          : best->limit_violation > 0.0 ? FailureCode::kLimits
                                                        : FailureCode::kTorque;
  std::optional<MotionFigures> former;
  if (best) former = FiguresOf(model, *best);
  const Result<TimedGaits> timed = OptimiseGaits(model, terrain, parts, options);
  for (const double share : {1.0, 0.5}) {
    if (!timed || timed->parts == parts) break;
    const std::vector<WalkPart> other = Between(parts, timed->parts, share);
    Result<PlannedMotion> planned = PlanMotion(model, terrain, other, at_fixed);
    if (!planned || !IsBetterMotion(FiguresOf(model, *planned), former, options.trajectory.residual)) continue;
    best = std::move(planned);
    ReportTimes(parts, other, why, best->plan);
    break;
  }
  if (best) best->plan.provenance = ProvenanceOf(options);
  return best;
}

}  // namespace gaitwright
