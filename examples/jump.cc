// SPDX-License-Identifier: BSD-3-Clause
#include "examples/jump.h"

#include <algorithm>

#include "kinematics/model/load_robot.h"
#include "playback/score/motion_series.h"
#include "workflows/walk/walk.h"

namespace gaitwright::examples {
namespace {

/// Fills in the longest interval of the log without contact, and the rise and drop of the centre of mass in it.
void MeasureFlight(const PlaybackLog& log, const std::vector<MotionSample>& motion, Leap& leap) {
  for (std::size_t first = 0; first < motion.size(); ++first) {
    const MotionSample& start = motion[first];
    double highest_m = start.p_WC.z();
    for (std::size_t k = first; k < motion.size() && log.samples[k].contact == 0; ++k) {
      highest_m = std::max(highest_m, motion[k].p_WC.z());
      const double air_s = motion[k].time_s - start.time_s;
      if (air_s <= leap.air_s) continue;
      leap.air_s = air_s;
      leap.rise_m = highest_m - start.p_WC.z();
      leap.drop_m = highest_m - motion[k].p_WC.z();
    }
  }
}

}  // namespace

Leap LeapForward(const std::string& robot, double length_m) {
  const Result<RobotModel> model = LoadNamedRobot(robot);
  if (!model) throw InvalidArgument(model.failure().message);
  WalkRequest request;
  request.gait = "jump";
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = static_cast<int>(model->legs.size());  // each foot comes down once
  request.command.step_length_m = length_m / request.command.steps;
  const Result<PlannedWalk> planned = PlanWalk(*model, request);
  if (!planned) throw InvalidArgument(planned.failure().message);
  const MotionPlan& plan = planned->motion.plan;
  const Result<PlayedWalk> played = PlayWalk(*model, plan, {});
  if (!played) throw InvalidArgument(played.failure().message);
  Leap leap{.report = played->report, .planned_air_s = LongestFlight(plan.schedule)};
  MeasureFlight(played->log, MakeMotionSeries(*model, plan, played->log, {}).measured, leap);
  return leap;
}

}  // namespace gaitwright::examples
