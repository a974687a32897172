// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_control.h"

#include <fmt/format.h>

#include <bit>
#include <utility>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/joint_losses.h"
#include "planning/plan/sample_plan.h"
#include "workflows/walk/plan_recovery.h"

namespace gaitwright {

Result<LiveControl> LiveControl::Make(const RobotModel& model, const PlayRequest& request) {
  CheckController(request.controller);
  LiveControl control(model);
  if (request.controller != "recovering") return control;
  Result<RecoveryPlans> recovery = PlanRecovery(request.play.world.joint_losses ? model : WithoutLosses(model));
  if (!recovery) return recovery.failure();
  control.recovery_ = std::move(*recovery);
  return control;
}

std::optional<std::string> LiveControl::Follow(const MotionPlan& plan, const PlayRequest& request,
                                               const std::deque<ControlInput>& lately) {
  constexpr char kForAnyPlan[] = "stabilised";
  auto followed = std::make_unique<MotionPlan>(plan);
  std::unique_ptr<Controller> controller;
  std::optional<std::string> why;
  try {
    controller = MakeController(*model_, *followed, request, recovery_);
  } catch (const InvalidArgument& refused) {
    if (request.controller == kForAnyPlan) throw;
    PlayRequest other = request;
    other.controller = kForAnyPlan;
    controller = MakeController(*model_, *followed, other);
    why = fmt::format("'{}' is used now: {}", kForAnyPlan, refused.what());
  }
  controller->Reset();
  for (const ControlInput& input : lately) controller->Update(input);
  controller_ = std::move(controller);  // first, because the previous controller uses the previous plan
  followed_ = std::move(followed);
  const bool is_news = !std::exchange(stood_in_for_, why.has_value());
  return is_news ? why : std::nullopt;
}

Vector3 FootOffset(const RobotModel& model, const MotionPlan& plan, const ControlInput& now) {
  WholeBodySample sample;
  SampleWholeBody(plan.whole_body, now.time_s, sample);
  DynamicsScratch measured(model), planned(model);
  ForwardKinematics(model, now.q, measured);
  ForwardKinematics(model, sample.q, planned);
  const ContactSchedule& schedule = plan.schedule;
  const FootSet stance = now.contact & schedule.phases[static_cast<std::size_t>(PhaseAt(schedule, now.time_s))].stance;
  Vector3 sum = Vector3::Zero();
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    if (Contains(stance, f))
      sum += ContactFrame(model, measured, f).translation() - ContactFrame(model, planned, f).translation();
  }
  return stance == 0 ? sum : Vector3(sum / std::popcount(stance));
}

}  // namespace gaitwright
