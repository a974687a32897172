// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "workflows/live/live_requests.h"

namespace gaitwright {

/// What a picture tells beside the world.
struct LiveStatus {
  LiveClock clock;
  double behind_s = 0.0;                                ///< how far the simulated clock is behind the wall's
  std::vector<std::pair<int, std::string>> notes = {};  ///< the latest of what happened, by number
};

/// What the page is told first, as JSON: robot and ground as the viewer has them, gaits, options (docs/live.md).
/// @param mesh_folder  of the URDF, to look for visual meshes.
std::string LiveGreeting(const LiveWorld& live, const std::optional<std::string>& mesh_folder = {});

/// What a page is told after that, as JSON: its own number.
std::string LivePageNumber(std::uint64_t page);

/// How things stand now, as JSON: state, plan beside it, forces as means since the last one, balance, targets, notes.
std::string LiveFrame(LiveWorld& live, const LiveStatus& status);

/// What a page is told whose message was refused, as JSON.
std::string LiveRefusal(const std::string& why);

}  // namespace gaitwright
