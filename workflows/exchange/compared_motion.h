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

/// One side of a comparison: a plan, a log, or columns of numbers such as a robot's own log.
struct ComparedMotion {
  std::string name;                                        ///< what it is called: the file, as it was given
  std::string kind;                                        ///< "plan", "log", "csv" or "trajectory"
  RobotModel model;                                        ///< whose orders its rows have
  std::optional<MotionPlan> plan = {};                     ///< of a plan
  std::optional<PlaybackLog> log = {};                     ///< of a log
  MotionRows rows = {};                                    ///< on its own clock; what it does not say is not a number
  std::vector<std::vector<ContactInterval>> stances = {};  ///< by foot; empty where nothing is known of contacts
  double torque_age_s = 0.0;                               ///< how far before a row its torque holds: means are late
  VectorX resolution = {};                                 ///< by dof: steps of the encoder; 0 for none that is seen
  std::vector<bool> derived_speeds = {};                   ///< by dof: worked out from positions; empty for none
  double longest_step_s = INFINITY;                        ///< between measured rows of which none is missing
  std::vector<TimeGap> gaps = {};                          ///< where rows are farther apart
  std::vector<std::string> notes = {};                     ///< how it was understood, where that is not plain

  double start_s() const { return rows.time_s.front(); }
  double end_s() const { return rows.time_s.back(); }
  /// Whether it was measured, on a clock of its own and with noise, rather than planned or played here.
  bool foreign() const { return !plan && !log; }
  /// Whether it says where a joint is.
  bool HasJoint(int dof) const { return std::isfinite(rows.q.front()[7 + dof]); }
  double ResolutionOf(int dof) const { return dof < resolution.size() ? resolution[dof] : 0.0; }
  bool derives_speed(int dof) const { return !derived_speeds.empty() && derived_speeds[static_cast<std::size_t>(dof)]; }
};

/// @throws InvalidArgument where plan, log or table do not fit the robot, or have no rows.
ComparedMotion ComparedPlan(const RobotModel& model, const MotionPlan& plan, const std::string& name);
ComparedMotion ComparedLog(const RobotModel& model, const PlaybackLog& log, const std::string& name);

/// The step [rad or m] that measured positions are whole multiples of; 0 for fewer than 16 steps, or positions that
/// span fewer, as of a joint that stands still but for a jump.
double ResolutionOf(const std::vector<double>& positions);

/// Columns of numbers; the position of a joint that they lack is not a number. Speeds that are not given are those of
/// the parabola through each row and its neighbours, at an end and beside missing rows of the line through two; one
/// that comes out beyond kLargestDerived is refused.
ComparedMotion ComparedTable(const RobotModel& model, const MotionTable& table, const std::string& name);

/// The same of a table that somebody else wrote, checked. Failure kBadInput `motion`, naming the file, for what
/// CheckComparedTable and ComparedTable refuse.
Result<ComparedMotion> CheckedTable(const RobotModel& model, const ImportOptions& options, const MotionTable& table,
                                    const std::string& name);

/// The standard deviation of a speed that ComparedTable works out at a time, by that of the positions [1/s]:
///   sqrt(1 / 2) / h  between rows h apart, twice as much at an end and beside rows farther apart than
///   `longest_step_s`;
/// the larger one of the rows on either side.
double NoiseGain(const std::vector<double>& time_s, double at_s, double longest_step_s = INFINITY);

/// The motion at a time of its own clock: a plan between its nodes as SampleWholeBody has it, all else as SampleRows
/// does, and not a number where rows are missing. The torque is the one that holds then, as far as rows tell. No
/// allocation once `sample` has its sizes.
void SampleCompared(const ComparedMotion& motion, double time_s, RowSample& sample);

}  // namespace gaitwright
