// SPDX-License-Identifier: BSD-3-Clause
#include "examples/own_controller.h"

#include <fmt/format.h>

#include <algorithm>

#include "workflows/walk/walk.h"

namespace gaitwright::examples {

FadingIn::FadingIn(const RobotModel& model, const MotionPlan& plan, double fade_s)
    : plan_(plan), gains_(DeriveGains(model)), fade_s_(fade_s) {
  if (!(fade_s > 0.0)) throw InvalidArgument(fmt::format("fade_s is {} s; it must be more than 0", fade_s));
}

JointCommand FadingIn::Update(const ControlInput& input) {
  SampleWholeBody(plan_.whole_body, input.time_s, wanted_);  // after the plan's end: the last row, at rest
  const Eigen::Index n = gains_.stiffness.size();
  JointCommand command;
  command.q = wanted_.q.tail(n);
  command.v = wanted_.v.tail(n);
  const double since_start_s = input.time_s - plan_.whole_body.start_s;
  command.tau_ff = std::clamp(since_start_s / fade_s_, 0.0, 1.0) * wanted_.tau;
  command.stiffness = gains_.stiffness;
  command.damping = gains_.damping;
  return command;
}

StabilityReport WalkWithOwnController(const std::string& robot, double fade_s) {
  const Result<RobotModel> model = ChooseRobot(robot, "");
  if (!model) throw InvalidArgument(model.failure().message);
  WalkRequest request;
  request.command.distance_m = 0.3;
  const Result<PlannedWalk> planned = PlanWalk(*model, request);
  if (!planned) throw InvalidArgument(planned.failure().message);
  const MotionPlan& plan = planned->motion.plan;
  FadingIn controller(*model, plan, fade_s);
  const Result<PlaybackLog> log = Play(*model, plan, controller);
  if (!log) throw InvalidArgument(log.failure().message);
  return Score(*model, plan, *log);
}

}  // namespace gaitwright::examples
