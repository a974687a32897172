// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/mesh_parts.h"

#include <gtest/gtest.h>

#include "tests/kinematics/model/mesh_boxes.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

using Parser = Mesh (*)(const std::string&);

std::string ReasonNoMesh(Parser parse, const std::string& text) {
  try {
    parse(text);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

double AreaOf(const Mesh& mesh) {
  double area = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(t[i])]; };
    area += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
  }
  return area;
}

/// A non-convex face of area 2.5. A fan from its first corner would have a larger area.
TEST(MeshFaces, DentedOnesAreCutIntoTheirOwnArea) {
  const std::string dented = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\n";
  for (const char* face : {"f 1 2 3 4 5", "f 5 4 3 2 1", "f 3 4 5 1 2", "f -2 -1 -5 -4 -3"}) {
    const Mesh mesh = ParseObj(dented + face);
    EXPECT_EQ(mesh.triangles.size(), 3U);
    EXPECT_NEAR(AreaOf(mesh), 2.5, 1e-12) << face;
  }
  std::string many = "v 0 0 0\nf";
  for (int i = 0; i < 600; ++i) many += " 1";
  ExpectSays(ReasonNoMesh(ParseObj, many), {"501 corners", "three to 500"});
}

TEST(MeshObj, IndicesAreOfVerticesThatAreThere) {
  ExpectSays(ReasonNoMesh(ParseObj, "v 0 0 0\nf 1 1 2\n"),
             {"line 2", "'2' refers to a vertex that does not exist", "define 1"});
  ExpectSays(ReasonNoMesh(ParseObj, "v 0 0 0\nf -2 1 1\n"), {"line 2", "'-2'"});
  ExpectSays(ReasonNoMesh(ParseObj, "v 0 0 0\nf 0 1 1\n"), {"line 2", "'0'"});
  ExpectSays(ReasonNoMesh(ParseObj, "v 0 nan 0\n"), {"line 1", "'nan'", "finite"});
  ExpectSays(ReasonNoMesh(ParseObj, "v 0 1e300 0\n"), {"1e+300", "1000000000000"});
  EXPECT_EQ(ParseObj("v 0 0 0\nv 1 0 0\nv 0 1 0 \\\n\nf 1/1 2//3 \\\n3/1/2\n").triangles.size(), 1U);
}

TEST(MeshStl, HeadsThatLieAreRefused) {
  std::string bytes = BinaryStl(Vector3(1.0, 1.0, 1.0));
  EXPECT_EQ(ParseStl(bytes).triangles.size(), 12U);
  bytes[83] = '\x7f';  // the highest byte of the count
  ExpectSays(ReasonNoMesh(ParseStl, bytes), {"its header announces 2130706444 triangles", "the file has 684"});
  ExpectSays(ReasonNoMesh(ParseStl, "solid a\nfacet\nvertex 0 0 0\nendfacet\n"), {"line 4", "a facet has 1 vertices"});
  ExpectSays(ReasonNoMesh(ParseStl, "solid a\nvertex 0 0 0\n"), {"ends within a facet"});
  ExpectSays(ReasonNoMesh(ParseStl, "solid a\nfacette\n"), {"line 2", "'facette' is not an STL keyword"});
}

/// Both kinds of files caused stack overflows or out-of-bounds accesses in other readers.
TEST(MeshCollada, WhatGoesRoundOrBeyondIsRefused) {
  const std::string good = Collada(Vector3(1.0, 1.0, 1.0), 1.0);
  EXPECT_EQ(ParseCollada(good).triangles.size(), 12U);
  ExpectSays(ReasonNoMesh(ParseCollada, Replaced(good, "<node", "<node id='m'><instance_node url='#m'/></node><node")),
             {"<node>", "'m' contains itself"});
  ExpectSays(ReasonNoMesh(ParseCollada, Replaced(good, "count=\"8\"", "count=\"9\"")),
             {"<accessor>", "needs 27 numbers; the array has 24"});
  ExpectSays(ReasonNoMesh(ParseCollada, Replaced(good, "<p>", "<p>8 8 8 ")),
             {"<p>", "refers to point 8", "the mesh has 8 points"});
  ExpectSays(ReasonNoMesh(ParseCollada, Replaced(good, "stride=\"3\"", "stride=\"0\"")), {"<accessor>", "stride 0"});
  ExpectSays(ReasonNoMesh(ParseCollada, Replaced(good, "url=\"#g\"", "url=\"#h\"")),
             {"refers to '#h', which does not exist"});
  ExpectSays(ReasonNoMesh(ParseCollada, "<COLLADA/>"), {"<COLLADA>", "lacks <scene>"});
  std::string deep = "<COLLADA>";
  for (int i = 0; i < 600; ++i) deep += "<node>";
  ExpectSays(ReasonNoMesh(ParseCollada, deep), {"not XML", "DEPTH"});
}

}  // namespace
}  // namespace gaitwright
