// SPDX-License-Identifier: BSD-3-Clause
#include "examples/walk_own_footsteps.h"

#include <algorithm>
#include <cmath>

#include "planning/plan/terrain.h"
#include "workflows/walk/walk.h"

namespace gaitwright::examples {
namespace {

/// Maximum over all steps of the distance from the step to the nearest measured touch-down of its foot [m].
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

WalkedSteps WalkSteps(const RobotModel& model, const std::vector<PlacedStep>& steps) {
  const Result<MotionPlan> plan = PlanOverSteps(model, FlatTerrain(), steps, {.swing_s = 0.35, .pause_s = 0.15});
  if (!plan) throw InvalidArgument(plan.failure().message);
  const Result<AuditReport> audit = Audit(model, *plan, {});
  if (!audit) throw InvalidArgument(audit.failure().message);
  const Result<PlayedWalk> played = PlayWalk(model, *plan, {});
  if (!played) throw InvalidArgument(played.failure().message);
  return {*plan, *audit, played->report, LargestMiss(steps, played->log)};
}

}  // namespace gaitwright::examples
