// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "kinematics/model/mesh_parts.h"
#include "tests/kinematics/model/mesh_boxes.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

const Vector3 kColladaHalf(0.5, 0.25, 0.125);

/// The box of mesh_boxes.h with parts of its text replaced.
std::string ColladaWith(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::string text = Collada(kColladaHalf, 1.0);
  for (const auto& [from, to] : changes) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    text = Replaced(text, from, to);
  }
  return text;
}

std::string ColladaMessage(const std::string& text) {
  try {
    ParseCollada(text);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

const char kInstance[] = "<instance_geometry url=\"#g\"/>";

/// The vertex of corner (+, +, +) of the box.
Vector3 LastCorner(const std::string& text) {
  const Mesh mesh = ParseCollada(text);
  EXPECT_GE(mesh.vertices.size(), 8U);
  return mesh.vertices.size() < 8 ? Vector3::Zero() : mesh.vertices[7];
}

TEST(MeshCollada, TransformsOfANodeApplyFromTheLastToTheFirst) {
  const auto with = [](const std::string& transforms) {
    return LastCorner(ColladaWith({{kInstance, transforms + kInstance}}));
  };
  EXPECT_EQ(with(""), kColladaHalf);
  EXPECT_LT((with("<translate>1 2 3</translate>") - (kColladaHalf + Vector3(1, 2, 3))).norm(), 1e-12);
  EXPECT_LT((with("<scale>2 3 4</scale>") - Vector3(1.0, 0.75, 0.5)).norm(), 1e-12);
  EXPECT_LT((with("<rotate>0 0 5 90</rotate>") - Vector3(-0.25, 0.5, 0.125)).norm(), 1e-12) << "degrees, any length";
  EXPECT_LT((with("<translate>1 0 0</translate><scale>2 2 2</scale>") - Vector3(2.0, 0.5, 0.25)).norm(), 1e-12);
  EXPECT_LT((with("<scale>2 2 2</scale><translate>1 0 0</translate>") - Vector3(3.0, 0.5, 0.25)).norm(), 1e-12);
  EXPECT_LT((with("<matrix>0 -1 0 7 1 0 0 8 0 0 1 9 0 0 0 1</matrix>") - Vector3(6.75, 8.5, 9.125)).norm(), 1e-12);
}

TEST(MeshCollada, NodesOfNodesAndShownTwiceAddUp) {
  const std::string nested =
      ColladaWith({{kInstance, std::string("<translate>1 0 0</translate><node><translate>0 1 0</translate>") +
                                   kInstance + "</node>"}});
  EXPECT_LT((LastCorner(nested) - (kColladaHalf + Vector3(1, 1, 0))).norm(), 1e-12);
  const Mesh twice = ParseCollada(ColladaWith(
      {{kInstance, std::string(kInstance) + "<node><translate>0 0 5</translate>" + kInstance + "</node>"}}));
  EXPECT_EQ(twice.vertices.size(), 16U);
  ASSERT_EQ(twice.triangles.size(), 24U);
  EXPECT_EQ(twice.triangles[12], twice.triangles[0] + Eigen::Vector3i::Constant(8));
  EXPECT_LT((twice.vertices[15] - twice.vertices[7] - Vector3(0, 0, 5)).norm(), 1e-12);
}

TEST(MeshCollada, UnitAndUpAxisMakeMetresWithZUp) {
  EXPECT_LT((LastCorner(Collada(kColladaHalf, 0.0254)) - 0.0254 * kColladaHalf).norm(), 1e-12);
  const auto up = [](const std::string& axis) { return LastCorner(ColladaWith({{"Z_UP", axis}})); };
  EXPECT_LT((up("Y_UP") - Vector3(0.5, -0.125, 0.25)).norm(), 1e-12);
  EXPECT_LT((up("X_UP") - Vector3(-0.25, -0.125, 0.5)).norm(), 1e-12);
  EXPECT_LT((LastCorner(ColladaWith({{"<up_axis>Z_UP</up_axis>", ""}})) - kColladaHalf).norm(), 1e-12);
}

TEST(MeshCollada, EachKindOfPrimitiveMakesItsTriangles) {
  const auto triangles = [](const std::string& kind, const std::string& p, const std::string& more = "") {
    const std::string all = Collada(kColladaHalf, 1.0);
    const std::size_t from = all.find("<triangles"), to = all.find("</triangles>");
    const std::string input = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";
    return ParseCollada(all.substr(0, from) + "<" + kind + ">" + input + more + "<p>" + p + "</p></" + kind + ">" +
                        all.substr(to + 12))
        .triangles;
  };
  const std::vector<Eigen::Vector3i> strip = triangles("tristrips", "0 1 2 3 4");
  ASSERT_EQ(strip.size(), 3U);
  EXPECT_EQ(strip[1], Eigen::Vector3i(2, 1, 3)) << "every second triangle is turned";
  EXPECT_EQ(strip[2], Eigen::Vector3i(2, 3, 4));
  const std::vector<Eigen::Vector3i> fan = triangles("trifans", "0 1 2 3");
  ASSERT_EQ(fan.size(), 2U);
  EXPECT_EQ(fan[1], Eigen::Vector3i(0, 2, 3));
  EXPECT_EQ(triangles("polygons", "0 1 3 2").size(), 2U);
  EXPECT_EQ(triangles("polylist", "0 1 2 0 1 3 2 4 5", "<vcount>3 4 2</vcount>").size(), 3U)
      << "two corners are no face";
  const std::string normals = "<input semantic=\"NORMAL\" source=\"#v\" offset=\"1\"/>";
  const std::vector<Eigen::Vector3i> mixed = triangles("triangles", "0 7 1 7 3 7", normals);
  ASSERT_EQ(mixed.size(), 1U);
  EXPECT_EQ(mixed[0], Eigen::Vector3i(0, 1, 3)) << "each corner has a normal too";
}

TEST(MeshCollada, RefusesByLineAndElement) {
  const auto with = [](const std::string& from, const std::string& to) {
    return ColladaMessage(ColladaWith({{from, to}}));
  };
  ExpectSays(ColladaMessage("<a>"), {"not XML"});
  ExpectSays(ColladaMessage("<a/>"), {"<COLLADA>"});
  ExpectSays(with("url=\"#g\"", "url=\"#h\""), {"line 1: <instance_geometry>", "'#h'"});
  ExpectSays(with("url=\"#s\"", "url=\"#t\""), {"<instance_visual_scene>", "'#t'"});
  ExpectSays(with("meter=\"1\"", "meter=\"0\""), {"<unit>", "above 0"});
  ExpectSays(with("stride=\"3\"", "stride=\"2\""), {"<accessor>", "stride 2"});
  ExpectSays(with("count=\"8\"", "count=\"9\""), {"<accessor>", "27 numbers", "24"});
  ExpectSays(with("count=\"8\"", "count=\"-8\""), {"<accessor>", "'-8'"});
  ExpectSays(with("<p>0 ", "<p>8 "), {"<p>", "point 8", "has 8 points"});
  ExpectSays(with("<p>0 ", "<p>x "), {"<p>", "'x'"});
  ExpectSays(with("semantic=\"VERTEX\"", "semantic=\"NORMAL\""), {"<triangles>", "VERTEX"});
  ExpectSays(with(kInstance, std::string("<skew>1 2 3</skew>") + kInstance), {"<skew>", "not supported"});
  ExpectSays(with(kInstance, std::string("<translate>1 2</translate>") + kInstance), {"<translate>", "2 numbers"});
  ExpectSays(with(kInstance, "<instance_node url=\"#n\"/>"), {"<node>", "'n' contains itself"});
}

}  // namespace
}  // namespace gaitwright
