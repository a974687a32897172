// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kinematics/model/robot_model.h"
#include "planning/plan/terrain.h"
#include "playback/engine/world_options.h"

namespace gaitwright {

/// Bumps: ValueNoise about `start` within [-amplitude, amplitude], times a rise from zero at `free_radius` from there
/// to one half a wavelength further.
struct Bumps {
  Vector2 start = Vector2::Zero();
  double amplitude = 0.0, wavelength = 0.4, free_radius = 0.0;
  std::uint64_t seed = 1;

  /// At a place of the ground before a slope turns it [m].
  double HeightAt(const Vector2& p_W) const;
};

/// The bumps of a playback that starts with the configuration q; with amplitude zero if there are none.
Bumps BumpsOf(const RobotModel& model, const VectorX& q, const WorldOptions& options);

/// @throws InvalidArgument where there are bumps, over more ground than there may be.
void CheckBumps(const WorldOptions& options);

/// All ground of the terrain with bumps on it, as far as the options say.
HeightField BumpyGround(const Terrain& terrain, const WorldOptions& options, const Bumps& bumps);

}  // namespace gaitwright
