// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/plan_within.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "optimisation/pipeline/dynamic_motion.h"
#include "optimisation/search/audited_plan.h"
#include "optimisation/search/pace.h"
#include "optimisation/search/refuse_walk.h"
#include "optimisation/search/sound_search.h"
#include "optimisation/search/walk_evaluator.h"
#include "planning/footsteps/course.h"
#include "planning/footsteps/plan_footsteps.h"
#include "planning/footsteps/uneven_footsteps.h"

namespace gaitwright {
namespace {

using Extent = WalkCommand::Extent;

/// Whether a walk has no displacement (steps below 1 mm count as none), so that no slower walk exists.
bool IsInPlace(const WalkCommand& c) {
  constexpr double kNoStep = 1e-3;  // [m]
  return c.extent == Extent::kSteps && c.speed_m_s == 0.0 && c.lateral_speed_m_s == 0.0 && c.yaw_rate_rad_s == 0.0 &&
         std::abs(c.step_length_m) < kNoStep;
}

/// Whether the speed is the robot's default, so that it may be lowered.
bool IsOwnPace(const WalkRequest& request) {
  const WalkCommand& c = request.command;
  return request.own_pace ||
         (!IsCounted(c) && c.speed_m_s == 0.0 && c.lateral_speed_m_s == 0.0 && c.yaw_rate_rad_s == 0.0);
}

/// Counted leaps on uneven ground without given flight times. The suitable flight time depends on the height that feet
/// must clear and on the drop of the body.
bool MayVaryFlight(const WalkRequest& request, const Gait& gait, const Terrain& terrain) {
  const bool given = request.gait_options.cycle_s > 0.0 || request.gait_options.duty_factor > 0.0;
  return !given && IsCounted(request.command) && HasFlight(gait) && KindOfGround(terrain) != GroundKind::kFlat;
}

/// Whether soles step forward on level ground, so that heels can rise before.
bool MayRaiseHeels(const RobotModel& model, const WalkCommand& command, const Gait& gait) {
  const Result<Course> course = MakeCourse(model, gait, command, {});
  return course && course->twist.x_m > 0.0 &&
         std::any_of(model.feet.begin(), model.feet.end(), [](const Foot& foot) { return foot.has_sole(); });
}

/// A walk to a goal has a higher smallest speed than other walks, because a plan has a maximum duration.
PaceRange PacesOf(const RobotModel& model, const WalkCommand& command) {
  constexpr int kHalvingsToGoal = 5;  // a thirty-second of the speed
  PaceRange paces{PaceValue(model, command), UnreachablePace(model, PaceOf(command))};
  if (command.extent == Extent::kGoal) paces.halvings = kHalvingsToGoal;
  return paces;
}

/// The search problem of a request whose gait is fitted as `gait`.
SearchProblem ProblemOf(const RobotModel& model, const Terrain& terrain, const WalkRequest& request, const Gait& gait) {
  using Kind = SearchSituation::Kind;
  const auto flies = [&](const Gait& g) { return IsDynamic(g, request.motion.centre_of_mass); };
  const Kind without_flight = KindOfGround(terrain) == GroundKind::kFlat ? Kind::kLevel : Kind::kUneven;
  SearchProblem problem;
  problem.situation.kind = flies(gait) ? Kind::kFlying : without_flight;
  problem.situation.may_slow_down = IsOwnPace(request);
  problem.situation.may_vary_flight = MayVaryFlight(request, gait, terrain);
  problem.situation.may_move_feet = flies(gait) && MayMoveFeet(request.motion, terrain);
  problem.situation.may_raise_heels = MayRaiseHeels(model, request.command, gait);
  problem.paces = PacesOf(model, request.command);
  problem.in_place = IsInPlace(request.command);
  problem.any_plan = request.motion.pipeline.allow_limits;
  const Result<Gait> slow = FindGait(model, request.gait, 0.0, request.gait_options);
  if (slow && !flies(*slow)) problem.grounded = without_flight;
  return problem;
}

/// Differences between a candidate and the requested walk.
std::vector<Adjustment> AdjustmentsOf(const RobotModel& model, const WalkRequest& request,
                                      const WalkEvaluator& evaluator, const Candidate& given, FailureCode why) {
  std::vector<Adjustment> adjustments;
  const Pace pace = PaceOf(request.command);
  const double asked = PaceValue(model, request.command);
  const Result<GaitCycles> cycles = evaluator.CyclesOf(given);
  if (!cycles) return {};
  const Gait gait = evaluator.GaitOf(given, *cycles);
  if (given.pace != asked) adjustments.push_back({PaceFlag(pace), asked, given.pace, PaceUnit(pace), why, {}});
  if (given.cycle != 0) adjustments.push_back({"gait.cycle_s", cycles->fitted.cycle_s, gait.cycle_s, "s", why, {}});
  if (given.flight != Candidate{}.flight) {
    adjustments.push_back(
        {"gait.duty_factor", cycles->fitted.duty_factor.front(), gait.duty_factor.front(), "1", why, {}});
  }
  return adjustments;
}

/// The failure, with the slower walk that is feasible instead, if any.
Failure Refusal(const RobotModel& model, const WalkRequest& request, const std::string& gait, Failure failure,
                const SlowerPace& slower) {
  const WalkCommand& command = request.command;
  const bool at_every_pace =
      failure.code == FailureCode::kLegsTooSlow || failure.code == FailureCode::kLegsTooWeak || IsInPlace(command);
  if (slower.value == 0.0) {
    if (!at_every_pace)
      failure.message += fmt::format("; no {1} of robot '{0}' was found that has a sound plan with gait '{2}'",
                                     model.name, PaceName(PaceOf(command)), gait);
    failure.suggestions.insert(failure.suggestions.begin(),
                               Suggestion("gait", {}, Certainty::kUntried, "another gait"));
    return failure;
  }
  const WalkCommand at_pace = AtPace(model, command, slower.value);
  failure.message += "; " + slower.Text(at_pace, gait);
  failure.suggestions.insert(failure.suggestions.begin(), slower.AsSuggestion(at_pace));
  return failure;
}

}  // namespace

namespace {

/// A plan as PlanWithin makes it. @param slower  whether a refusal names a slower walk that is feasible.
Result<PlannedWalk> PlanFor(const RobotModel& model, const Terrain& terrain, const WalkRequest& request, bool slower,
                            SearchTrace* trace) {
  WalkEvaluator evaluator(model, terrain, request, trace);
  const double asked = PaceValue(model, request.command);
  const Result<GaitCycles> cycles = evaluator.CyclesOf({asked});
  if (!cycles) return cycles.failure();
  const SearchProblem problem = ProblemOf(model, terrain, request, cycles->fitted);
  SearchResult result = FindSound(problem, evaluator);
  Evaluation& found = result.evaluation;
  if (found.sound() || (problem.any_plan && found.planned != nullptr)) {
    if (result.why)
      found.planned->motion.plan.adjustments = AdjustmentsOf(model, request, evaluator, result.candidate, *result.why);
    return std::move(*found.planned);
  }
  if (problem.any_plan || found.at_every_pace || !slower) return *found.refusal;
  return Refusal(model, request, cycles->fitted.name, *found.refusal, SlowerThatIsSound(problem, evaluator));
}

}  // namespace

Result<PlannedWalk> PlanWithin(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                               SearchTrace* trace) {
  return PlanFor(model, terrain, request, true, trace);
}

Result<PlannedWalk> PlanInFewestStrides(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                                        int strides, SearchTrace* trace) {
  constexpr int kNumbers = 5;  // of strides: each takes a search, and more strides rarely help after that
  const WalkCommand& command = request.command;
  const Result<Gait> gait = FindGait(model, request.gait, SpeedOfSteps(model, command), request.gait_options);
  if (!gait) return gait.failure();
  WalkRequest counted = request;
  std::optional<Result<PlannedWalk>> best;
  for (int n = strides; n < strides + kNumbers; ++n) {
    counted.command = CountedInStrides(*gait, n, command);
    const bool last = counted.command == command || request.motion.pipeline.allow_limits;
    Result<PlannedWalk> planned = PlanFor(model, terrain, counted, last, trace);
    const Room room = RoomOf(planned);
    if (last || room == Room::kAmple) return planned;
    if (!planned && planned.failure().kind == FailureKind::kBadInput) return planned;
    if (best && RoomOf(*best) == Room::kAsSolved && room == Room::kAsSolved) break;  // more strides are not easier
    if (!best || RoomOf(*best) < room) best = std::move(planned);
  }
  return std::move(*best);
}

}  // namespace gaitwright
