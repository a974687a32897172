// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "optimisation/search/audited_plan.h"
#include "optimisation/search/plan_turn_internal.h"
#include "optimisation/search/refuse_walk.h"

namespace gaitwright {
namespace {

/// Variation of a turn: factors of its travel and of the time in which feet swing.
struct TurnVariation {
  double travel = 1.0, swing = 1.0;
};

/// A flip fails by too little room between feet that land, or by feet that swing too fast: more of either, one by one.
constexpr std::array<TurnVariation, 3> kTurnVariations = {{{}, {1.2, 1.0}, {1.0, 1.04}}};

/// One cycle of a gait to its own travel.
WalkCommand TurnCommand(const Gait& gait, const std::array<double, 2>& travel_m) {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kGoal;
  command.goal_x_m = travel_m[0];
  command.goal_y_m = travel_m[1];
  command.steps = gait.num_feet();
  return command;
}

/// Whether a request gives no distance, goal or number of steps of its own, so that the gait determines them.
bool LeavesExtentToGait(const WalkCommand& command) {
  WalkCommand without;
  without.distance_m = command.distance_m == 1.0 ? 1.0 : without.distance_m;  // the default of a request
  return command == without;
}

}  // namespace

Result<PlannedWalk> PlanTurn(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                             SearchTrace* trace) {
  const Result<Gait> gait = FindGait(model, request.gait, 0.0, request.gait_options);
  if (!gait) return gait.failure();
  const Result<std::optional<std::array<double, 2>>> travel_m = OwnTravel(model, request.gait);
  if (!travel_m) return travel_m.failure();
  if (!LeavesExtentToGait(request.command)) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kCommand,
                   "PlanWalk",
                   fmt::format("gait '{}' turns the body over once and travels by ({:.2f}, {:.2f}) m; it takes no "
                               "speed, distance, goal or steps",
                               gait->name, (**travel_m)[0], (**travel_m)[1]),
                   {}};
  }
  std::optional<Result<PlannedWalk>> first;
  for (const TurnVariation& variation : kTurnVariations) {
    Gait varied = *gait;
    for (double& duty : varied.duty_factor) duty = 1.0 - variation.swing * (1.0 - duty);
    const WalkCommand command =
        TurnCommand(varied, {variation.travel * (**travel_m)[0], variation.travel * (**travel_m)[1]});
    Result<PlannedWalk> planned =
        Audited(model, PlanMotion(model, terrain, varied, command, request.motion), request.motion);
    const bool sound = IsSound(planned);
    if (trace != nullptr) {
      trace->push_back({Effort::kWhole, "distance", variation.travel * std::hypot((**travel_m)[0], (**travel_m)[1]),
                        "m", varied.cycle_s, sound ? std::nullopt : std::optional(ReasonRefused(planned)), false,
                        true});
    }
    if (RoomOf(planned) >= Room::kAsSolved) return planned;
    if (request.motion.pipeline.allow_limits && planned) return planned;
    if (!first || (!IsSound(*first) && sound)) first = std::move(planned);
  }
  if (*first && !IsSound(*first)) return ReasonForbidden(**first);
  return std::move(*first);
}

}  // namespace gaitwright
