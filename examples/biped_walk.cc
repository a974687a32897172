// SPDX-License-Identifier: BSD-3-Clause
#include "examples/biped_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "kinematics/model/load_robot.h"
#include "playback/score/motion_series.h"
#include "workflows/walk/walk.h"

namespace gaitwright::examples {
namespace {

/// Smallest distance of the ZMP from the edge of the support polygon while this number of feet is in stance [m].
double LeastMargin(const std::vector<MotionSample>& motion, int feet) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const MotionSample& sample : motion) {
    if (!sample.has_zmp || std::popcount(sample.stance) != feet) continue;
    least_m = std::min(least_m, SignedDistance(sample.support.polygon, sample.p_WZ));
  }
  return least_m;
}

}  // namespace

BipedWalk WalkBiped(const std::string& robot, int steps, double step_length_m) {
  const Result<RobotModel> model = LoadNamedRobot(robot);
  if (!model) throw InvalidArgument(model.failure().message);
  if (model->legs.size() != 2)
    throw InvalidArgument(fmt::format("robot '{}' has {} legs; a biped has 2", robot, model->legs.size()));
  WalkRequest request;
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = steps;
  request.command.step_length_m = step_length_m;
  const Result<PlannedWalk> planned = PlanWalk(*model, request);
  if (!planned) throw InvalidArgument(planned.failure().message);
  const MotionPlan& plan = planned->motion.plan;
  const Result<PlayedWalk> played = PlayWalk(*model, plan, {});
  if (!played) throw InvalidArgument(played.failure().message);
  const MotionSeries series = MakeMotionSeries(*model, plan, played->log, {});
  return {played->report, LeastMargin(series.measured, 1), LeastMargin(series.measured, 2)};
}

}  // namespace gaitwright::examples
