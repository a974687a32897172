// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "playback/score/measurements.h"

namespace gaitwright {
namespace {

/// The base in plan view.
PlanarPose BaseOf(const VectorX& q) {
  const Quaternion r(Eigen::Vector4d(q.segment<4>(3)));
  return {q[0], q[1], YawOf(r.normalized().toRotationMatrix())};
}

double Distance(const PlanarPose& a, const PlanarPose& b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

double Turn(const PlanarPose& a, const PlanarPose& b) { return std::abs(WrapAngle(a.yaw_rad - b.yaw_rad)); }

}  // namespace

std::vector<Measurement> ProgressMeasurements(const ScoreInputs& in) {
  const std::size_t count = in.series.measured.size();
  const PlanarPose first = BaseOf(in.log.samples.front().q), last = BaseOf(in.log.samples[count - 1].q);
  const PlanarPose from = BaseOf(in.plan.whole_body.q.front()), to = BaseOf(in.plan.whole_body.q.back());
  const double end = in.series.measured.back().time_s;
  std::vector<Measurement> rows;
  rows.push_back({"fell", in.fall.fell ? 1.0 : 0.0, {}, {}, ""});
  if (in.fall.fell) {
    rows.back().at_s = in.fall.time_s;
    rows.push_back({"time_to_fall_s", in.fall.time_s - in.log.start_s, {}, in.fall.time_s, ""});
  } else {
    rows.push_back({"time_to_fall_s", {}, {}, {}, "the robot did not fall"});
  }
  rows.push_back({"distance_m", Distance(last, first), Distance(to, from), end, ""});
  rows.push_back({"goal_error_m", Distance(last, in.plan.goal), Distance(to, in.plan.goal), end, ""});
  rows.push_back({"heading_error_rad", Turn(last, in.plan.goal), Turn(to, in.plan.goal), end, ""});
  return rows;
}

}  // namespace gaitwright
