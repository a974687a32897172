// SPDX-License-Identifier: BSD-3-Clause
#include "examples/quadruped_walk.h"

#include <algorithm>
#include <cmath>

#include "kinematics/model/load_robot.h"
#include "workflows/walk/walk.h"

namespace gaitwright::examples {
namespace {

/// Highest mean forward speed over one gait cycle [m/s]. A mean over a cycle, because the speed varies within it.
double SpeedReached(const MotionPlan& plan, const PlaybackLog& log) {
  const double cycle_s = plan.parts.front().gait.cycle_s;
  const auto cycle = static_cast<std::size_t>(std::lround(cycle_s * log.log_rate_hz));
  double fastest_m_s = 0.0;
  for (std::size_t k = cycle; k < log.samples.size(); ++k) {
    const LogSample &from = log.samples[k - cycle], &to = log.samples[k];
    fastest_m_s = std::max(fastest_m_s, (to.q[0] - from.q[0]) / (to.time_s - from.time_s));
  }
  return fastest_m_s;
}

}  // namespace

WalkedQuadruped WalkQuadruped(const std::string& robot, const std::string& gait, double speed_m_s) {
  const Result<RobotModel> model = LoadNamedRobot(robot);
  if (!model) throw InvalidArgument(model.failure().message);
  WalkRequest request;
  request.gait = gait;
  request.command.speed_m_s = speed_m_s;
  request.command.distance_m = 1.0;
  const Result<PlannedWalk> planned = PlanWalk(*model, request);  // includes the audit
  if (!planned) throw InvalidArgument(planned.failure().message);
  const MotionPlan& plan = planned->motion.plan;
  const Result<PlayedWalk> played = PlayWalk(*model, plan, {});  // includes the score
  if (!played) throw InvalidArgument(played.failure().message);
  return {plan, planned->audit, played->report, SpeedReached(plan, played->log)};
}

}  // namespace gaitwright::examples
