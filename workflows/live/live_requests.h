// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "workflows/live/live_world.h"

namespace gaitwright {

/// Time control by users.
struct LiveClock {
  bool paused = false;
  int steps = 0;  ///< steps to run while paused
};

/// Longest accepted message [byte], and largest number of messages kept for one frame.
inline constexpr std::size_t kLongestLiveMessage = 65536, kMostLiveMessages = 256;

/// A request of the page with this number. @throws InvalidArgument, with a message for users, if the world refuses it;
/// then nothing changes.
using LiveRequest = std::function<void(LiveWorld&, LiveClock&, HandId)>;

/// Reads a page's message about this robot (docs/live.md).
/// @throws InvalidArgument, with a message for users, for an invalid message or a value out of range.
LiveRequest ReadLiveRequest(const RobotModel& model, const std::string& message);

/// Controller options and gains that pages may change: all numbers.
OptionFields LiveOptions(PlayRequest& play);

}  // namespace gaitwright
