// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/actuator.h"
#include "playback/score/fall.h"
#include "playback/score/motion_series.h"

namespace gaitwright {

/// A measured value before the check of its gate.
struct Measurement {
  std::string key;
  std::optional<double> value, planned, at_s;
  std::string missing;  ///< reason of a missing value
};

/// All that measuring needs. `series` ends at the fall.
struct ScoreInputs {
  const RobotModel& model;
  const MotionPlan& plan;
  const PlaybackLog& log;
  const ScoreOptions& options;
  MotionSeries series;
  Fall fall;
  double leg_length_m = 0.0;
  std::vector<Actuator> motors = ActuatorsOf(model);
};

/// The extreme of a sequence and when it came.
class Extreme {
 public:
  enum class Kind { kSmallest, kLargest };
  explicit Extreme(Kind kind) : kind_(kind) {}

  /// Keeps the value when it is the first or beyond the one kept; of equal ones the first.
  void See(double value, double time_s);
  std::optional<double> value, at_s;

 private:
  Kind kind_;
};

/// A measurement from extremes of what was measured and planned.
Measurement FromExtremes(const std::string& key, const Extreme& measured, const Extreme& planned,
                         const std::string& missing);

// Groups of rows of metrics.md; each returns its rows in any order.
std::vector<Measurement> ProgressMeasurements(const ScoreInputs& in);
std::vector<Measurement> ZmpMeasurements(const ScoreInputs& in);
std::vector<Measurement> BalanceMeasurements(const ScoreInputs& in);
std::vector<Measurement> ContactMeasurements(const ScoreInputs& in);
std::vector<Measurement> JointMeasurements(const ScoreInputs& in);
std::vector<Measurement> EstimateMeasurements(const ScoreInputs& in);

/// What the motors gave in the first samples of a log: the integral of max(tau v, 0) over all joints [J].
double PositiveWork(const PlaybackLog& log, std::size_t samples);

/// How far the base that a controller took for true is from the true one.
struct EstimateError {
  double horizontal_m = 0.0;  ///< in plan view
  double height_m = 0.0;      ///< estimate less truth
  double tilt_rad = 0.0;      ///< between the up directions, in the axes of the base
  double heading_rad = 0.0;   ///< estimate less truth, of where the base's x points in plan view
  double velocity_m_s = 0.0;  ///< of the velocities in the axes of the base: the heading does not count
};

/// Of a sample with an estimate.
EstimateError ErrorOf(const LogSample& sample);

/// Whether the torque limit of a motor is known.
bool HasTorqueLimit(const Actuator& motor);
/// Whether anything may hold a motor back. Without a peak its continuous effort does, once it is warm, and its curve
/// from the no-load speed on.
bool MayBeAtALimit(const Actuator& motor);

/// Share of the planned time on the ground in which the support is a line or a point.
double ShareWithoutArea(const MotionSeries& series);

}  // namespace gaitwright
