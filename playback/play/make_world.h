// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "playback/engine/world.h"

namespace gaitwright {

/// The engines that this program was built with: "bullet", and "mujoco" if the library was found.
const std::vector<std::string>& EngineNames();

/// Makes a world in the engine that the options name.
/// @throws InvalidArgument as the engine's world does, and for an engine that this program was built without.
std::unique_ptr<World> MakeWorld(const RobotModel& model, const Terrain& terrain, const VectorX& q,
                                 const WorldOptions& options);

}  // namespace gaitwright
