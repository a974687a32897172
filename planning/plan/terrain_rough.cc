// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/terrain_kinds_internal.h"
#include "planning/plan/value_noise.h"

namespace gaitwright::terrain {
namespace {

constexpr double kMostNodes = 1e6;
constexpr double kHeightUnit = 1e-5;  // heights are multiples of this, so that plans stay short [m]

}  // namespace

RoughGround::RoughGround(const TerrainScale& scale)
    : Feature(scale),
      amplitude_m(Readable(0.02 * scale.leg_length_m)),
      wavelength_m(Readable(std::max(scale.leg_length_m, 3.0 * scale.foot_length_m))),
      length_m(Readable(4.0 * scale.body_length_m)),
      resolution_m(Readable(0.05 * wavelength_m)) {}

OptionFields RoughGround::Fields() {
  return With(
      {LengthField("amplitude_m", &amplitude_m, 1.0,
                   "Amplitude of the bumps: half the height between the lowest and the highest point."),
       LengthField("wavelength_m", &wavelength_m, 20.0, "Wavelength of the bumps."),
       LengthField("length_m", &length_m, 100.0, "Length of the rough ground along the x axis."),
       LengthField("resolution_m", &resolution_m, 1.0, "Distance between neighbouring points of the height field."),
       SeedField(&seed)});
}

Terrain RoughGround::Build() const {
  if (resolution_m > 0.25 * wavelength_m) {
    throw InvalidArgument(fmt::format("resolution_m {} is too coarse for wavelength_m {}; at most {} is needed",
                                      resolution_m, wavelength_m, 0.25 * wavelength_m));
  }
  const double cells_x = std::ceil(length_m / resolution_m), cells_y = std::ceil(width_m / resolution_m);
  if (cells_x * cells_y > kMostNodes) {
    throw InvalidArgument(fmt::format("{} m by {} m at resolution_m {} need {:.0f} points; at most {:.0f} are accepted",
                                      length_m, width_m, resolution_m, cells_x * cells_y, kMostNodes));
  }
  HeightField field;
  field.name = "rough";
  field.origin_W << start_m, -0.5 * cells_y * resolution_m;
  field.resolution_m = resolution_m;
  field.columns = static_cast<int>(cells_x) + 1;
  field.rows = static_cast<int>(cells_y) + 1;
  field.friction = friction;
  const double end = resolution_m * std::min(cells_x, cells_y);
  const double rim = std::min(0.5 * wavelength_m, 0.5 * end);  // width of the transition to level ground
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      const int inside = std::min({column, row, field.columns - 1 - column, field.rows - 1 - row});
      const double rise = SmoothStep(std::clamp(inside * resolution_m / rim, 0.0, 1.0)).value;
      const Vector2 p = resolution_m * Vector2(column, row);
      const double noise = ValueNoise(p, wavelength_m, static_cast<std::uint64_t>(seed));
      const double height = rise * amplitude_m * (1.0 + noise);
      field.height_m.push_back(std::round(height / kHeightUnit) * kHeightUnit);
    }
  }
  Terrain terrain = FlatTerrain(friction);
  terrain.height_fields.push_back(std::move(field));
  return terrain;
}

}  // namespace gaitwright::terrain
