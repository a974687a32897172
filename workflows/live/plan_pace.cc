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

std::optional<PacePlan> Steady(MotionPlan plan, bool from_stand) {
  const std::size_t last = plan.parts.size() - 1;
  const auto stretch = SteadyStretchOf(plan, last);
  const auto before = from_stand ? std::nullopt : SteadyStretchOf(plan, 0);
  if (!stretch || (!from_stand && !before)) return std::nullopt;
  return PacePlan{std::move(plan), before, *stretch};
}

}  // namespace

Result<PacePlan> PlanPace(const RobotModel& model, const Pace& from, const Pace& to, const WalkRequest& usual) {
  constexpr double kBefore = 8.0, kCycles = 10.0, kMore = 2.0;
  constexpr int kTries = 2;
  WalkRequest request = usual;
  request.gait_options.cycle_step_s = request.motion.pipeline.grid_step_s;
  const Result<Terrain> level = MakeTerrain("flat", {});
  if (!level) return level.failure();
  double scale = 1.0;
  for (int tries = 0; tries < kTries; ++tries, scale *= kMore) {
    std::vector<AskedPart> parts;
    for (const auto& [pace, cycles] : {std::pair(from, kBefore), std::pair(to, kCycles)}) {
      if (pace.stands()) continue;
      const double speed = std::hypot(pace.speed_m_s, pace.lateral_speed_m_s);
      const Result<Gait> gait = FindGait(model, pace.gait, speed, request.gait_options);
      if (!gait) return gait.failure();
      parts.push_back(PartOf(pace, scale * cycles * gait->cycle_s));
    }
    Result<PlannedWalk> planned = PlanPartsWithin(model, *level, request, parts);
    if (!planned) return planned.failure();
    if (auto steady = Steady(std::move(planned->motion.plan), from.stands())) return std::move(*steady);
  }
  return Failure{FailureKind::kInfeasible,
                 "not_steady",
                 "PlanPace",
                 fmt::format("{} at {:.4g} m/s does not come to repeat itself", to.gait, to.speed_m_s),
                 {"a slower pace"}};
}

}  // namespace gaitwright
