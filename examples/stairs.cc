// SPDX-License-Identifier: BSD-3-Clause
#include "examples/stairs.h"

#include <algorithm>

#include "kinematics/model/load_robot.h"
#include "workflows/walk/walk.h"

namespace gaitwright::examples {
namespace {

/// A planned foothold has the index of its surface: patches first, then height fields. The surface of a measured
/// touch-down comes from GroundAt.
std::vector<PatchTread> TreadsOf(const MotionPlan& plan, const PlaybackLog& log) {
  std::vector<PatchTread> treads;
  for (const TerrainPatch& patch : plan.terrain.patches) treads.push_back({.patch = patch.name});
  for (const HeightField& field : plan.terrain.height_fields) treads.push_back({.patch = field.name});
  for (const Foothold& foothold : plan.footsteps.footholds) {
    if (foothold.touchdown_s > plan.whole_body.start_s) ++treads.at(static_cast<std::size_t>(foothold.patch)).planned;
  }
  for (const StanceRecord& stance : log.stances) {
    const GroundPoint ground = GroundAt(plan.terrain, stance.p_touchdown_W.head<2>());
    if (stance.touchdown_s <= log.start_s || ground.patch < 0) continue;
    PatchTread& tread = treads.at(static_cast<std::size_t>(ground.patch));
    const double height_m = stance.p_touchdown_W.z();
    tread.height_m = tread.measured == 0 ? height_m : std::max(tread.height_m, height_m);
    ++tread.measured;
  }
  return treads;
}

}  // namespace

Climb ClimbStairs(const std::string& robot, const std::string& terrain, double distance_m) {
  const Result<RobotModel> model = LoadNamedRobot(robot);
  if (!model) throw InvalidArgument(model.failure().message);
  WalkRequest request;
  request.terrain = terrain;
  request.command.distance_m = distance_m;
  const Result<PlannedWalk> planned = PlanWalk(*model, request);
  if (!planned) throw InvalidArgument(planned.failure().message);
  const MotionPlan& plan = planned->motion.plan;
  const Result<PlayedWalk> played = PlayWalk(*model, plan, {});
  if (!played) throw InvalidArgument(played.failure().message);
  return {TreadsOf(plan, played->log), played->report};
}

}  // namespace gaitwright::examples
