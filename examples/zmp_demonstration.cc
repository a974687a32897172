// SPDX-License-Identifier: BSD-3-Clause
#include "examples/zmp_demonstration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/zero_moment_point.h"
#include "optimisation/pipeline/plan_posture.h"
#include "planning/tasks/repertoire.h"
#include "workflows/walk/walk.h"

namespace gaitwright::examples {
namespace {

/// Motion: stand, shift the centre of mass, stand in the shifted posture.
PostureMotion ShiftOf(const RobotModel& model, const Vector2& shift_m, double duration_s) {
  const PostureKey start = StandingKey(model);
  PostureKey still = start, shifted = start;
  still.after_s = 0.3;
  shifted.shift << shift_m, 0.0;
  shifted.after_s = duration_s;
  PostureKey there = shifted;
  there.after_s = 0.7;
  return {"shift", {start, still, shifted, there}};
}

/// Computes the values of `shown` from its series.
void Measure(ShownShift& shown) {
  constexpr double kFalling = 0.1;  // [rad]; beyond this tilt the soles are no longer flat on the ground
  const std::vector<MotionSample>& measured = shown.series.measured;
  shown.margin_planned_m = shown.margin_measured_m = HUGE_VAL;
  for (std::size_t k = 1; k < measured.size(); ++k) {
    const MotionSample &before = measured[k - 1], &now = measured[k], &planned = shown.series.planned[k];
    shown.margin_planned_m = std::min(shown.margin_planned_m, planned.zmp_margin_m());
    const Matrix3 R_off = now.X_WB.linear() * planned.X_WB.linear().transpose();
    shown.tilt_rad = std::max(shown.tilt_rad, RotationLog(R_off).norm());
    if (shown.tilt_rad > kFalling || !now.has_zmp) continue;
    shown.margin_measured_m = std::min(shown.margin_measured_m, now.zmp_margin_m());
    if (shown.margin_planned_m < 0.0) continue;  // from here on the motion differs from the plan
    // The force of a sample is the mean since the previous sample, so these are means over the same interval.
    const Vector3 a_WC = (now.v_WC - before.v_WC) / (now.time_s - before.time_s);
    const Vector3 p_WC = 0.5 * (before.p_WC + now.p_WC);
    shown.formula_W.push_back(PendulumZmp(p_WC, a_WC, now.omega_rad_s));
    shown.lead_m = std::max(shown.lead_m, (now.p_WZ - p_WC.head<2>()).norm());
    shown.off_formula_m = std::max(shown.off_formula_m, (now.p_WZ - shown.formula_W.back()).norm());
  }
}

}  // namespace

ShownShift ShiftBody(const RobotModel& model, const Vector2& shift_m, double duration_s) {
  if (!(duration_s > 0.0)) throw InvalidArgument(fmt::format("duration_s is {}; it must be more than 0", duration_s));
  const Result<MotionPlan> plan = PlanPosture(model, ShiftOf(model, shift_m, duration_s), {});
  if (!plan) throw InvalidArgument(plan.failure().message);
  PlayRequest request;
  request.controller = "joint-pd";  // does not balance
  const Result<PlayedWalk> played = PlayWalk(model, *plan, request);
  if (!played) throw InvalidArgument(played.failure().message);
  ScoreOptions as_it_is;
  as_it_is.zmp_filter_s = 0.0;
  ShownShift shown;
  shown.duration_s = duration_s;
  shown.fell = played->report.At("fell").value.value_or(0.0) != 0.0;
  shown.series = MakeMotionSeries(model, *plan, played->log, as_it_is);
  Measure(shown);
  return shown;
}

}  // namespace gaitwright::examples
