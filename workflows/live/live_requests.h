// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "workflows/live/live_world.h"

namespace gaitwright {

/// What people do to time.
struct LiveClock {
  bool paused = false;
  int steps = 0;  ///< to be done though it is paused
};

/// Longest message that is taken [byte], and most that are kept for one picture.
inline constexpr std::size_t kLongestLiveMessage = 65536, kMostLiveMessages = 256;

/// What a page, which the number tells, asks for. @throws InvalidArgument, in words for people, for what this world
/// refuses; then nothing is done.
using LiveRequest = std::function<void(LiveWorld&, LiveClock&, HandId)>;

/// Reads what a page says about that robot (docs/live.md).
/// @throws InvalidArgument, in words for people, for what is no such message or out of range.
LiveRequest ReadLiveRequest(const RobotModel& model, const std::string& message);

/// What pages may change of the controller and its gains: all numbers.
OptionFields LiveOptions(PlayRequest& play);

}  // namespace gaitwright
