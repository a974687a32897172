// SPDX-License-Identifier: BSD-3-Clause
#include "cli/terrain_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "planning/plan/built_in_terrain.h"
#include "tests/playback/xml_check.h"

namespace gaitwright::cli {
namespace {

int TimesInPicture(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

Obstacle BoxAt(const std::string& name, const Vector3& centre, const Vector3& size) {
  Obstacle obstacle;
  obstacle.name = name;
  obstacle.X_WO.translation() = centre;
  obstacle.size_m = size;
  return obstacle;
}

TEST(TerrainPictures, AreWellFormedAndTheSameForTheSameGround) {
  Terrain ground = FlatTerrain();
  ground.name = "a < b & \"c\"";
  const std::string svg = TerrainPicture(ground, {});
  EXPECT_EQ(XmlFault(svg), "");
  EXPECT_EQ(svg, TerrainPicture(ground, {}));
  EXPECT_EQ(TimesInPicture(svg, "a &lt; b &amp; "), 1);
  EXPECT_EQ(TimesInPicture(svg, "nan"), 0);
  EXPECT_EQ(TimesInPicture(svg, "inf"), 0);
}

TEST(TerrainPictures, WhatStandsOnTheGroundIsDarkAndWhatHangsIsPale) {
  Terrain ground = FlatTerrain();
  ground.obstacles = {BoxAt("wall", {2.0, 0.0, 0.25}, {0.4, 1.0, 0.5}),
                      BoxAt("lintel", {3.0, 0.0, 1.0}, {0.4, 1.0, 0.2})};
  const std::string svg = TerrainPicture(ground, {});
  EXPECT_EQ(XmlFault(svg), "");
  EXPECT_EQ(TimesInPicture(svg, "<polygon class=\"w\""), 1);
  EXPECT_EQ(TimesInPicture(svg, "<polygon class=\"b\""), 1);
  EXPECT_EQ(TimesInPicture(svg, "<rect class=\"w\""), 2) << "both stand on the line of the section";
  ground.obstacles[0].X_WO.translation().y() = 2.0;
  EXPECT_EQ(TimesInPicture(TerrainPicture(ground, {}), "<rect class=\"w\""), 1);
}

TEST(TerrainPictures, NamesAreWrittenWhereTheyHaveRoom) {
  Terrain ground = FlatTerrain();
  const std::string name = "a_wall_with_a_long_name";
  ground.obstacles = {BoxAt(name, {2.0, 0.0, 0.25}, {2.0, 2.0, 0.5})};
  EXPECT_EQ(TimesInPicture(TerrainPicture(ground, {}), ">" + name + "<"), 1);
  ground.obstacles[0].size_m = Vector3(0.05, 0.05, 0.5);
  EXPECT_EQ(TimesInPicture(TerrainPicture(ground, {}), ">" + name + "<"), 0);
}

TEST(TerrainPictures, TheRobotIsDrawnFromAboveAndFromTheSide) {
  const std::string svg = TerrainPicture(FlatTerrain(), {});
  EXPECT_EQ(TimesInPicture(svg, "<polygon class=\"r\""), 2) << "its body and where it faces";
  EXPECT_EQ(TimesInPicture(svg, "<rect class=\"r\""), 1);
}

/// Without ground, the section has a gap and the top view is hatched.
TEST(TerrainPictures, AGapInTheGroundIsNoLine) {
  Terrain ground;
  ground.name = "gap";
  for (const double x : {-1.0, 1.0}) {
    ground.patches.push_back(PatchThrough(
        "half", {{x - 0.8, -1.0, 0.0}, {x + 0.8, -1.0, 0.0}, {x + 0.8, 1.0, 0.0}, {x - 0.8, 1.0, 0.0}}, 0.8));
  }
  const std::string svg = TerrainPicture(ground, {});
  EXPECT_EQ(XmlFault(svg), "");
  EXPECT_EQ(TimesInPicture(svg, "<polyline class=\"l\""), 2);
  EXPECT_GT(TimesInPicture(svg, "url(#none)"), 0);
  EXPECT_EQ(TimesInPicture(TerrainPicture(FlatTerrain(), {}), "<polyline class=\"l\""), 1);
}

TEST(TerrainPictures, EveryBuiltInGroundHasOne) {
  for (const std::string name : {"flat", "stairs"}) {
    const Result<Terrain> ground = MakeTerrain(name, {});
    ASSERT_TRUE(ground.ok()) << name;
    const std::string svg = TerrainPicture(*ground, {});
    EXPECT_EQ(XmlFault(svg), "") << name;
    EXPECT_GT(TimesInPicture(svg, "z [m]"), 0) << name;
  }
}

}  // namespace
}  // namespace gaitwright::cli
