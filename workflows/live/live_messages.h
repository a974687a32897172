// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/live/live_world.h"

namespace gaitwright {

/// What people do to time.
struct LiveClock {
  bool paused = false;
  int steps = 0;  ///< to be done though it is paused
};

/// Longest message that is taken [byte], and most that are kept for one picture.
inline constexpr std::size_t kLongestLiveMessage = 65536, kMostLiveMessages = 256;

/// What the page is told first, as JSON: robot and ground as the viewer has them, gaits, limits, options
/// (docs/live.md).
std::string LiveGreeting(const LiveWorld& live);

/// How things stand now, as JSON: state, plan beside it, forces, balance, targets, and what happened since the last
/// one.
/// @param behind_s  how far the simulated clock is behind the wall's.
std::string LiveFrame(LiveWorld& live, const LiveClock& clock, double behind_s, const std::vector<std::string>& notes);

/// Does what a message of a page says.
/// @throws InvalidArgument, in words for people, for what is no such message or out of range; then nothing is done.
void ApplyLiveMessage(const std::string& message, LiveWorld& live, LiveClock& clock);

}  // namespace gaitwright
