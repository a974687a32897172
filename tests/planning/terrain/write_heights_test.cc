// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/write_heights.h"

#include <algorithm>
#include <cmath>

#include "planning/terrain/read_png.h"
#include "tests/planning/terrain/terrain_files.h"
#include "tests/planning/terrain/written_terrain.h"

namespace gaitwright {
namespace {

using terrain_files::Loaded;
using terrain_files::Says;
using terrain_files::Written;
using written_terrain::BuiltIn;
using written_terrain::Hills;
using written_terrain::PlacesOn;
using written_terrain::Rectangle;

WrittenGround WrittenPng(const Terrain& terrain) {
  const Result<WrittenGround> written = WriteHeights(terrain);
  EXPECT_TRUE(written.ok()) << written.failure().message;
  return written.ok() ? *written : WrittenGround{};
}

std::string ReasonNoHeights(const Terrain& terrain) {
  const Result<WrittenGround> written = WriteHeights(terrain);
  EXPECT_FALSE(written.ok());
  return written.ok() ? "" : written.failure().message;
}

Terrain MapReadBack(const WrittenGround& written) {
  return Loaded(Written("heights.png", written.bytes) + ":" + written.parameters);
}

double ParameterIn(const WrittenGround& written, const std::string& key) {
  const std::size_t at = written.parameters.find(key + "=");
  return at == std::string::npos ? 0.0 : std::stod(written.parameters.substr(at + key.size() + 1));
}

/// The largest error of a height that was rounded to 16 bits.
double Quantum(const WrittenGround& written) { return 0.5 * ParameterIn(written, "scale_m") / 65535.0 + 1e-9; }

/// Whether all ground around a place belongs to one surface, so that no step is in the cell of a grid.
bool IsOnOneSurface(const Terrain& terrain, const Vector2& p, double around) {
  const int surface = GroundAt(terrain, p).patch;
  for (int i = 0; i < 9; ++i) {
    if (GroundAt(terrain, p + around * Vector2(i % 3 - 1, i / 3 - 1)).patch != surface) return false;
  }
  return surface >= 0;
}

TEST(WriteHeights, EveryBuiltInGroundIsReadBackToTheQuantisation) {
  for (const BuiltInTerrain& entry : BuiltInTerrains()) {
    SCOPED_TRACE(entry.name);
    const Terrain terrain = BuiltIn(entry.name);
    const WrittenGround written = WrittenPng(terrain);
    const Terrain read = MapReadBack(written);
    ASSERT_EQ(read.height_fields.size(), 1U);
    const double resolution = read.height_fields[0].resolution_m;
    EXPECT_LE(resolution, 0.04 + 1e-12) << "40 m by 40 m of ground have just over 4 million points 0.02 m apart";
    int compared = 0;
    for (const Vector2& p : PlacesOn(terrain, 1000)) {
      if (!IsOnOneSurface(terrain, p, resolution)) continue;
      ++compared;
      ASSERT_NEAR(GroundAt(read, p).height_m, GroundAt(terrain, p).height_m, Quantum(written)) << p.transpose();
    }
    EXPECT_GT(compared, 50);
  }
}

TEST(WriteHeights, TheGridIsThatOfAHeightFieldOrFiner) {
  for (const double resolution : {0.07, 0.02, 0.006}) {
    Terrain terrain = FlatTerrain();
    terrain.height_fields = {Hills({0.33, -0.41}, resolution, 23, 17)};
    const WrittenGround written = WrittenPng(terrain);
    const Terrain read = MapReadBack(written);
    const double steps = resolution / read.height_fields.at(0).resolution_m;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    EXPECT_LE(read.height_fields[0].resolution_m, 0.02);
    Terrain field_alone;
    field_alone.height_fields = terrain.height_fields;
    for (const Vector2& p : PlacesOn(field_alone, 1000))
      ASSERT_NEAR(GroundAt(read, p).height_m, GroundAt(terrain, p).height_m, Quantum(written)) << p.transpose();
  }
}

TEST(WriteHeights, LevelGroundIsBlackAtItsHeight) {
  Terrain terrain = FlatTerrain(0.6);
  terrain.patches[0].X_WT.translation().z() = 0.25;
  const WrittenGround written = WrittenPng(terrain);
  EXPECT_TRUE(Says(written.notes.at(0), "'ground' is cut to x from -5 to 5 m and y from -5 to 5 m"));
  const Terrain read = MapReadBack(written);
  const HeightField& field = read.height_fields.at(0);
  EXPECT_EQ(field.columns, 501);
  EXPECT_EQ(field.rows, 501);
  EXPECT_EQ(field.friction, 0.6);
  EXPECT_TRUE(std::all_of(field.height_m.begin(), field.height_m.end(), [](double h) { return h == 0.25; }));
  EXPECT_NEAR(field.origin_W.x(), -5.0, 1e-9);
}

TEST(WriteHeights, PlacesWithoutGroundAreDeepAndObstaclesAreLeftOut) {
  Terrain terrain;
  terrain.patches = {Rectangle("here", {0, 0}, {1, 1}, 0.0), Rectangle("there", {2, 0}, {3, 1}, 0.3)};
  terrain.obstacles.emplace_back();
  terrain.obstacles[0].size_m = Vector3(0.2, 0.2, 2.0);
  terrain.obstacles[0].X_WO.translation() = Vector3(0.5, 0.5, 1.0);
  const WrittenGround written = WrittenPng(terrain);
  const Terrain read = MapReadBack(written);
  EXPECT_NEAR(GroundAt(read, {0.5, 0.5}).height_m, 0.0, Quantum(written));
  EXPECT_NEAR(GroundAt(read, {1.5, 0.5}).height_m, -kSolidDepth, Quantum(written));
  EXPECT_NEAR(GroundAt(read, {2.5, 0.5}).height_m, 0.3, Quantum(written));
  ASSERT_EQ(written.notes.size(), 2U);
  EXPECT_TRUE(Says(written.notes[0], "1 m below the lowest ground"));
  EXPECT_TRUE(Says(written.notes[1], "obstacles are left out (1)"));
}

TEST(WriteHeights, LargeGroundHasACoarserGrid) {
  Terrain terrain;
  terrain.patches = {PatchThrough("field", {{0, 0, 0}, {200, 0, 5}, {200, 100, 5}, {0, 100, 0}}, 0.8)};
  const WrittenGround written = WrittenPng(terrain);
  EXPECT_EQ(ParameterIn(written, "resolution_m"), 0.08);
  const Terrain read = MapReadBack(written);
  EXPECT_EQ(read.height_fields.at(0).columns, 2501);
  for (const Vector2& p : PlacesOn(terrain, 300))
    ASSERT_NEAR(GroundAt(read, p).height_m, 0.025 * p.x(), Quantum(written));
  terrain.patches = {Rectangle("lane", {0, 0}, {100, 0.5}, 0.0)};
  EXPECT_EQ(ParameterIn(WrittenPng(terrain), "resolution_m"), 0.04) << "at most 4096 points a side";
  terrain.patches = {Rectangle("tile", {0, 0}, {0.03, 0.005}, 0.0)};
  EXPECT_EQ(MapReadBack(WrittenPng(terrain)).height_fields.at(0).rows, 2) << "what is smaller than a cell has one";
}

TEST(WriteHeights, RefusesWhatCannotBeReadBack) {
  EXPECT_TRUE(Says(ReasonNoHeights({}), "no surfaces"));
  Terrain terrain;
  terrain.patches = {Rectangle("low", {0, 0}, {1, 1}, -40.0), Rectangle("high", {1, 0}, {2, 1}, 40.0)};
  EXPECT_TRUE(Says(ReasonNoHeights(terrain), "rises by 80 m"));
  terrain.patches = {Rectangle("low", {0, 0}, {1, 1}, 0.0), Rectangle("high", {1, 0}, {2, 1}, 30.0)};
  EXPECT_TRUE(Says(ReasonNoHeights(terrain), "a step of 30 m"));
  terrain.patches = {Rectangle("plain", {0, 0}, {3000, 3000}, 0.0)};
  EXPECT_TRUE(Says(ReasonNoHeights(terrain), "3000 by 3000 m large"));
}

}  // namespace
}  // namespace gaitwright
