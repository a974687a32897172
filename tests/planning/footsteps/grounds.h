// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planning/plan/terrain.h"

namespace gaitwright {

/// Grounds for tests of footsteps, for a start at the origin and a path along x.

/// A rectangle x0..x1 by y0..y1 at a height, rising by `rise_m` from x0 to x1.
TerrainPatch Rectangle(const std::string& name, const Vector2& low, const Vector2& high, double height_m,
                       double rise_m = 0.0);

/// Steps up, a landing and the same steps down.
Terrain StairsUpAndDown(double first_x_m, double rise_m, double tread_m, int count);
/// Level ground up to x_m, and again from x_m + width_m.
Terrain Gap(double x_m, double width_m);
/// Level ground, a slope along x from x_m on, and level ground again after length_m along x.
Terrain RampUp(double x_m, double length_m, double slope_rad);
/// Level ground with a step up at x_m.
Terrain StepUp(double x_m, double rise_m);
/// Square stones in rows between two platforms, with random offsets.
Terrain Stones(double from_x_m, double to_x_m, double stone_m, double pitch_m, double jitter_m, double width_m,
               double height_jitter_m, std::uint64_t seed);
/// Waves of a few random directions.
Terrain Rough(double from_x_m, double to_x_m, double amplitude_m, double wavelength_m, std::uint64_t seed);
/// Level ground with a wall across the path, with a thickness and a height, and an opening in its middle.
Terrain WallWithOpening(double x_m, double opening_m, double height_m);

}  // namespace gaitwright
