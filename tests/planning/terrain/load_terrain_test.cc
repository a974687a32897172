// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/load_terrain.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "planning/plan/built_in_terrain.h"
#include "tests/planning/terrain/terrain_files.h"

namespace gaitwright {
namespace {

FailureCode CodeOfRefusal(const std::string& text) {
  const Result<Terrain> terrain = LoadTerrain(text, {});
  EXPECT_FALSE(terrain.ok()) << text;
  if (terrain.ok()) return FailureCode::kInternal;
  EXPECT_EQ(terrain.failure().kind, FailureKind::kBadInput);
  return terrain.failure().code;
}

TEST(TerrainFileOf, IsWhatHasTheEndingOfAFileOrLooksLikeAPath) {
  const std::vector<std::pair<std::string, std::string>> known = {{"flat", ""},
                                                                  {"stairs:rise_m=0.07,count=3", ""},
                                                                  {"stairs:rise_m=.07", ""},
                                                                  {"hill.yaml", "hill.yaml"},
                                                                  {"a/b/hill.CSV", "a/b/hill.CSV"},
                                                                  {"hill.csv:resolution_m=0.1,x_m=1", "hill.csv"},
                                                                  {"scan.PNG:scale_m=0.2", "scan.PNG"},
                                                                  {"c:/grounds/hill.obj", "c:/grounds/hill.obj"},
                                                                  {"./flat", "./flat"},
                                                                  {"hill.txt", "hill.txt"}};
  for (const auto& [text, file] : known) EXPECT_EQ(TerrainFileOf(text), file) << text;
}

TEST(LoadTerrainByName, ABuiltInGroundIsThatOfMakeTerrain) {
  TerrainScale scale;
  scale.leg_length_m = 0.7;
  for (const std::string spec : {"flat", "stairs:count=2", "gap"}) {
    const Terrain loaded = LoadTerrain(spec, scale).value(), made = MakeTerrain(spec, scale).value();
    EXPECT_EQ(loaded.name, spec);
    ASSERT_EQ(loaded.patches.size(), made.patches.size());
    for (std::size_t i = 0; i < made.patches.size(); ++i) {
      EXPECT_EQ(loaded.patches[i].name, made.patches[i].name);
      EXPECT_TRUE(loaded.patches[i].X_WT.isApprox(made.patches[i].X_WT));
    }
  }
  EXPECT_EQ(LoadTerrain("swamp", scale).failure(), MakeTerrain("swamp", scale).failure());
}

TEST(LoadTerrainByName, WhatCannotBeReadIsRefusedByItsKind) {
  using terrain_files::Written;
  const std::string csv = Written("load_terrain_test.csv", "0, 0\n0, 0\n");
  EXPECT_EQ(CodeOfRefusal("hill.txt"), FailureCode::kTerrainKind);
  EXPECT_EQ(CodeOfRefusal(terrain_files::Folder() + "nowhere.csv"), FailureCode::kNoFile);
  EXPECT_EQ(CodeOfRefusal(terrain_files::Folder()), FailureCode::kTerrainKind) << "a folder";
  EXPECT_EQ(CodeOfRefusal(csv + ":resolutoin_m=0.1"), FailureCode::kTerrainParameter);
  EXPECT_EQ(CodeOfRefusal(csv + ":resolution_m=-1"), FailureCode::kTerrainParameter);
  EXPECT_EQ(CodeOfRefusal(csv + ":resolution_m"), FailureCode::kTerrainParameter);
  const std::string yaml = Written("load_terrain_test.yaml", "terrain: flat\n");
  EXPECT_EQ(CodeOfRefusal(yaml + ":friction=0.5"), FailureCode::kTerrainParameter) << "they belong into the file";
}

TEST(LoadTerrainByName, AFileGivesItsNameWithoutFoldersAndWithItsParameters) {
  const std::string path = terrain_files::Written("load_terrain_map.csv", "0.1, 0.2\n0.3, 0.4\n");
  const Terrain plain = LoadTerrain(path + ":resolution_m=0.5", {}).value();
  EXPECT_EQ(plain.name, "load_terrain_map.csv:resolution_m=0.5");
  ASSERT_EQ(plain.height_fields.size(), 1U);
  EXPECT_EQ(plain.height_fields[0].resolution_m, 0.5);
  EXPECT_TRUE(plain.patches.empty());
  EXPECT_EQ(plain.num_surfaces(), 1);
}

TEST(LoadTerrainByName, AMeshIsGroundToo) {
  const std::string path =
      terrain_files::Written("load_terrain_slab.obj", "v 0 0 0.2\nv 2 0 0.2\nv 2 1 0.2\nv 0 1 0.2\nf 1 2 3\nf 1 3 4\n");
  const Result<Terrain> slab = LoadTerrain(path, {});
  ASSERT_TRUE(slab.ok()) << slab.failure().message;
  EXPECT_NEAR(GroundAt(*slab, {1.0, 0.5}).height_m, 0.2, 1e-9);
  EXPECT_EQ(GroundAt(*slab, {3.0, 0.5}).patch, -1);
}

TEST(TerrainFilesOf, AreTheFileAndThoseThatItNames) {
  EXPECT_TRUE(TerrainFilesOf("flat").empty());
  EXPECT_EQ(TerrainFilesOf("a/b.csv:scale_m=2"), std::vector<std::string>{"a/b.csv"});
}

}  // namespace
}  // namespace gaitwright
