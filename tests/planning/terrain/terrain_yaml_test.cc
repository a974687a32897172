// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/terrain_yaml.h"

#include <cmath>

#include "tests/planning/terrain/terrain_files.h"

namespace gaitwright {
namespace {

using terrain_files::Loaded;
using terrain_files::Says;
using terrain_files::Written;

std::string ReasonYamlRefused(const std::string& text) {
  return terrain_files::ReasonRefused(Written("wrong.yaml", text));
}

constexpr char kGood[] = R"(# a yard
patches:
  - {name: lawn, height_m: 0, friction: 0.6}
  - name: ramp
    corners_m: [[1, -1, 0], [2, -1, 0.2], [2, 1, 0.2], [1, 1, 0]]
height_fields:
  - name: gravel
    origin_m: [-1, -0.1]
    resolution_m: 0.1
    heights_m:
      - [0.01, 0.02, 0.03]
      - [0.04, 0.05, 0.06]
      - [0.07, 0.08, 0.09]
files:
  - bed.csv:resolution_m=0.1,x_m=-3
obstacles:
  - {name: wall, type: box, size_m: [1, 0.1, 0.5], position_m: [1, 2, 0.25], yaw_deg: 90}
  - {name: post, type: cylinder, size_m: [0.05, 1]}
  - {name: rock, type: mesh, vertices_m: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}
)";

TEST(TerrainYaml, HoldsEveryKindOfGround) {
  Written("bed.csv", "0.1,0.1\n0.1,0.1\n");
  const Terrain terrain = Loaded(Written("yard.yaml", kGood));
  EXPECT_EQ(terrain.name, "yard.yaml");
  ASSERT_EQ(terrain.patches.size(), 2U);
  EXPECT_EQ(GroundAt(terrain, {50.0, 50.0}).friction, 0.6);
  EXPECT_NEAR(GroundAt(terrain, {1.5, 0.0}).height_m, 0.1, 1e-12);
  EXPECT_NEAR(GroundAt(terrain, {-1.0 + 1e-9, 0.1 - 1e-9}).height_m, 0.01, 1e-8) << "the first row has the highest y";
  EXPECT_NEAR(GroundAt(terrain, {-0.8 - 1e-9, -0.1 + 1e-9}).height_m, 0.09, 1e-8);
  EXPECT_NEAR(GroundAt(terrain, {-3.0, 0.0}).height_m, 0.1, 1e-12) << "a file beside this one";
  ASSERT_EQ(terrain.obstacles.size(), 3U);
  EXPECT_NEAR(std::abs((terrain.obstacles[0].X_WO.linear() * Vector3::UnitX()).y()), 1.0, 1e-12);
  EXPECT_EQ(terrain.obstacles[1].size_m, Vector3(0.05, 1.0, 0.0));
  EXPECT_EQ(terrain.obstacles[2].vertices_O.size(), 4U);
}

TEST(TerrainYaml, MayBeginWithABuiltInGround) {
  const Terrain terrain = Loaded(Written(
      "b.yaml", "builtin: stairs:start_m=1,rise_m=0.05\nobstacles:\n  - {name: a, type: box, size_m: [1, 1, 1]}\n"));
  EXPECT_NEAR(GroundAt(terrain, {1.05, 0.0}).height_m, 0.05, 1e-12);
  EXPECT_EQ(terrain.obstacles.size(), 1U);
}

TEST(TerrainYaml, WhatIsWrongIsNamedWithItsLine) {
  EXPECT_TRUE(Says(ReasonYamlRefused("patchez: []\n"),
                   "line 1: the file has the unknown key 'patchez'; the nearest is 'patches'"));
  EXPECT_TRUE(
      Says(ReasonYamlRefused("patches:\n  - {name: a, height: 0}\n"), "line 2: a patch has the unknown key 'height'"));
  EXPECT_TRUE(Says(ReasonYamlRefused("patches:\n  - {height_m: 0}\n"), "line 2: a patch lacks the key 'name'"));
  EXPECT_TRUE(Says(ReasonYamlRefused("patches:\n  - {name: a}\n"), "needs either 'corners_m' or"));
  EXPECT_TRUE(Says(ReasonYamlRefused("patches:\n  - {name: a, height_m: .nan}\n"), "line 2: height_m is"));
  EXPECT_TRUE(
      Says(ReasonYamlRefused("patches:\n  - {name: a, height_m: 300}\n"), "height_m is 300; accepted: -50 to 50"));
  EXPECT_TRUE(Says(ReasonYamlRefused("patches:\n  - {name: a, height_m: 0, height_m: 1}\n"), "twice"));
  EXPECT_TRUE(
      Says(ReasonYamlRefused("patches:\n  - {name: a, corners_m: [[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]]}\n"),
           "line 2: patch 'a' is not flat"));
  EXPECT_TRUE(Says(ReasonYamlRefused("patches:\n  - {name: a, corners_m: [[0, 0], [1, 0], [1, 1]]}\n"),
                   "has 2 numbers; 3 are"));
  EXPECT_TRUE(Says(ReasonYamlRefused("patches: [}\n"), "not valid YAML from here on"));
  EXPECT_TRUE(Says(ReasonYamlRefused("patches: []\n"), "there is no ground"));
  EXPECT_TRUE(Says(ReasonYamlRefused("- a\n"), "a map of keys is needed"));
  EXPECT_TRUE(Says(ReasonYamlRefused("builtin: stairz\n"), "line 1: there is no terrain 'stairz'"));
  EXPECT_TRUE(Says(ReasonYamlRefused("builtin: flat\nfiles: [none.csv]\n"), "line 2: terrain file"));
  EXPECT_TRUE(Says(ReasonYamlRefused("builtin: flat\nfiles: [wrong.yaml]\n"), "is a YAML file"));
}

TEST(TerrainYaml, FieldsAndObstaclesThatCannotBeAreRefused) {
  const auto field = [](const std::string& rows) {
    return ReasonYamlRefused("height_fields:\n  - {name: a, origin_m: [0, 0], resolution_m: 0.1, heights_m: " + rows +
                             "}\n");
  };
  EXPECT_EQ(field("[[0, 0], [0, 0]]"), "");
  EXPECT_TRUE(Says(field("[[0, 0], [0]]"), "line 2: rows of heights_m have"));
  EXPECT_TRUE(Says(field("[[0, 0]]"), "at least two by two are needed"));
  EXPECT_TRUE(Says(field("[[0, .inf], [0, 0]]"), "heights_m is inf"));
  const auto obstacle = [](const std::string& keys) {
    return ReasonYamlRefused("builtin: flat\nobstacles:\n  - {name: a, " + keys + "}\n");
  };
  EXPECT_EQ(obstacle("type: box, size_m: [1, 1, 1]"), "");
  EXPECT_TRUE(Says(obstacle("type: ball, size_m: [1]"), "type is 'ball'; accepted: 'box', 'cylinder', 'mesh'"));
  EXPECT_TRUE(Says(obstacle("type: box, size_m: [1, 1]"), "size_m has 2 numbers; a box has three edges"));
  EXPECT_TRUE(Says(obstacle("type: box, size_m: [1, 1, 0]"), "size_m is 0; accepted: 0.001"));
  EXPECT_TRUE(Says(obstacle("type: box, vertices_m: []"), "is a box; give 'size_m'"));
  EXPECT_TRUE(Says(obstacle("type: mesh, vertices_m: [[0, 0, 0]]"), "has 1 points; four to"));
}

TEST(LoadTerrain, TellsFilesFromBuiltInGrounds) {
  EXPECT_EQ(TerrainFileOf("a/b.yaml"), "a/b.yaml");
  EXPECT_EQ(TerrainFileOf("b.PNG:resolution_m=0.1"), "b.PNG");
  EXPECT_EQ(TerrainFileOf("b.txt"), "b.txt");
  EXPECT_EQ(TerrainFileOf("stairs:rise_m=0.05"), "");
  EXPECT_TRUE(Says(terrain_files::ReasonRefused("b.txt"), "in an unsupported format; accepted: '.yaml'"));
  EXPECT_TRUE(Says(terrain_files::ReasonRefused("stairz"), "the nearest is 'stairs'"));
  EXPECT_TRUE(
      Says(terrain_files::ReasonRefused(Written("p.yaml", "builtin: flat\n") + ":a=1"), "accepts no parameters"));
  EXPECT_EQ(Loaded("flat").name, "flat");
}

TEST(TerrainYaml, AllFilesThatAGroundIsReadFromAreKnown) {
  using Files = std::vector<std::string>;
  const std::string bed = terrain_files::Folder() + "bed.csv", yard = Written("yard.YAML", kGood);
  EXPECT_EQ(TerrainFilesOf(yard), (Files{yard, bed}));
  EXPECT_EQ(TerrainFilesOf(bed + ":resolution_m=0.1"), (Files{bed}));
  EXPECT_EQ(TerrainFilesOf("stairs:rise_m=0.05"), Files());
  for (const char* broken : {"files: {", "files: 3", "- a", "files: [{a: b}]"}) {
    const std::string path = Written("wrong.yaml", broken);
    EXPECT_EQ(TerrainFilesOf(path), (Files{path})) << broken;
  }
  EXPECT_EQ(TerrainFilesOf("none.yml"), (Files{"none.yml"}));
}

}  // namespace
}  // namespace gaitwright
