// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/pipeline/limit_violation.h"
#include "optimisation/pipeline/raise_heels_internal.h"
#include "optimisation/swing/swing_lift.h"

namespace gaitwright {
namespace {

/// Whether a gait with flight lifts a foot by less than half of the usual lift, because of its motors: see
/// FlightSwings.
bool LiftsLittle(const RobotModel& model, const MotionPlan& plan, const SwingOptions& options) {
  constexpr double kLittle = 0.5;
  const double usual_m = SwingLift(model, options);
  return LongestFlight(plan.schedule) > 0.0 && std::ranges::any_of(plan.swings, [&](const SwingTrajectory& swing) {
           return swing.clearance_m < kLittle * usual_m;
         });
}

}  // namespace

void FinishPlanned(const RobotModel& model, const MotionOptions& options, PlannedMotion& planned) {
  if (!ReasonNotFinished(model, planned.plan).empty()) return;
  FinishReport report;
  MotionPlan raised = planned.plan;
  RaiseHeels(model, {options.trajectory.heel_off_rad, options.trajectory.heel_off_share}, raised);
  TrajectoryOptions trajectory = options.trajectory;
  if (trajectory.clearance_m == 0.0) trajectory.clearance_m = options.swing.clearance_m;
  if (trajectory.swings == "as-needed" && trajectory.cycles != "periodic" &&
      LiftsLittle(model, raised, options.swing)) {
    constexpr double kLeastEffort = 1.0;  // leaves motors room for a controller
    trajectory.swings = "free";
    trajectory.effort = std::max(trajectory.effort, kLeastEffort);
  }
  Result<MotionPlan> finished =
      FinishMotion(model, raised, trajectory, options.whole_body.friction_use, &report,
                   options.pipeline.end_as_standing && KindOfGround(raised.terrain) == GroundKind::kFlat);
  if (!finished) {
    planned.unfinished = finished.failure();
    return;
  }
  const std::vector<std::string> before = LimitWarnings(model, planned.plan.whole_body);
  std::erase_if(finished->warnings, [&](const std::string& warning) {
    return std::find(before.begin(), before.end(), warning) != before.end();
  });
  for (std::string& warning : LimitWarnings(model, finished->whole_body)) finished->warnings.push_back(warning);
  if (options.trajectory.cycles == "periodic" && report.cycles == 0) {
    finished->warnings.emplace_back(
        "trajectory.cycles=periodic has no effect: the plan has no two moments one cycle apart between which all feet "
        "move equally far; walk farther");
  }
  planned.plan = std::move(*finished);
  planned.finished = report;
  planned.residual = std::max(report.residual_force, report.residual_moment * model.leg_length_m());
  planned.limit_violation = TotalViolation(model, planned.plan.whole_body, 0.0);
  planned.summary += "; " + report.summary;
}

}  // namespace gaitwright
