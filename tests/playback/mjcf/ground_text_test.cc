// SPDX-License-Identifier: BSD-3-Clause
// The text of a ground without a robot; MuJoCo reads it in tests/playback/mujoco/model_file_test.cc.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

#include "playback/mjcf/model_file.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

/// The text in quotes after each `before`.
std::vector<std::string> Quoted(const std::string& text, const std::string& before) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
    at += before.size();
    found.push_back(text.substr(at, text.find('"', at) - at));
  }
  return found;
}

Terrain Yard() {
  HeightField field;
  field.name = "bed";
  field.columns = 3;
  field.rows = 2;
  field.friction = 0.5;
  field.height_m = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5};
  Terrain yard = FlatTerrain(0.7);
  yard.name = "a & b";
  yard.patches.push_back(PatchThrough("stone", {{1, 0, 0.1}, {2, 0, 0.1}, {2, 1, 0.1}, {1, 1, 0.1}}, 0.6));
  yard.patches.push_back(yard.patches.back());
  yard.height_fields = {field, field};
  yard.obstacles = {{"<wall>", ShapeType::kBox, Pose::Identity(), {1.0, 1.0, 1.0}, {}}};
  return yard;
}

TEST(MujocoGround, HasAGeomForEachPartByItsName) {
  const std::vector<OutputFile> files = MujocoGroundFiles(Yard(), "out/yard.xml");
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files[0].path, "out/yard.xml");
  EXPECT_EQ(files[1].path, "out/yard_field0.bin");
  const std::string& text = files[0].text;
  EXPECT_EQ(XmlFault(text), "");
  EXPECT_TRUE(text.starts_with("<mujoco model=\"a &amp; b\">"));
  EXPECT_EQ(Quoted(text, "<geom name=\""),
            (std::vector<std::string>{"&lt;wall&gt;", "ground", "stone", "stone 2", "bed", "bed 2"}));
  EXPECT_EQ(Quoted(text, "friction=\""),
            (std::vector<std::string>{"0.80000000000000004 0 0", "0.69999999999999996 0 0", "0.59999999999999998 0 0",
                                      "0.59999999999999998 0 0", "0.5 0 0", "0.5 0 0"}));
  EXPECT_EQ(Quoted(text, "file=\""), (std::vector<std::string>{"yard_field0.bin", "yard_field1.bin"}));
  for (const char* others : {"<option", "<compiler", "<default", "<size"})
    EXPECT_EQ(text.find(others), std::string::npos) << "would change a file that includes this one: " << others;
}

TEST(MujocoGround, HeightsAreInMujocosFormat) {
  const std::string bytes = MujocoGroundFiles(Yard(), "yard.xml").at(1).text;
  ASSERT_EQ(bytes.size(), 8U + 6U * 4U);
  std::int32_t rows = 0, columns = 0;
  std::memcpy(&rows, bytes.data(), 4);
  std::memcpy(&columns, bytes.data() + 4, 4);
  EXPECT_EQ(rows, 2);
  EXPECT_EQ(columns, 3);
  for (int i = 0; i < 6; ++i) {
    float height = 0.0F;
    std::memcpy(&height, bytes.data() + 8 + 4 * i, 4);
    EXPECT_FLOAT_EQ(height, 0.2F * static_cast<float>(i)) << "rows along y from the lowest, as shares of the rise";
  }
}

TEST(MujocoGround, KeepsAnInfinitePlane) {
  const std::string text = MujocoGroundFiles(FlatTerrain(), "flat.xml").at(0).text;
  EXPECT_EQ(Quoted(text, "<geom name=\""), std::vector<std::string>{"ground"});
  EXPECT_NE(text.find("type=\"plane\" size=\"0 0 1\""), std::string::npos) << "a plane without end stays one";
  EXPECT_EQ(MujocoGroundFiles(FlatTerrain(), "flat.xml").size(), 1U);
}

}  // namespace
}  // namespace gaitwright
