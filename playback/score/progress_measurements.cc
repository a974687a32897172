// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "playback/score/measurements.h"

namespace gaitwright {
namespace {

double Distance(const Vector2& a, const Vector2& b) { return (a - b).norm(); }

Vector2 BaseOf(const MotionSample& sample) { return sample.X_WB.translation().head<2>(); }

Measurement At(const std::string& key, double value, double planned, double at_s) {
  return {key, value, planned, at_s, ""};
}

}  // namespace

std::vector<Measurement> ProgressMeasurements(const ScoreInputs& in) {
  const MotionSample &first = in.series.measured.front(), &last = in.series.measured.back();
  const MotionSample &plan_first = in.series.planned.front(), &plan_last = in.series.planned.back();
  const Vector2 goal(in.plan.goal.x_m, in.plan.goal.y_m);
  const auto heading_error = [&](const MotionSample& sample) {
    return std::abs(WrapAngle(YawOf(sample.X_WB.linear()) - in.plan.goal.yaw_rad));
  };
  std::vector<Measurement> rows;
  rows.push_back({"fell", in.fall.fell ? 1.0 : 0.0, {}, {}, ""});
  if (in.fall.fell) {
    rows.back().at_s = in.fall.time_s;
    rows.push_back({"time_to_fall_s", in.fall.time_s - in.log.start_s, {}, in.fall.time_s, ""});
  } else {
    rows.push_back({"time_to_fall_s", {}, {}, {}, "it did not fall"});
  }
  rows.push_back(At("distance_m", Distance(BaseOf(last), BaseOf(first)),
                    Distance(BaseOf(plan_last), BaseOf(plan_first)), last.time_s));
  rows.push_back(At("goal_error_m", Distance(BaseOf(last), goal), Distance(BaseOf(plan_last), goal), last.time_s));
  rows.push_back(At("heading_error_rad", heading_error(last), heading_error(plan_last), last.time_s));
  return rows;
}

}  // namespace gaitwright
