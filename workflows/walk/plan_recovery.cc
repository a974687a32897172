// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/plan_recovery.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "optimisation/pipeline/plan_posture.h"
#include "planning/tasks/repertoire.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

/// Steps in place with the shortest cycle whose plan passes the audit.
std::optional<MotionPlan> FastSteps(const RobotModel& model) {
  constexpr double kShortestCycle = 2.0,
                   kSlower = 1.25;  // factors: of sqrt(leg / g); from one cycle to the next
  constexpr int kTries = 8;
  const double pendulum_s = std::sqrt(model.leg_length_m() / kGravity);
  WalkRequest request;
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = model.legs.size() == 2 ? 6 : 2 * static_cast<int>(model.legs.size());
  request.command.step_length_m = 1e-4;
  std::vector<double> cycles_s;
  for (int k = 0; k < kTries; ++k) cycles_s.push_back(kShortestCycle * std::pow(kSlower, k) * pendulum_s);
  cycles_s.push_back(0.0);  // the default cycle of the gait
  for (const double cycle_s : cycles_s) {
    request.gait_options.cycle_s = cycle_s;
    Result<PlannedWalk> planned = PlanWalk(model, request);
    if (planned && planned->audit.pass()) return std::move(planned->motion.plan);
  }
  return std::nullopt;
}

/// The joints at the end of a protective crouch, as deep as the legs allow.
Result<VectorX> CrouchedJoints(const RobotModel& model) {
  Failure failure;
  for (const double share : {0.3, 0.22, 0.15, 0.08}) {  // of the leg length
    const PostureMotion down = Brace(model, StandingKey(model), share * model.leg_length_m(), 0.1);
    const Result<MotionPlan> plan = PlanPosture(model, down, {});
    if (plan) return VectorX(plan->whole_body.q.back().tail(model.num_dofs()));
    failure = plan.failure();
  }
  return failure;
}

}  // namespace

Result<RecoveryPlans> PlanRecovery(const RobotModel& model) {
  const Result<VectorX> low = CrouchedJoints(model);
  if (!low) return low.failure();
  return RecoveryPlans{FastSteps(model), *low};
}

}  // namespace gaitwright
