// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

/// A motion as rows over time in the orders of RobotModel: of a plan, or as it was measured. What exports write and
/// comparisons read. A column that there is not is an empty list; a single figure that there is not is not a number.
struct MotionRows {
  std::vector<double> time_s;                        ///< growing
  std::vector<VectorX> q, v;                         ///< sizes 7 + n and 6 + n
  std::vector<VectorX> a;                            ///< size 6 + n; of plans alone
  std::vector<VectorX> tau;                          ///< size n; of a log means over the log's interval before the row
  std::vector<FootSet> contact;                      ///< feet on the ground
  std::vector<std::vector<ContactWrench>> wrenches;  ///< by foot; of a log means as torques are

  int size() const { return static_cast<int>(time_s.size()); }
};

/// The rates at which a motion may be sampled [Hz].
inline constexpr double kLowestRate = 0.1, kHighestRate = 10000.0;

/// Which of even times is the last one: the last that is not after an end, or the first that is not before it.
enum class LastTime { kBeforeEnd, kBehindEnd };

/// The times start + k / rate to an end; all steps are alike. @throws InvalidArgument for a rate out of range.
std::vector<double> TimesAtRate(double start_s, double end_s, double rate_hz, LastTime last = LastTime::kBeforeEnd);

/// The rate of the plan's own grid; where that is coarser than 200 Hz, the least multiple of it that is not.
double UsualRate(const MotionPlan& plan);

/// The plan at TimesAtRate: between its nodes as SampleWholeBody has it, contacts as scheduled (a foot that touches
/// down at the time stands). Where its end is not among the times, one row more has its last posture at rest.
/// @throws InvalidArgument where the plan does not fit the robot.
MotionRows RowsOfPlan(const RobotModel& model, const MotionPlan& plan, double rate_hz);

/// The log's samples as they are at its own rate. At a lower rate postures, speeds, torques and forces are interpolated
/// linearly between samples (the base's rotation by the shortest turn), contacts are those of the sample before; what
/// is left behind the last whole step is left out, since a log does not say how it would go on.
/// @throws InvalidArgument for a rate above the log's, since nothing is known between its samples, and where the log
/// does not fit the robot.
MotionRows RowsOfLog(const RobotModel& model, const PlaybackLog& log, double rate_hz);

/// What rows hold at one time.
struct RowSample {
  VectorX q, v, tau;
  FootSet contact = 0;
  std::vector<ContactWrench> wrenches;
};

/// The rows at a time, interpolated as above into `sample`; beyond an end the last row at rest. No allocation once the
/// sample has its sizes. @pre at least one row.
void SampleRows(const MotionRows& rows, double time_s, RowSample& sample);

}  // namespace gaitwright
