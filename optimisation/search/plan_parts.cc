// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/plan_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "optimisation/pipeline/dynamic_motion.h"
#include "optimisation/search/audited_plan.h"
#include "optimisation/search/plan_within.h"
#include "optimisation/search/refuse_walk.h"

namespace gaitwright {
namespace {

Result<std::vector<WalkPart>> Fitted(const RobotModel& model, const WalkRequest& request,
                                     const std::vector<AskedPart>& asked) {
  std::vector<WalkPart> parts;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const AskedPart& part = asked[k];
    if (part.stands()) {
      parts.push_back({StandingGait(static_cast<int>(model.feet.size())), part.command});
      continue;
    }
    const Result<Gait> gait = FindGait(model, part.gait, SpeedOfSteps(model, part.command), request.gait_options);
    if (!gait) return OfPart(k, part.gait, gait.failure());
    parts.push_back({*gait, part.command});
  }
  return parts;
}

struct ServingParts {
  std::vector<WalkPart> parts;
  std::vector<Adjustment> adjustments;
  bool finishes = false;  // the whole body is optimised for any of them
};

/// The parts, each with the cycle for which it alone has a sound plan; the failure of the first part without one.
Result<ServingParts> ServingAlone(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                                  const std::vector<AskedPart>& asked, std::vector<WalkPart> parts,
                                  SearchTrace* trace) {
  ServingParts serving{std::move(parts), {}};
  for (std::size_t k = 0; k < asked.size(); ++k) {
    if (asked[k].stands()) continue;
    WalkRequest alone = request;
    alone.sequence.clear();
    alone.gait = asked[k].gait;
    alone.command = asked[k].command;
    const Result<PlannedWalk> planned = PlanWithin(model, terrain, alone, trace);
    if (!planned) return OfPart(k, asked[k].gait, planned.failure());
    serving.finishes = serving.finishes || planned->motion.finished;
    const MotionPart& made = planned->motion.plan.parts.front();
    serving.parts[k] = {made.gait, made.command};
    for (Adjustment adjustment : planned->motion.plan.adjustments) {
      adjustment.part = fmt::format("{}: {}", k + 1, made.gait.name);
      serving.adjustments.push_back(std::move(adjustment));
    }
  }
  return serving;
}

/// Failure of the whole sequence, with the part in which it violates a limit, although each part alone may be feasible.
Failure RefusedWhole(const Result<PlannedWalk>& planned) {
  if (!planned) {
    Failure failure = planned.failure();
    failure.suggestions.emplace_back("add standing still between the parts, or make it longer");
    return failure;
  }
  Failure failure = ReasonForbidden(*planned);
  const std::vector<MotionPart>& parts = planned->motion.plan.parts;
  const std::vector<Violation> forbidding = Forbidding(planned->audit);
  if (!forbidding.empty()) {
    const MotionPart* part = PartAt(parts, forbidding.front().at_s);
    failure = OfPart(static_cast<std::size_t>(part - parts.data()), part->gait.name, failure);
  }
  failure.suggestions = {"add standing still between the parts, or make it longer", "make a part slower",
                         AllowLimits()};
  return failure;
}

/// The plan of all parts with its audit. If it is not sound, it is planned with other footholds, where these may move.
Result<PlannedWalk> PlanWhole(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                              const std::vector<WalkPart>& parts) {
  const auto plan = [&](bool other_footholds) {
    const MotionOptions options = WithFootholds(request.motion, other_footholds);
    return Audited(model, PlanMotion(model, terrain, parts, options), options);
  };
  Result<PlannedWalk> planned = plan(false);
  const bool flies = std::any_of(parts.begin(), parts.end(), [&](const WalkPart& part) {
    return IsDynamic(part.gait, request.motion.centre_of_mass);
  });
  if (IsSound(planned) || request.motion.pipeline.allow_limits || !flies || !MayMoveFeet(request.motion, terrain))
    return planned;
  Result<PlannedWalk> other = plan(true);
  return IsSound(other) ? other : planned;
}

}  // namespace

Result<PlannedWalk> PlanPartsWithin(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                                    const std::vector<AskedPart>& asked, SearchTrace* trace) {
  const Result<std::vector<WalkPart>> fitted = Fitted(model, request, asked);
  if (!fitted) return fitted.failure();
  Result<PlannedWalk> planned = PlanWhole(model, terrain, request, *fitted);
  if (request.motion.pipeline.allow_limits || IsSound(planned)) return planned;
  if (!planned && planned.failure().kind == FailureKind::kBadInput) return planned;
  const Result<ServingParts> serving = ServingAlone(model, terrain, request, asked, *fitted, trace);
  if (!serving) return serving.failure();
  if (serving->parts != *fitted) planned = PlanWhole(model, terrain, request, serving->parts);
  if (!IsSound(planned) && serving->finishes) {
    WalkRequest finished = request;
    finished.motion.trajectory.method = "whole-body";
    planned = PlanWhole(model, terrain, finished, serving->parts);
  }
  if (!IsSound(planned)) return RefusedWhole(planned);
  planned->motion.plan.adjustments = serving->adjustments;
  return planned;
}

}  // namespace gaitwright
