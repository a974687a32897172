// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kinematics/model/robot_model.h"
#include "planning/plan/terrain.h"
#include "playback/engine/world_options.h"

namespace gaitwright {

/// Bumps: ValueNoise around `start` within [-amplitude, amplitude], times a factor that is 0 up to the distance
/// `free_radius` and rises to 1 half a wavelength further out.
struct Bumps {
  Vector2 start = Vector2::Zero();
  double amplitude = 0.0, wavelength = 0.4, free_radius = 0.0;
  std::uint64_t seed = 1;

  /// Height at a place of the ground before the slope is applied [m].
  double HeightAt(const Vector2& p_W) const;
};

/// The bumps of a playback that starts at the configuration q; amplitude zero without bumps.
Bumps BumpsOf(const RobotModel& model, const VectorX& q, const WorldOptions& options);

/// @throws InvalidArgument if bumps would cover more ground than is accepted.
void CheckBumps(const WorldOptions& options);

/// The whole ground of the terrain with bumps, within the bounds of the options.
HeightField BumpyGround(const Terrain& terrain, const WorldOptions& options, const Bumps& bumps);

}  // namespace gaitwright
