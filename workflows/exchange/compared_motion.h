// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/exchange/missing_rows.h"
#include "workflows/exchange/motion_rows.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// The source of one side of a comparison.
enum class ComparedKind { kPlan, kLog, kCsv, kTrajectory };
/// The name in JSON and for the user: `plan`, `log`, `csv` or `trajectory`.
const char* ComparedKindName(ComparedKind kind);

/// One side of a comparison: a plan, a log, or columns of numbers such as a robot's own log.
struct ComparedMotion {
  std::string name;  ///< its name: the file as given
  ComparedKind kind = ComparedKind::kPlan;
  RobotModel model;                                        ///< defines the order of its rows
  std::optional<MotionPlan> plan = {};                     ///< set for a plan
  std::optional<PlaybackLog> log = {};                     ///< set for a log
  MotionRows rows = {};                                    ///< on its own clock; missing values are NaN
  std::vector<std::vector<ContactInterval>> stances = {};  ///< by foot; empty if contacts are unknown
  double torque_age_s = 0.0;                               ///< age of a row's torque, which is a mean over an interval
  VectorX resolution = {};                                 ///< encoder step by dof; 0 if none is detected
  std::vector<bool> derived_speeds = {};                   ///< by dof: computed from positions; empty if none is
  double longest_step_s = INFINITY;                        ///< longest step between measured rows without missing rows
  std::vector<TimeGap> gaps = {};                          ///< intervals with missing rows
  std::vector<std::string> notes = {};                     ///< notes on its interpretation

  double start_s() const { return rows.time_s.front(); }
  double end_s() const { return rows.time_s.back(); }
  /// Whether it was measured, with its own clock and noise, rather than planned or played by this program.
  bool foreign() const { return !plan && !log; }
  /// Whether it has a joint's position.
  bool HasJoint(int dof) const { return std::isfinite(rows.q.front()[7 + dof]); }
  double ResolutionOf(int dof) const { return dof < resolution.size() ? resolution[dof] : 0.0; }
  bool derives_speed(int dof) const { return !derived_speeds.empty() && derived_speeds[static_cast<std::size_t>(dof)]; }
};

/// @throws InvalidArgument if plan, log or table do not fit the robot, or have no rows.
ComparedMotion ComparedPlan(const RobotModel& model, const MotionPlan& plan, const std::string& name);
ComparedMotion ComparedLog(const RobotModel& model, const PlaybackLog& log, const std::string& name);

/// The step [rad or m] that measured positions are whole multiples of; 0 for fewer than 16 steps, or positions that
/// span fewer steps, such as those of a joint that rests except for a jump.
double ResolutionOf(const std::vector<double>& positions);

/// One side from columns of numbers; the position of a missing joint is NaN. Missing speeds are derived from the
/// parabola through each row and its neighbours, or from the line through two rows at an end and beside missing rows; a
/// speed beyond kLargestDerived is refused.
ComparedMotion ComparedTable(const RobotModel& model, const MotionTable& table, const std::string& name);

/// As above for an external table, with checks. Failure kBadInput `motion`, which names the file, if CheckComparedTable
/// or ComparedTable refuses it.
Result<ComparedMotion> CheckedTable(const RobotModel& model, const ImportOptions& options, const MotionTable& table,
                                    const std::string& name);

/// Standard deviation of a derived speed of ComparedTable at a time, divided by that of the positions [1/s]:
///   sqrt(1 / 2) / h  between rows h apart, twice as much at an end and beside rows farther apart than
///   `longest_step_s`;
/// the larger value of the two neighbouring rows.
double NoiseGain(const std::vector<double>& time_s, double at_s, double longest_step_s = INFINITY);

/// The motion at a time of its own clock: a plan by SampleWholeBody, everything else by SampleRows, with NaN if rows
/// are missing. The torque is the one at that time, as far as the rows show. No allocation once `sample` has its sizes.
void SampleCompared(const ComparedMotion& motion, double time_s, RowSample& sample);

}  // namespace gaitwright
