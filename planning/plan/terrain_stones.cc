// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planning/plan/terrain_kinds_internal.h"
#include "planning/plan/value_noise.h"

namespace gaitwright::terrain {
namespace {

/// Smallest odd number of rows with this spacing that is wider than the robot by one row on each side.
int OddRows(double robot_width, double spacing) {
  const int beside = static_cast<int>(std::ceil(0.5 * robot_width / spacing));
  return 2 * std::clamp(beside, 1, 50) + 1;
}

double Start(const TerrainScale& scale) { return Feature(scale).start_m; }

}  // namespace

GapGround::GapGround(const TerrainScale& scale) : start_m(Start(scale)), width_m(Readable(0.12 * scale.leg_length_m)) {}

OptionFields GapGround::Fields() {
  return {StartField(&start_m), LengthField("width_m", &width_m, 5.0, "Width of the trench along the x axis."),
          FrictionField(&friction)};
}

Terrain GapGround::Build() const { return {"", LevelBanks("gap", start_m, start_m + width_m, friction), {}, {}}; }

StonesGround::StonesGround(const TerrainScale& scale)
    : start_m(Start(scale)),
      size_m(Readable(std::max(1.25 * scale.foot_length_m, 0.3 * scale.leg_length_m))),
      spacing_m(Readable(size_m + 0.12 * scale.leg_length_m)),
      jitter_m(Readable(0.02 * scale.leg_length_m)),
      height_jitter_m(Readable(0.02 * scale.leg_length_m)),
      rows(OddRows(scale.stance_width_m, spacing_m)) {}

OptionFields StonesGround::Fields() {
  return {StartField(&start_m),
          LengthField("size_m", &size_m, 5.0, "Edge length of a stone."),
          LengthField("spacing_m", &spacing_m, 5.0, "Distance between the centres of neighbouring stones."),
          {"jitter_m", &jitter_m, "m", 0.0, 2.0, "Largest random shift of a stone along x and y."},
          {"height_jitter_m", &height_jitter_m, "m", 0.0, 1.0, "Largest random shift of a stone up or down."},
          {"count", &count, "1", 1, 500, "Number of stones along the x axis."},
          {"rows", &rows, "1", 1, 101, "Number of parallel rows of stones."},
          SeedField(&seed),
          FrictionField(&friction)};
}

Terrain StonesGround::Build() const {
  const double gap = spacing_m - size_m;
  if (2.0 * jitter_m > gap) {
    throw InvalidArgument(
        fmt::format("stones of size_m {} at spacing_m {} can overlap with jitter_m {}; jitter_m may be {:.4g} at most",
                    size_m, spacing_m, jitter_m, std::max(0.0, std::floor(500.0 * gap) / 1000.0)));
  }
  const double first = start_m + gap, last = first + (count - 1) * spacing_m + size_m;
  Terrain terrain{"", LevelBanks("stones", start_m, last + gap, friction), {}, {}};
  const auto chance = [&](int stone, int what) { return UniformAt(stone, what, static_cast<std::uint64_t>(seed)); };
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < rows; ++j) {
      const int stone = i * rows + j;
      const double x = first + i * spacing_m + jitter_m * chance(stone, 0);
      const double y = (j - 0.5 * (rows - 1)) * spacing_m + jitter_m * chance(stone, 1);
      const double z = height_jitter_m * chance(stone, 2);
      terrain.patches.push_back(PatchOver(fmt::format("stone {}", stone + 1),
                                          {x, x + size_m, y - 0.5 * size_m, y + 0.5 * size_m}, z, z, friction));
    }
  }
  return terrain;
}

BeamGround::BeamGround(const TerrainScale& scale)
    : start_m(Start(scale)),
      width_m(Readable(1.2 * scale.stance_width_m)),
      length_m(Readable(3.0 * scale.body_length_m)) {}

OptionFields BeamGround::Fields() {
  return {StartField(&start_m), LengthField("width_m", &width_m, 100.0, "Width of the beam along the y axis."),
          LengthField("length_m", &length_m, 100.0, "Length of the beam along the x axis."), FrictionField(&friction)};
}

Terrain BeamGround::Build() const {
  const double end = start_m + length_m;
  Terrain terrain{"", LevelBanks("beam", start_m, end, friction), {}, {}};
  terrain.patches.push_back(PatchOver("beam", Across(start_m, end, width_m), 0.0, 0.0, friction));
  return terrain;
}

CinderGround::CinderGround(const TerrainScale& scale)
    : start_m(Start(scale)),
      block_m(Readable(std::max(1.4 * scale.foot_length_m, 0.5 * scale.leg_length_m))),
      height_m(Readable(0.05 * scale.leg_length_m)),
      rows(OddRows(scale.stance_width_m, block_m)) {}

OptionFields CinderGround::Fields() {
  return {StartField(&start_m),
          LengthField("block_m", &block_m, 5.0, "Edge length of a block in plan view."),
          LengthField("height_m", &height_m, 1.0, "Height of one layer of blocks; each cell has one or two layers."),
          {"tilt_deg", &tilt_deg, "deg", 0.0, 45.0,
           "Tilt of the blocks' tops: each is level or tilted forward, backward, left or right."},
          {"count", &count, "1", 1, 200, "Number of blocks along the x axis."},
          {"rows", &rows, "1", 1, 101, "Number of parallel rows of blocks."},
          SeedField(&seed),
          FrictionField(&friction)};
}

Terrain CinderGround::Build() const {
  const double slope = std::tan(tilt_deg * std::numbers::pi / 180.0);
  const std::vector<Vector2> tilts = {{slope, 0.0}, {-slope, 0.0}, {0.0, slope}, {0.0, -slope}, {0.0, 0.0}};
  Terrain terrain = FlatTerrain(friction);
  const auto choice = [&](int block, int what, int of) {
    const double u = 0.5 * (1.0 + UniformAt(block, what, static_cast<std::uint64_t>(seed)));
    return std::min(static_cast<int>(u * of), of - 1);
  };
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < rows; ++j) {
      const int block = i * rows + j;
      const Vector2& tilt = tilts[static_cast<std::size_t>(choice(block, 0, 5))];
      const Vector2 middle(start_m + (i + 0.5) * block_m, (j - 0.5 * (rows - 1)) * block_m);
      const double height = (1 + choice(block, 1, 2)) * height_m + 0.5 * slope * block_m;
      std::vector<Vector3> corners;
      for (const Vector2& corner : {Vector2(-1, -1), Vector2(1, -1), Vector2(1, 1), Vector2(-1, 1)}) {
        const Vector2 at = 0.5 * block_m * corner;
        corners.emplace_back(middle.x() + at.x(), middle.y() + at.y(), height + tilt.dot(at));
      }
      terrain.patches.push_back(PatchThrough(fmt::format("cinder block {}", block + 1), corners, friction));
    }
  }
  return terrain;
}

}  // namespace gaitwright::terrain
