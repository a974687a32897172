// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/data_shape.h"
#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A velocity command from a time on.
struct TimedCommand {
  double time_s = 0.0;
  double speed_m_s = 0.0;          ///< forward
  double lateral_speed_m_s = 0.0;  ///< positive to the left
  double yaw_rate_rad_s = 0.0;     ///< positive to the left

  Vector3 AsVector() const { return {speed_m_s, lateral_speed_m_s, yaw_rate_rad_s}; }
  bool operator==(const TimedCommand&) const = default;
};

/// Velocity commands over time: each holds until the next one; the last one holds to the end.
struct VelocityCommands {
  std::vector<TimedCommand> rows = {{}};  ///< one or more, sorted by time; the first is at 0

  const TimedCommand& At(double time_s) const;
  bool operator==(const VelocityCommands&) const = default;
};

/// Structure of a YAML file of commands.
DataShape CommandsFileShape();

/// Reads commands from a CSV with the header `time_s,speed_m_s,lateral_speed_m_s,yaw_rate_rad_s`, where columns but the
/// time may be missing, or from a YAML list of maps with these keys. Failure kBadInput, with the line, for unknown or
/// repeated columns, numbers out of range, times that do not increase or do not begin at 0, more than 100,000 rows.
/// @param source  name of the file in messages; one that ends in .csv is a CSV.
Result<VelocityCommands> ReadCommands(const std::string& text, const std::string& source);

}  // namespace gaitwright
