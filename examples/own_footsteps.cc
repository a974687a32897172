// SPDX-License-Identifier: BSD-3-Clause
#include "examples/own_footsteps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planning/paths/standing_feet.h"
#include "planning/plan/terrain.h"
#include "workflows/exchange/footstep_file.h"
#include "workflows/walk/walk.h"

namespace gaitwright::examples {
namespace {

/// The largest of all distances from a step to where its foot came down next to it.
double LargestMiss(const std::vector<PlacedStep>& steps, const PlaybackLog& log) {
  double largest_m = 0.0;
  for (const PlacedStep& step : steps) {
    const Vector2 wanted(step.place.x_m, step.place.y_m);
    double nearest_m = HUGE_VAL;
    for (const StanceRecord& stance : log.stances) {
      const double miss_m = (stance.p_touchdown_W.head<2>() - wanted).norm();
      if (stance.foot == step.foot) nearest_m = std::min(nearest_m, miss_m);
    }
    largest_m = std::max(largest_m, nearest_m);
  }
  return largest_m;
}

}  // namespace

std::vector<PlacedStep> StepsOnArc(const RobotModel& model, double radius_m, double turn_rad, double stride_m) {
  const double strides = radius_m * std::abs(turn_rad) / stride_m;
  if (!(radius_m > 0.0 && stride_m > 0.0 && strides > 0.0 && strides < 1000.0))
    throw InvalidArgument(fmt::format("no steps by {} m around {} rad of {} m", stride_m, turn_rad, radius_m));
  const std::vector<Pose> standing = StandingFeet(model);
  const int feet = static_cast<int>(model.legs.size()), rounds = static_cast<int>(std::ceil(strides));
  const double to_left_m = std::copysign(radius_m, turn_rad);  // where the middle of the arc is
  std::vector<PlacedStep> steps;
  for (int round = 1; round <= rounds; ++round) {
    const double yaw = turn_rad * round / rounds;
    const PlanarPose body{to_left_m * std::sin(yaw), to_left_m * (1.0 - std::cos(yaw)), yaw};
    for (const int side : {1, 0}) {  // legs stand front before rear, left before right
      for (int foot = feet - 2 + side; foot >= 0; foot -= 2) {
        const Vector3 p_WF = Carried(body, standing[static_cast<std::size_t>(foot)]).translation();
        steps.push_back({foot, {p_WF.x(), p_WF.y(), yaw}});
      }
    }
  }
  return steps;
}

std::string FootstepsYaml(const RobotModel& model, const std::vector<PlacedStep>& steps, double swing_s,
                          double pause_s) {
  std::string yaml = fmt::format("swing_s: {}\npause_s: {}\nfootsteps:\n", swing_s, pause_s);
  for (const PlacedStep& step : steps)
    yaml += fmt::format("- {{foot: {}, x_m: {}, y_m: {}, yaw_rad: {}}}\n",
                        model.feet[static_cast<std::size_t>(step.foot)].name, step.place.x_m, step.place.y_m,
                        step.place.yaw_rad);
  return yaml;
}

WalkedSteps WalkSteps(const RobotModel& model, const std::vector<PlacedStep>& steps) {
  ImportRequest request;
  request.file = "own footsteps";  // what failures call them
  ImportedMotion motion;
  const std::string yaml = FootstepsYaml(model, steps, 0.35, 0.15);
  if (const auto failure = PlanFootstepFile(model, FlatTerrain(), yaml, request, motion))
    throw InvalidArgument(failure->message);
  const Result<AuditReport> audit = Audit(model, motion.plan, {});
  if (!audit) throw InvalidArgument(audit.failure().message);
  const Result<PlayedWalk> played = PlayWalk(model, motion.plan, {});
  if (!played) throw InvalidArgument(played.failure().message);
  return {motion.plan, *audit, played->report, LargestMiss(steps, played->log)};
}

}  // namespace gaitwright::examples
