// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

/// Difference of one quantity between two playbacks of one plan, B - A, over their common time range.
struct QuantityAgreement {
  std::string quantity, unit;                   ///< "normal force of FL_foot", "N"
  double rms = 0.0, largest = 0.0, at_s = 0.0;  ///< largest magnitude and its time
  double tolerance = 0.0;
  std::optional<double> parts_s = {};  ///< first time at which the difference exceeds the tolerance
  double a = 0.0, b = 0.0;             ///< both values at that time
};

/// Agreement of two playbacks of one plan, such as those of two physics engines.
struct Agreement {
  std::string name_a, name_b;  ///< the engines; "A (...)" and "B (...)" if they are equal
  double start_s = 0.0, end_s = 0.0;
  int samples = 0;
  /// Normal force, slip and depth of each foot, ZMP x and y, position x, y, z and roll, pitch, yaw of the base.
  /// Quantities without a value in either playback are omitted.
  std::vector<QuantityAgreement> quantities;

  /// The quantity that exceeds its tolerance first; null if all differences are within their tolerances.
  const QuantityAgreement* first() const;
};

/// Name of the physics engine of a log; "bullet" for logs without it.
std::string EngineOf(const PlaybackLog& log);

/// Name of an engine in texts: "Bullet" for "bullet", "MuJoCo" for "mujoco"; other names are returned unchanged.
std::string EngineTitle(const std::string& engine);

/// Compares two playbacks at the samples of A; B is interpolated between its samples.
///
/// Forces and depths are means over 50 ms, so that the peak of an impact, which depends on the time step, does not
/// count. Slip is the distance that a foot has slid on the ground since the start. Depth is that of its lowest point
/// below the plan's ground. ZMPs count while the feet of both playbacks carry half of the weight. Tolerances: forces
/// 0.15 m g; ZMP 0.1, base position 0.03, slip 0.02 and depth 0.0006 of the leg length; base angles 0.03 rad.
/// @throws InvalidArgument as MakeMotionSeries does.
Agreement AgreementOf(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& a, const PlaybackLog& b);

/// One line: where the playbacks first differ and by how much, or the largest differences if they agree.
std::string AgreementText(const Agreement& agreement);

/// The object "agreement" of `walk` and `play`: engines, shared time, first, quantities.
std::string AgreementJson(const Agreement& agreement);

}  // namespace gaitwright
