// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/terrain.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

TEST(BuiltInTerrains, AreFoundByTheirNamesAndCarryThem) {
  for (const BuiltInTerrain& entry : BuiltInTerrains()) {
    const Result<Terrain> found = FindTerrain(entry.name);
    ASSERT_TRUE(found.ok()) << entry.name;
    EXPECT_EQ(found->name, entry.name);
    EXPECT_EQ(found->patches.size(), entry.terrain.patches.size());
    EXPECT_FALSE(entry.description.empty());
    EXPECT_GE(GroundAt(*found, Vector2::Zero()).patch, 0) << "a robot starts at the origin";
  }
}

TEST(BuiltInTerrains, AnUnknownNameListsWhatThereIs) {
  const Result<Terrain> found = FindTerrain("flatt");
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.failure().code, "unknown_terrain");
  for (const BuiltInTerrain& entry : BuiltInTerrains()) {
    EXPECT_NE(found.failure().message.find("'" + entry.name + "'"), std::string::npos);
  }
}

}  // namespace
}  // namespace gaitwright
