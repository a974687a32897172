// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "kinematics/base/result.h"
#include "kinematics/model/mesh_parts.h"
#include "tests/kinematics/model/mesh_boxes.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

/// The message of a refused text or binary file.
std::string StlMessage(const std::string& bytes) {
  try {
    ParseStl(bytes);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

std::string StlFacet(const std::string& vertices) {
  return "solid s\nfacet normal 0 0 1\nouter loop\n" + vertices + "endloop\nendfacet\nendsolid s\n";
}

TEST(MeshStl, BothKindsGiveTheSameTriangles) {
  const Vector3 half(0.5, 0.25, 0.125);  // exact as floats
  const Mesh binary = ParseStl(BinaryStl(half)), text = ParseStl(TextStl(half));
  ASSERT_EQ(binary.triangles.size(), 12U);
  ASSERT_EQ(text.triangles.size(), 12U);
  ASSERT_EQ(binary.vertices.size(), 36U) << "each triangle has its own corners";
  for (std::size_t i = 0; i < binary.vertices.size(); ++i) EXPECT_EQ(binary.vertices[i], text.vertices[i]);
  for (std::size_t t = 0; t < 12; ++t) EXPECT_EQ(binary.triangles[t], text.triangles[t]);
}

TEST(MeshStl, TheTrianglesOfABoxEncloseItsVolume) {
  const Mesh mesh = ParseStl(BinaryStl({0.5, 0.25, 0.125}));
  double volume = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(t[i])]; };
    volume += at(0).dot(at(1).cross(at(2))) / 6.0;
  }
  EXPECT_NEAR(volume, 8.0 * 0.5 * 0.25 * 0.125, 1e-12) << "all of them turn outward";
}

TEST(MeshStl, ABinaryFileMayBeginAsATextOne) {
  std::string bytes = BinaryStl({1, 1, 1});
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(ParseStl(bytes).triangles.size(), 12U);
}

TEST(MeshStl, TextHasBlanksAndCapitalsOfNumbersAsItLikes) {
  const Mesh mesh = ParseStl("\n  solid\n" + StlFacet("\tvertex 1E0 +2.5   -3e-1\r\nvertex 0 0 0\n\nvertex .5 0 0\n"));
  ASSERT_EQ(mesh.vertices.size(), 3U);
  EXPECT_EQ(mesh.vertices[0], Vector3(1.0, 2.5, -0.3));
  EXPECT_EQ(mesh.vertices[2], Vector3(0.5, 0.0, 0.0));
  EXPECT_TRUE(ParseStl("solid empty\nendsolid\n").triangles.empty());
}

TEST(MeshStl, RefusesTextByItsLine) {
  ExpectSays(StlMessage(StlFacet("vertex 0 0 0\nvertex 1 0 0\n")), {"line 7", "2 vertices"});
  ExpectSays(StlMessage(StlFacet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\n")), {"line 7", "fourth"});
  ExpectSays(StlMessage(StlFacet("vertex 0 0 zero\n")), {"line 4", "coordinate", "zero"});
  ExpectSays(StlMessage(StlFacet("vertex 0 0\n")), {"line 4"});
  ExpectSays(StlMessage(StlFacet("vertex 0 0 nan\n")), {"line 4"});
  ExpectSays(StlMessage(StlFacet("point 0 0 0\n")), {"line 4", "'point'"});
  ExpectSays(StlMessage("solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"), {"ends within a facet"});
}

TEST(MeshStl, RefusesBytesThatAreCutOrAreNoNumbers) {
  const std::string bytes = BinaryStl({1, 1, 1});
  EXPECT_EQ(StlMessage(bytes), "");
  ExpectSays(StlMessage(bytes.substr(0, bytes.size() - 1)), {"12 triangles", "684 bytes", "has 683"});
  ExpectSays(StlMessage(bytes + "x"), {"12 triangles", "685"});
  EXPECT_NE(StlMessage(""), "");
  EXPECT_NE(StlMessage(std::string(200, 'a')), "");
  std::string wrong = bytes;
  const float nothing = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(&wrong[84 + 50 + 12], &nothing, sizeof(nothing));  // the first corner of the second triangle
  ExpectSays(StlMessage(wrong), {"triangle 2", "nan"});
  const float far = 2e12F;
  std::memcpy(&wrong[84 + 50 + 12], &far, sizeof(far));
  ExpectSays(StlMessage(wrong), {"triangle 2", "-1e12 to 1e12"});
}

}  // namespace
}  // namespace gaitwright
