// SPDX-License-Identifier: BSD-3-Clause
#include "examples/standing_control.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "examples/standing_strategies.h"
#include "kinematics/model/load_robot.h"
#include "playback/control/stabilised.h"
#include "workflows/walk/plan_recovery.h"
#include "workflows/walk/walk.h"

namespace gaitwright::examples {

const std::vector<std::string>& StandingStrategies() {
  static const std::vector<std::string> strategies = {"soft joints", "stiff joints", "ankle", "ankle and DCM",
                                                      "hip",         "whole body",   "steps"};
  return strategies;
}

Stander MakeStander(const std::string& robot) {
  const Result<RobotModel> model = LoadNamedRobot(robot);
  if (!model) throw InvalidArgument(model.failure().message);
  WalkRequest request;
  request.sequence = "stand: duration=3";
  const Result<PlannedWalk> planned = PlanWalk(*model, request);
  if (!planned) throw InvalidArgument(planned.failure().message);
  return {*model, planned->motion.plan};
}

std::unique_ptr<Controller> MakeStandingStrategy(const Stander& stander, const std::string& strategy) {
  const auto& [model, plan] = stander;
  const GainOptions soft{.stiffness_scale = 0.15, .damping_scale = 0.15};
  if (strategy == "soft joints") return std::make_unique<JointPd>(model, plan, soft);
  if (strategy == "stiff joints") return std::make_unique<JointPd>(model, plan);
  if (strategy == "ankle") return std::make_unique<StandingStrategy>(model, plan, Strategy::kAnkle);
  if (strategy == "ankle and DCM") return std::make_unique<StandingStrategy>(model, plan, Strategy::kAnkleDcm);
  if (strategy == "hip") return std::make_unique<StandingStrategy>(model, plan, Strategy::kHip);
  if (strategy == "whole body") return MakeStabilised(model, plan, {});
  if (strategy != "steps")
    throw InvalidArgument(
        fmt::format("unknown standing strategy '{}'; accepted: {}", strategy, fmt::join(StandingStrategies(), ", ")));
  const Result<RecoveryPlans> recovery = PlanRecovery(model);
  if (!recovery) throw InvalidArgument(recovery.failure().message);
  return MakeRecovering(model, plan, *recovery);
}

bool StandsPush(const Stander& stander, Controller& controller, double force_n, double direction_deg) {
  const double angle = direction_deg * std::numbers::pi / 180.0;
  PlayOptions options;
  options.push_force_W = force_n * Vector3(std::cos(angle), std::sin(angle), 0.0);
  options.push_at_s = 0.5;
  controller.Reset();
  const Result<PlaybackLog> log = Play(stander.model, stander.plan, controller, options);
  if (!log) throw InvalidArgument(log.failure().message);
  return Score(stander.model, stander.plan, *log).At("fell").value == 0.0;
}

double LargestPush(const Stander& stander, const std::string& strategy, double direction_deg, double most_n) {
  const std::unique_ptr<Controller> controller = MakeStandingStrategy(stander, strategy);
  double stands_n = 0.0, falls_n = most_n;
  while (falls_n - stands_n > 0.01 * most_n) {
    const double force_n = 0.5 * (stands_n + falls_n);
    (StandsPush(stander, *controller, force_n, direction_deg) ? stands_n : falls_n) = force_n;
  }
  return stands_n;
}

}  // namespace gaitwright::examples
