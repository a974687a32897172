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

/// All inputs of the measurements. `series` ends at the fall.
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

/// The extreme of a sequence and its time.
class Extreme {
 public:
  enum class Kind { kSmallest, kLargest };
  explicit Extreme(Kind kind) : kind_(kind) {}

  /// Keeps the value if it is the first or more extreme; of equal values, the first is kept.
  void See(double value, double time_s);
  std::optional<double> value, at_s;

 private:
  Kind kind_;
};

/// A measurement from the extremes of measured and planned values.
Measurement FromExtremes(const std::string& key, const Extreme& measured, const Extreme& planned,
                         const std::string& missing);

// Groups of metrics; each returns its rows in any order.
std::vector<Measurement> ProgressMeasurements(const ScoreInputs& in);
std::vector<Measurement> ZmpMeasurements(const ScoreInputs& in);
std::vector<Measurement> BalanceMeasurements(const ScoreInputs& in);
std::vector<Measurement> ContactMeasurements(const ScoreInputs& in);
std::vector<Measurement> JointMeasurements(const ScoreInputs& in);
std::vector<Measurement> EstimateMeasurements(const ScoreInputs& in);

/// Positive joint work in the first samples of a log: the integral of max(tau v, 0) over all joints [J].
double PositiveWork(const PlaybackLog& log, std::size_t samples);

/// Error of the controller's estimate of the base.
struct EstimateError {
  double horizontal_m = 0.0;  ///< in plan view
  double height_m = 0.0;      ///< estimate minus truth
  double tilt_rad = 0.0;      ///< between the up directions, in the axes of the base
  double heading_rad = 0.0;   ///< estimate minus truth, of the base's x direction in plan view
  double velocity_m_s = 0.0;  ///< of the velocities in base axes, so that the heading error does not count
};

/// Errors of a sample with an estimate.
EstimateError ErrorOf(const LogSample& sample);

/// Whether the torque limit of a motor is known.
bool HasTorqueLimit(const Actuator& motor);
/// Whether anything limits a motor. Without a peak effort, the continuous effort limits a warm motor, and the
/// torque-speed curve limits it above the no-load speed.
bool MayBeAtALimit(const Actuator& motor);

/// Share of the planned time on the ground during which the support is a line or a point.
double ShareWithoutArea(const MotionSeries& series);

}  // namespace gaitwright
