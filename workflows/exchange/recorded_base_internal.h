// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "workflows/exchange/motion_table.h"
#include "workflows/exchange/recorded_topics_internal.h"

namespace gaitwright {

/// Place of a time in a list of increasing times: `before` + `share`.
struct TimePlace {
  std::size_t before = 0;
  double share = 0.0;
};

/// @pre times.front() <= time <= times.back().
TimePlace PlaceAt(const std::vector<std::int64_t>& times, std::int64_t time);

/// The messages in the order of their times; messages at one time keep their order.
std::vector<std::size_t> OrderByTime(const std::vector<std::int64_t>& times);

/// The base over time from nav_msgs/Odometry.
class RecordedBase {
 public:
  /// @param times  of the messages. @throws InvalidArgument for a pose that is not finite or has no unit quaternion,
  /// and for poses of several links.
  RecordedBase(const RecordedSeries<OdometryMessage>& series, const std::vector<std::int64_t>& times,
               std::string topic);

  const std::vector<std::int64_t>& times() const { return times_; }
  int late() const { return late_; }  ///< messages left out because their time is that of another

  /// Adds the pose of the root link at these times to a table that has the joints: positions linearly, rotations by the
  /// shortest turn. If the messages have the pose of another link, the joints give that of the root link.
  /// @pre the times are within times().
  void AddTo(const RobotModel& model, const ImportOptions& options, const std::vector<std::int64_t>& rows,
             MotionTable& table) const;

 private:
  std::string topic_, child_frame_;
  std::vector<std::int64_t> times_;
  std::vector<OdometryMessage> poses_;
  int late_ = 0;
};

}  // namespace gaitwright
