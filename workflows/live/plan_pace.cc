// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "kinematics/spatial/rotation.h"
#include "optimisation/search/plan_parts.h"
#include "planning/footsteps/course.h"
#include "planning/gait/read_sequence.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/plan/sample_plan.h"
#include "workflows/live/walk_stream.h"

namespace gaitwright {
namespace {

AskedPart PartOf(const WalkPace& pace, double duration_s) {
  AskedPart part;
  part.gait = pace.gait;
  part.command.extent = WalkCommand::Extent::kDuration;
  part.command.duration_s = duration_s;
  part.command.speed_m_s = pace.speed_m_s;
  part.command.lateral_speed_m_s = pace.lateral_speed_m_s;
  part.command.yaw_rate_rad_s = pace.yaw_rate_rad_s;
  return part;
}

/// A turn in whole cycles, with a yaw rate of at most `fastest_rad_s`.
/// @param asked_rad  commanded angle for which the plan turns by `turn_rad`.
AskedPart TurnOf(WalkPace pace, double turn_rad, double asked_rad, double fastest_rad_s, double cycle_s) {
  const double cycles = std::ceil(std::abs(turn_rad) / (fastest_rad_s * cycle_s));
  pace.yaw_rate_rad_s = asked_rad / (cycles * cycle_s);
  return PartOf(pace, cycles * cycle_s);
}

std::optional<PacePlan> Steady(MotionPlan plan, bool from_stand) {
  const std::size_t last = plan.parts.size() - 1;
  const auto stretch = SteadyStretchOf(plan, last);
  const auto before = from_stand ? std::nullopt : SteadyStretchOf(plan, 0);
  if (!stretch || (!from_stand && !before)) return std::nullopt;
  return PacePlan{std::move(plan), before, *stretch};
}

/// Parts of the walk: the previous speed, the turn, and the new speed.
/// @param asked_rad  commanded angle of the turn.
Result<std::vector<AskedPart>> PartsOf(const RobotModel& model, const PaceChange& change, double asked_rad,
                                       double scale, const GaitOptions& options) {
  constexpr double kBefore = 8.0, kCycles = 10.0;
  constexpr double kFastTurn = 0.7;  // share of the robot's default speed divided by its leg length
  const double fastest = kFastTurn * model.nominal_speed_m_s / model.leg_length_m();
  std::vector<AskedPart> parts;
  for (const bool first : {true, false}) {
    const WalkPace& pace = first ? change.from : change.to;
    if (pace.stands()) continue;
    const AskedPart lasts = PartOf(pace, 0.0);
    const Result<Gait> gait = FindGait(model, pace.gait, SpeedOfSteps(model, lasts.command), options);
    if (!gait) return gait.failure();
    if (!first && change.turn_rad != 0.0)
      parts.push_back(TurnOf(pace, change.turn_rad, asked_rad, fastest, gait->cycle_s));
    parts.push_back(PartOf(pace, scale * (first ? kBefore : kCycles) * gait->cycle_s));
  }
  return parts;
}

double HeadingAt(const MotionPlan& plan, double time_s) {
  WholeBodySample sample;
  SampleWholeBody(plan.whole_body, time_s, sample);
  return YawOf(BaseRotation(sample.q));
}

/// Angle by which a plan turns less than required.
double MissingTurn(const PacePlan& pace, double turn_rad) {
  const double from_s = pace.before ? pace.before->start_s : pace.plan.whole_body.start_s;
  const double turned = HeadingAt(pace.plan, pace.stretch.start_s) - HeadingAt(pace.plan, from_s);
  return std::remainder(turn_rad - turned, 2.0 * std::numbers::pi);
}

Result<PacePlan> PlanAtHeight(const RobotModel& model, const PaceChange& change, const WalkRequest& usual) {
  constexpr int kTries = 4;
  constexpr double kMore = 1.7, kTurned = 0.01;  // cycles of the next try, [rad]
  WalkRequest request = usual;
  request.gait_options.cycle_step_s = request.motion.pipeline.grid_step_s;
  if (change.com_height_m > 0.0) request.motion.pipeline.com_height_m = change.com_height_m;
  const Result<Terrain> level = MakeTerrain("flat", {});
  if (!level) return level.failure();
  double scale = 1.0, asked_rad = change.turn_rad;
  for (int tries = 0; tries < kTries; ++tries) {
    const Result<std::vector<AskedPart>> parts = PartsOf(model, change, asked_rad, scale, request.gait_options);
    if (!parts) return parts.failure();
    Result<PlannedWalk> planned = PlanPartsWithin(model, *level, request, *parts);
    if (!planned) return planned.failure();
    auto steady = Steady(std::move(planned->motion.plan), change.from.stands());
    if (!steady) {
      scale *= kMore;
      continue;
    }
    // Turning starts and ends smoothly, so a part turns by less than its rate times its time.
    const double missing = change.turn_rad == 0.0 ? 0.0 : MissingTurn(*steady, change.turn_rad);
    if (std::abs(missing) < kTurned) return std::move(*steady);
    asked_rad += missing;
  }
  return Failure{FailureKind::kInfeasible,
                 FailureCode::kNotSteady,
                 "PlanPace",
                 fmt::format("{} at {:.4g} m/s does not reach a periodic motion", change.to.gait, change.to.speed_m_s),
                 {"use a lower speed"}};
}

}  // namespace

WalkPace UsualPace(const RobotModel& model, const GaitOptions& options) {
  WalkPace pace;
  const Result<Gait> gait = FindGait(model, "", model.nominal_speed_m_s, options);
  if (gait) pace.gait = gait->name;
  pace.speed_m_s = model.nominal_speed_m_s;
  return pace;
}

std::string TextOf(const PaceChange& change) {
  std::string text = fmt::format("{} at {:.3g} m/s", change.to.gait, change.to.speed_m_s);
  if (change.to.lateral_speed_m_s != 0.0) text += fmt::format(", {:.3g} m/s lateral", change.to.lateral_speed_m_s);
  if (change.to.yaw_rate_rad_s != 0.0) text += fmt::format(", turning at {:.3g} rad/s", change.to.yaw_rate_rad_s);
  if (change.turn_rad != 0.0)
    text += fmt::format(", after a turn of {:.0f} degrees", change.turn_rad * 180.0 / std::numbers::pi);
  return text;
}

Result<PacePlan> PlanPace(const RobotModel& model, const PaceChange& change, const WalkRequest& usual) {
  if (change.com_height_m > 0.0) {
    if (Result<PacePlan> plan = PlanAtHeight(model, change, usual)) return plan;
  }
  PaceChange free = change;
  free.com_height_m = 0.0;
  return PlanAtHeight(model, free, usual);
}

}  // namespace gaitwright
