// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "planning/gait/read_sequence.h"
#include "planning/plan/built_in_terrain.h"
#include "workflows/live/walk_stream.h"
#include "workflows/walk/plan_parts.h"

namespace gaitwright {
namespace {

AskedPart PartOf(const Pace& pace, double duration_s) {
  AskedPart part;
  part.gait = pace.gait;
  part.command.extent = WalkCommand::Extent::kDuration;
  part.command.duration_s = duration_s;
  part.command.speed_m_s = pace.speed_m_s;
  part.command.lateral_speed_m_s = pace.lateral_speed_m_s;
  part.command.yaw_rate_rad_s = pace.yaw_rate_rad_s;
  return part;
}

/// A turn in whole cycles, no quicker than that.
AskedPart TurnOf(Pace pace, double turn_rad, double quickest_rad_s, double cycle_s) {
  const double cycles = std::ceil(std::abs(turn_rad) / (quickest_rad_s * cycle_s));
  pace.yaw_rate_rad_s = turn_rad / (cycles * cycle_s);
  return PartOf(pace, cycles * cycle_s);
}

std::optional<PacePlan> Steady(MotionPlan plan, bool from_stand) {
  const std::size_t last = plan.parts.size() - 1;
  const auto stretch = SteadyStretchOf(plan, last);
  const auto before = from_stand ? std::nullopt : SteadyStretchOf(plan, 0);
  if (!stretch || (!from_stand && !before)) return std::nullopt;
  return PacePlan{std::move(plan), before, *stretch};
}

}  // namespace

Result<PacePlan> PlanPace(const RobotModel& model, const PaceChange& change, const WalkRequest& usual) {
  constexpr double kBefore = 8.0, kCycles = 10.0, kMore = 2.0;
  constexpr double kQuickTurn = 0.7;  // of the robot's own speed at a leg's length
  constexpr int kTries = 2;
  WalkRequest request = usual;
  request.gait_options.cycle_step_s = request.motion.pipeline.grid_step_s;
  const Result<Terrain> level = MakeTerrain("flat", {});
  if (!level) return level.failure();
  const double quickest = kQuickTurn * model.nominal_speed_m_s / model.leg_length_m();
  double scale = 1.0;
  for (int tries = 0; tries < kTries; ++tries, scale *= kMore) {
    std::vector<AskedPart> parts;
    for (const bool first : {true, false}) {
      const Pace& pace = first ? change.from : change.to;
      if (pace.stands()) continue;
      const double speed = std::hypot(pace.speed_m_s, pace.lateral_speed_m_s);
      const Result<Gait> gait = FindGait(model, pace.gait, speed, request.gait_options);
      if (!gait) return gait.failure();
      if (!first && change.turn_rad != 0.0) parts.push_back(TurnOf(pace, change.turn_rad, quickest, gait->cycle_s));
      parts.push_back(PartOf(pace, scale * (first ? kBefore : kCycles) * gait->cycle_s));
    }
    Result<PlannedWalk> planned = PlanPartsWithin(model, *level, request, parts);
    if (!planned) return planned.failure();
    if (auto steady = Steady(std::move(planned->motion.plan), change.from.stands())) return std::move(*steady);
  }
  return Failure{FailureKind::kInfeasible,
                 "not_steady",
                 "PlanPace",
                 fmt::format("{} at {:.4g} m/s does not come to repeat itself", change.to.gait, change.to.speed_m_s),
                 {"a slower pace"}};
}

}  // namespace gaitwright
