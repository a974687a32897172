// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

/// A planned or measured motion as rows over time in the orders of RobotModel. Exports write it and comparisons read
/// it. A missing column is an empty list; a missing single value is NaN.
struct MotionRows {
  std::vector<double> time_s;    ///< increasing
  std::vector<VectorX> q, v;     ///< sizes 7 + n and 6 + n
  std::vector<VectorX> a;        ///< size 6 + n; plans only
  std::vector<VectorX> tau;      ///< size n; for a log: means over the log's interval before the row
  std::vector<FootSet> contact;  ///< feet on the ground
  std::vector<std::vector<ContactWrench>> wrenches;  ///< by foot; for a log: means, as for torques

  int size() const { return static_cast<int>(time_s.size()); }
};

/// The rates at which a motion may be sampled [Hz].
inline constexpr double kLowestRate = 0.1, kHighestRate = 10000.0;

/// Choice of the last uniform time: the last one not after the end, or the first one not before it.
enum class LastTime { kBeforeEnd, kBehindEnd };

/// The times start + k / rate to an end; all steps are equal. @throws InvalidArgument for a rate out of range.
std::vector<double> TimesAtRate(double start_s, double end_s, double rate_hz, LastTime last = LastTime::kBeforeEnd);

/// The rate of the plan's grid; if it is below 200 Hz, its smallest multiple of at least 200 Hz.
double UsualRate(const MotionPlan& plan);

/// The plan at TimesAtRate, interpolated by SampleWholeBody, with the scheduled contacts (a foot that touches down at
/// the time is in contact). If the plan's end is not among the times, one more row has its last posture at rest.
/// @throws InvalidArgument if the plan does not fit the robot.
MotionRows RowsOfPlan(const RobotModel& model, const MotionPlan& plan, double rate_hz);

/// One cycle of a plan.
struct CycleRows {
  MotionRows rows;           ///< the last one is the first one a cycle later
  double rate_hz = 0.0;      ///< nearest to the one asked for that has whole steps in a cycle
  double joints = 0.0;       ///< largest difference of a joint of the last row from the first [rad], [m]
  double joint_rates = 0.0;  ///< the same of its rate [rad/s], [m/s]
};

/// The cycle of the plan's longest steady stretch (SteadyStretchOf) that repeats most exactly, as RowsOfPlan.
/// @throws InvalidArgument if the plan has none or does not fit the robot.
CycleRows RowsOfCycle(const RobotModel& model, const MotionPlan& plan, double rate_hz);

/// The samples of the log at its own rate, unchanged. At a lower rate, postures, speeds, torques and forces are
/// interpolated linearly between samples (the base rotation by the shortest turn), and contacts are those of the sample
/// before. A rest after the last whole step is left out, since the log has no data beyond its end.
/// @throws InvalidArgument for a rate above the log's, since nothing is known between its samples, and if the log does
/// not fit the robot.
MotionRows RowsOfLog(const RobotModel& model, const PlaybackLog& log, double rate_hz);

/// Values of the rows at one time.
struct RowSample {
  VectorX q, v, tau;
  FootSet contact = 0;
  std::vector<ContactWrench> wrenches;
};

/// Interpolates the rows at a time as above into `sample`; beyond an end, the last row at rest. No allocation once the
/// sample has its sizes. @pre at least one row.
void SampleRows(const MotionRows& rows, double time_s, RowSample& sample);

}  // namespace gaitwright
