// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/height_map.h"

#include <fmt/format.h>

#include "tests/planning/terrain/made_png.h"
#include "tests/planning/terrain/terrain_files.h"

namespace gaitwright {
namespace {

using made_png::Png;
using terrain_files::Loaded;
using terrain_files::ReasonRefused;
using terrain_files::Says;
using terrain_files::Written;

TEST(HeightMap, ACsvLiesAsSeenFromAbove) {
  const std::string path = Written("map.csv", "# heights in cm\n1, 2, 3\n\n4,5,6\r\n");
  const Terrain terrain = Loaded(path + ":resolution_m=0.1,scale_m=0.01,x_m=1,y_m=2,z_m=0.5,friction=0.6");
  EXPECT_EQ(terrain.name, "map.csv:resolution_m=0.1,scale_m=0.01,x_m=1,y_m=2,z_m=0.5,friction=0.6");
  const HeightField& field = terrain.height_fields.at(0);
  EXPECT_EQ(field.name, "map.csv");
  EXPECT_EQ(field.columns, 3);
  EXPECT_EQ(field.rows, 2);
  EXPECT_EQ(field.friction, 0.6);
  // Right is x, up is y, and the centre is at the given place.
  const std::vector<std::pair<Vector2, double>> known = {
      {{0.9, 2.05}, 0.51}, {{1.0, 2.05}, 0.52}, {{1.1, 2.05}, 0.53}, {{0.9, 1.95}, 0.54}, {{1.1, 1.95}, 0.56}};
  for (const auto& [p, height] : known)
    EXPECT_NEAR(GroundAt(terrain, 0.999999 * (p - Vector2(1, 2)) + Vector2(1, 2)).height_m, height, 1e-6);
}

TEST(HeightMap, GreysOfBothDepthsAreTheSameGround) {
  const std::string narrow = Written("narrow.png", Png(3, 2, 8, 0, std::string("\x00\x80\xff\x40\x20\x10", 6)));
  std::string wide_data;
  for (const int v : {0x00, 0x80, 0xff, 0x40, 0x20, 0x10})
    wide_data += std::string(2, static_cast<char>(v));  // v * 257
  const std::string wide = Written("wide.png", Png(3, 2, 16, 0, wide_data));
  const Terrain a = Loaded(narrow + ":resolution_m=0.05,scale_m=0.3"),
                b = Loaded(wide + ":resolution_m=0.05,scale_m=0.3");
  const HeightField &fa = a.height_fields.at(0), &fb = b.height_fields.at(0);
  ASSERT_EQ(fa.height_m.size(), 6U);
  ASSERT_EQ(fb.height_m.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(fa.height_m[i], fb.height_m[i], 1e-12);
  EXPECT_NEAR(fa.height_m[5], 0.3, 1e-12) << "white, at the right and the highest y";
  EXPECT_NEAR(fa.height_m[0], 0.3 * 64 / 255, 1e-12);
}

TEST(HeightMap, WrongTablesAreRefusedAtTheirCell) {
  const auto why = [](const std::string& text, const std::string& more = "") {
    return ReasonRefused(Written("wrong.csv", text) + ":resolution_m=0.1" + more);
  };
  EXPECT_TRUE(Says(why("1,2\n3,x\n"), "line 2, cell 2: 'x' is not a finite number"));
  EXPECT_TRUE(Says(why("1,2\n3,nan\n"), "line 2, cell 2: 'nan'"));
  EXPECT_TRUE(Says(why("1,2\n3,inf\n"), "line 2, cell 2: 'inf'"));
  EXPECT_TRUE(Says(why("1,2\n3,\n"), "line 2, cell 2: ''"));
  EXPECT_TRUE(Says(why("# a\n1,2\n\n3,4,5\n"), "line 4 has 3 cells; the first row, line 2, has 2"));
  EXPECT_TRUE(Says(why("1,2\n"), "has 1 rows of 2 cells; at least two by two are needed"));
  EXPECT_TRUE(Says(why(""), "has 0 rows"));
  EXPECT_TRUE(Says(why("0,0\n0,300\n"), "line 2, cell 2: the height is 300 m, accepted: -50 to 50"));
  EXPECT_TRUE(Says(why("0,0\n0,30\n"), "a step of 30 m from the cell before"));
  EXPECT_EQ(why("0,0\n0,300\n", ",scale_m=0.001"), "") << "millimetres are fine when said";
  EXPECT_TRUE(Says(why("1,2\n3,4\n", ",resolutio_m=1"), "the nearest is 'resolution_m'"));
  EXPECT_TRUE(Says(why("1,2\n3,4\n", ",friction=-1"), "'friction' is -1"));
  EXPECT_TRUE(Says(ReasonRefused(Written("bare.csv", "1,2\n3,4\n")), "needs resolution_m"));
  EXPECT_TRUE(Says(ReasonRefused(terrain_files::Folder() + "none.csv:resolution_m=0.1"), "none.csv"));
}

TEST(HeightMap, WrongPicturesAreRefused) {
  const std::string more = ":resolution_m=0.1,scale_m=0.3";
  const std::string good = Png(2, 2, 8, 0, std::string("\x01\x02\x03\x04", 4));
  EXPECT_EQ(ReasonRefused(Written("p.png", good) + more), "");
  EXPECT_TRUE(Says(ReasonRefused(Written("p.png", good) + ":resolution_m=0.1"), "needs scale_m, the height of white"));
  EXPECT_TRUE(Says(ReasonRefused(Written("p.png", Png(2, 2, 8, 2, std::string(12, 'a'))) + more), "is in colour"));
  EXPECT_TRUE(Says(ReasonRefused(Written("p.png", Png(2, 2, 1, 0, std::string(2, 'a'))) + more), "1 bits per point"));
  EXPECT_TRUE(Says(ReasonRefused(Written("p.png", "hello") + more), "not a readable PNG"));
  EXPECT_TRUE(Says(ReasonRefused(Written("p.png", "") + more), "not a readable PNG"));
  std::string broken = good;
  broken[45] = static_cast<char>(broken[45] ^ 1);  // in the data, so that the checksum fails
  EXPECT_TRUE(Says(ReasonRefused(Written("p.png", broken) + more), "broken"));
  EXPECT_TRUE(Says(ReasonRefused(Written("p.png", good.substr(0, good.size() - 20)) + more), "broken"));
  EXPECT_TRUE(Says(ReasonRefused(Written("p.png", Png(100000, 100000, 8, 0, "a")) + more), "at most 4000000"));
}

}  // namespace
}  // namespace gaitwright
