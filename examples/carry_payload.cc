// SPDX-License-Identifier: BSD-3-Clause
#include "examples/carry_payload.h"

#include <fmt/format.h>

#include "examples/adaptive_pd.h"
#include "kinematics/model/load_robot.h"
#include "workflows/walk/walk.h"

namespace gaitwright::examples {

CarriedPayload CarryPayload(const std::string& robot, double payload_kg, double rate_per_s) {
  if (!(payload_kg >= 0.0)) throw InvalidArgument(fmt::format("payload_kg is {}; it must be 0 or more", payload_kg));
  const Result<RobotModel> model = LoadNamedRobot(robot);
  if (!model) throw InvalidArgument(model.failure().message);
  WalkRequest request;
  request.sequence = "stand: duration=3";
  const Result<PlannedWalk> planned = PlanWalk(*model, request);
  if (!planned) throw InvalidArgument(planned.failure().message);
  const MotionPlan& plan = planned->motion.plan;
  RobotModel loaded = *model;  // for playback only; plan, controller and score use *model
  loaded.bodies[0].mass += payload_kg;
  loaded.total_mass_kg += payload_kg;
  AdaptivePd controller(*model, plan, rate_per_s);
  const Result<PlaybackLog> log = Play(loaded, plan, controller);
  if (!log) throw InvalidArgument(log.failure().message);
  return {controller.payloads_kg(), Score(*model, plan, *log)};
}

}  // namespace gaitwright::examples
