// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "workflows/live/live_requests.h"

namespace gaitwright {

/// Data of a frame besides those of the world.
struct LiveStatus {
  LiveClock clock;
  double behind_s = 0.0;                                ///< lag of the simulated clock behind real time
  std::vector<std::pair<int, std::string>> notes = {};  ///< latest events, by number
};

/// First message to a page, as JSON: robot and ground as in the viewer, gaits, options (docs/live.md).
/// @param mesh_folder  folder of the URDF, to find visual meshes.
std::string LiveGreeting(const LiveWorld& live, const std::optional<std::string>& mesh_folder = {});

/// Second message to a page, as JSON: its number.
std::string LivePageNumber(std::uint64_t page);

/// Present state, as JSON: robot state, planned state, mean forces since the last frame, balance, targets, notes.
std::string LiveFrame(LiveWorld& live, const LiveStatus& status);

/// Message to a page whose request was refused, as JSON.
std::string LiveRefusal(const std::string& why);

}  // namespace gaitwright
