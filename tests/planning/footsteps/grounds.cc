// SPDX-License-Identifier: BSD-3-Clause
#include "grounds.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace gaitwright {
namespace {

constexpr double kFar = 20.0, kSide = 5.0;  // [m]

/// Uniform in [0, 1), equal on all platforms.
double Uniform(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11U) * 0x1.0p-53; }

}  // namespace

TerrainPatch Rectangle(const std::string& name, const Vector2& low, const Vector2& high, double height_m,
                       double rise_m) {
  TerrainPatch patch;
  patch.name = name;
  const double run = high.x() - low.x(), pitch = std::atan2(rise_m, run), half_width = 0.5 * (high.y() - low.y());
  patch.X_WT.linear() = Eigen::AngleAxisd(-pitch, Vector3::UnitY()).toRotationMatrix();
  patch.X_WT.translation() = Vector3(low.x(), 0.5 * (low.y() + high.y()), height_m);
  const double length = std::hypot(run, rise_m);
  patch.outline_T = {{0.0, -half_width}, {length, -half_width}, {length, half_width}, {0.0, half_width}};
  return patch;
}

Terrain StairsUpAndDown(double first_x_m, double rise_m, double tread_m, int count) {
  Terrain terrain;
  terrain.name = "stairs";
  terrain.patches.push_back(Rectangle("start", {-kFar, -kSide}, {first_x_m, kSide}, 0.0));
  double x = first_x_m;
  for (int i = 1; i < 2 * count; ++i) {
    const double height = rise_m * (i <= count ? i : 2 * count - i);
    const double depth = i == count ? 4.0 * tread_m : tread_m;
    terrain.patches.push_back(Rectangle("tread" + std::to_string(i), {x, -kSide}, {x + depth, kSide}, height));
    x += depth;
  }
  terrain.patches.push_back(Rectangle("end", {x, -kSide}, {x + kFar, kSide}, 0.0));
  return terrain;
}

Terrain Gap(double x_m, double width_m) {
  Terrain terrain;
  terrain.name = "gap";
  terrain.patches = {Rectangle("near", {-kFar, -kSide}, {x_m, kSide}, 0.0),
                     Rectangle("far", {x_m + width_m, -kSide}, {kFar, kSide}, 0.0)};
  return terrain;
}

Terrain RampUp(double x_m, double length_m, double slope_rad) {
  Terrain terrain;
  terrain.name = "ramp";
  const double rise = length_m * std::tan(slope_rad);
  terrain.patches = {Rectangle("low", {-kFar, -kSide}, {x_m, kSide}, 0.0),
                     Rectangle("ramp", {x_m, -kSide}, {x_m + length_m, kSide}, 0.0, rise),
                     Rectangle("high", {x_m + length_m, -kSide}, {kFar, kSide}, rise)};
  return terrain;
}

Terrain StepUp(double x_m, double rise_m) {
  Terrain terrain;
  terrain.name = "step";
  terrain.patches = {Rectangle("low", {-kFar, -kSide}, {x_m, kSide}, 0.0),
                     Rectangle("high", {x_m, -kSide}, {kFar, kSide}, rise_m)};
  return terrain;
}

Terrain Stones(double from_x_m, double to_x_m, double stone_m, double pitch_m, double jitter_m, double width_m,
               double height_jitter_m, std::uint64_t seed) {
  Terrain terrain;
  terrain.name = "stones";
  terrain.patches = {Rectangle("near", {-kFar, -kSide}, {from_x_m, kSide}, 0.0),
                     Rectangle("far", {to_x_m, -kSide}, {kFar, kSide}, 0.0)};
  std::mt19937_64 engine(seed);
  const auto off = [&](double most) { return most * (2.0 * Uniform(engine) - 1.0); };
  const double gap = 0.5 * (pitch_m - stone_m);
  for (double x = from_x_m + gap; x + stone_m <= to_x_m; x += pitch_m) {
    for (double y = -0.5 * width_m; y + stone_m <= 0.5 * width_m; y += pitch_m) {
      const Vector2 low(x + off(jitter_m), y + off(jitter_m));
      terrain.patches.push_back(Rectangle("stone" + std::to_string(terrain.patches.size()), low,
                                          low + Vector2::Constant(stone_m), off(height_jitter_m)));
    }
  }
  return terrain;
}

Terrain Rough(double from_x_m, double to_x_m, double amplitude_m, double wavelength_m, std::uint64_t seed) {
  constexpr int kWaves = 6;
  std::mt19937_64 engine(seed);
  std::array<Vector3, kWaves> waves;  // wave vector and phase
  for (Vector3& wave : waves) {
    const double direction = 2.0 * std::numbers::pi * Uniform(engine);
    const double number = 2.0 * std::numbers::pi / wavelength_m * (0.7 + 0.6 * Uniform(engine));
    wave = {number * std::cos(direction), number * std::sin(direction), 2.0 * std::numbers::pi * Uniform(engine)};
  }
  HeightField field;
  field.name = "rough";
  field.resolution_m = wavelength_m / 12.0;
  field.origin_W = {from_x_m, -2.0};
  field.columns = 1 + static_cast<int>((to_x_m - from_x_m) / field.resolution_m);
  field.rows = 1 + static_cast<int>(4.0 / field.resolution_m);
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      const Vector2 p = field.origin_W + field.resolution_m * Vector2(column, row);
      double height = 0.0;
      for (const Vector3& wave : waves) height += std::sin(wave.dot(Vector3(p.x(), p.y(), 1.0)));
      field.height_m.push_back(amplitude_m / kWaves * height);
    }
  }
  return {"rough", {}, {field}, {}};
}

Terrain WallWithOpening(double x_m, double opening_m, double height_m) {
  Terrain terrain = FlatTerrain();
  terrain.name = "wall";
  for (const double side : {-1.0, 1.0}) {
    Obstacle wall;
    wall.name = side < 0.0 ? "right wall" : "left wall";
    wall.size_m = Vector3(0.1, kSide, height_m);
    wall.X_WO.translation() = Vector3(x_m, side * 0.5 * (opening_m + kSide), 0.5 * height_m);
    terrain.obstacles.push_back(wall);
  }
  return terrain;
}

}  // namespace gaitwright
