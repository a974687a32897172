// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <stdexcept>

#include "workflows/live/live_world.h"

namespace gaitwright {

/// A world with default options. @throws std::runtime_error if the robot has no default walk.
inline std::unique_ptr<LiveWorld> MadeWorld(const RobotModel& model, const PlayRequest& play) {
  const WalkRequest walk;
  Result<std::unique_ptr<LiveWorld>> made = LiveWorld::Make(model, walk, play);
  if (!made) throw std::runtime_error(made.failure().message);
  return std::move(*made);
}
inline std::unique_ptr<LiveWorld> MadeWorld(const RobotModel& model) {
  const PlayRequest usual;
  return MadeWorld(model, usual);
}

}  // namespace gaitwright
