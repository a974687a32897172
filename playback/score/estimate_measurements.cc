// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "playback/score/measurements.h"

namespace gaitwright {

EstimateError ErrorOf(const LogSample& sample) {
  const BaseEstimate& estimate = *sample.estimate;
  const Matrix3 R_true = BaseRotation(sample.q), R_WB = estimate.R_WB.toRotationMatrix();
  const Vector3 off_W = estimate.p_WB - sample.q.head<3>();
  const Vector3 up_B = R_WB.row(2), true_up_B = R_true.row(2);
  EstimateError error;
  error.horizontal_m = off_W.head<2>().norm();
  error.height_m = off_W.z();
  error.tilt_rad = std::atan2(up_B.cross(true_up_B).norm(), up_B.dot(true_up_B));
  error.heading_rad = WrapAngle(YawOf(R_WB) - YawOf(R_true));
  error.velocity_m_s = (R_WB.transpose() * estimate.v_WB - R_true.transpose() * sample.v.head<3>()).norm();
  return error;
}

std::vector<Measurement> EstimateMeasurements(const ScoreInputs& in) {
  Extreme height(Extreme::Kind::kLargest), tilt(Extreme::Kind::kLargest), heading(Extreme::Kind::kLargest);
  double drift = 0.0, squares = 0.0, end_s = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < in.series.measured.size(); ++k) {
    const LogSample& sample = in.log.samples[k];
    if (!sample.estimate) continue;
    const EstimateError error = ErrorOf(sample);
    height.See(std::abs(error.height_m), sample.time_s);
    tilt.See(error.tilt_rad, sample.time_s);
    heading.See(std::abs(error.heading_rad), sample.time_s);
    drift = error.horizontal_m;
    squares += error.velocity_m_s * error.velocity_m_s;
    end_s = sample.time_s;
    ++count;
  }
  const std::string missing = "the controller had the base's true state";
  if (count == 0) {
    std::vector<Measurement> none;
    for (const char* key : {"estimate_drift_m", "estimate_height_m", "estimate_tilt_rad", "estimate_heading_rad",
                            "estimate_velocity_m_s"})
      none.push_back({key, {}, {}, {}, missing});
    return none;
  }
  return {{"estimate_drift_m", drift, {}, end_s, ""},
          FromExtremes("estimate_height_m", height, Extreme(Extreme::Kind::kLargest), missing),
          FromExtremes("estimate_tilt_rad", tilt, Extreme(Extreme::Kind::kLargest), missing),
          FromExtremes("estimate_heading_rad", heading, Extreme(Extreme::Kind::kLargest), missing),
          {"estimate_velocity_m_s", std::sqrt(squares / count), {}, {}, ""}};
}

}  // namespace gaitwright
