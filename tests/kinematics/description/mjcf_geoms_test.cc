// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/mjcf_geoms_internal.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

const MjcfFiles kNoGeomFiles;

/// The geoms of the first body of a model.
struct GeomsOfText {
  explicit GeomsOfText(const std::string& inside, const std::string& sections = "")
      : context("<mujoco>" + sections + "<worldbody><body name='base'><freejoint/>" + inside +
                    "</body></worldbody></mujoco>",
                kNoGeomFiles, "model.xml"),
        tree(ReadMjcfTree(context)),
        geoms(ReadMjcfGeoms(context, tree.bodies[0], MjcfPairedGeoms(context))) {}

  MjcfContext context;
  MjcfTree tree;
  std::vector<MjcfGeom> geoms;
};

FailureCode CodeOfGeom(const std::string& attributes) {
  return MjcfFailureOf([&] { GeomsOfText made("<geom " + attributes + "/>"); }).code;
}

MjcfMeshAssets MeshesOf(const std::string& sections) {
  GeomsOfText made("", sections);
  return ReadMjcfMeshes(made.context);
}

TEST(MjcfGeoms, SizesAreAsMuJoCoHasThem) {
  const GeomsOfText made(
      "<geom size='1'/><geom type='capsule' size='1 2'/><geom type='ellipsoid' size='1 2 3'/>"
      "<geom type='capsule' size='1 9 9' fromto='0 0 0 0 0 6'/><geom type='box' size='1 9' fromto='0 0 0 0 0 6'/>");
  const std::vector<Vector3> sizes = {{1, 0, 0}, {1, 2, 0}, {1, 2, 3}, {1, 3, 0}, {1, 1, 3}};
  ASSERT_EQ(made.geoms.size(), sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) EXPECT_EQ(made.geoms[i].size, sizes[i]) << i;
}

TEST(MjcfGeoms, EndsLieOnTheAxisHalfALengthFromTheMiddle) {
  const GeomsOfText made(
      "<frame pos='0 0 5' euler='90 0 0'><geom type='capsule' size='.1' fromto='1 2 3 4 -2 3'/></frame>");
  const MjcfGeom& geom = made.geoms.at(0);
  const Matrix3 R_BF = Eigen::AngleAxisd(90.0 * kDegree, Vector3::UnitX()).toRotationMatrix();
  const Vector3 shift(0, 0, 5);
  EXPECT_LT((geom.X_BG * Vector3(0, 0, geom.size.y()) - (shift + R_BF * Vector3(1, 2, 3))).norm(), 1e-12);
  EXPECT_LT((geom.X_BG * Vector3(0, 0, -geom.size.y()) - (shift + R_BF * Vector3(4, -2, 3))).norm(), 1e-12);
}

TEST(MjcfGeoms, CollideByBitsOrPairsAndShowByGroup) {
  const GeomsOfText made(
      "<geom name='a' size='1'/><geom name='b' size='1' contype='0'/>"
      "<geom name='c' size='1' contype='0' conaffinity='0' group='2'/>"
      "<geom name='d' size='1' contype='0' conaffinity='0' group='3'/><geom size='1' contype='0' conaffinity='0'/>",
      "<contact><pair geom1='d' geom2='floor'/><exclude body1='c' body2='c'/></contact>");
  std::vector<bool> collides, shown;
  for (const MjcfGeom& geom : made.geoms) {
    collides.push_back(geom.collides);
    shown.push_back(geom.is_shown);
  }
  EXPECT_EQ(collides, (std::vector<bool>{true, true, false, true, false}));
  EXPECT_EQ(shown, (std::vector<bool>{true, true, true, false, true}));
  EXPECT_EQ(MjcfPairedGeoms(made.context), (std::set<std::string>{"d", "floor"}));
}

TEST(MjcfGeoms, MassAndDensityAreGivenOrTheDensityOfWater) {
  const GeomsOfText made("<geom size='1'/><geom size='1' mass='2'/><geom size='1' density='7' shellinertia='true'/>");
  EXPECT_EQ(made.geoms[0].mass, std::nullopt);
  EXPECT_EQ(made.geoms[0].density, 1000.0);
  EXPECT_EQ(made.geoms[1].mass, 2.0);
  EXPECT_EQ(made.geoms[2].density, 7.0);
  EXPECT_TRUE(made.geoms[2].is_shell);
}

TEST(MjcfGeoms, PlanesAndFieldsAreLeftOutAndFrictionIsNotedOnce) {
  const GeomsOfText made(
      "<geom type='plane'/><geom type='hfield'/><geom type='sdf'/><geom size='1' friction='1'/>"
      "<geom size='1' friction='1'/>");
  EXPECT_EQ(made.geoms.size(), 2U);
  EXPECT_EQ(made.context.notes.size(), 4U);
}

TEST(MjcfGeoms, AMeshTakesThePlaceOfTheShapeFittedToIt) {
  const GeomsOfText made("<geom type='capsule' mesh='m' fromto='0 0 0 0 0 1' pos='1 2 3'/>");
  EXPECT_EQ(made.geoms.at(0).type, MjcfGeomType::kMesh);
  EXPECT_EQ(made.geoms[0].X_BG.translation(), Vector3(1, 2, 3)) << "fromto is of the shape alone";
}

TEST(MjcfGeoms, RefusesByCode) {
  for (const char* attributes :
       {"type='box'", "size='0'", "type='box' size='1 1 -1'", "size='1' fromto='0 0 0 0 0 1'",
        "type='capsule' size='1' fromto='1 1 1 1 1 1'", "type='mesh'", "size='1' mass='-1'", "size='1' density='-1'"})
    EXPECT_EQ(CodeOfGeom(attributes), FailureCode::kMjcfGeom) << attributes;
  EXPECT_EQ(CodeOfGeom("type='box' size='1 1'"), FailureCode::kMjcfNumber);
  EXPECT_EQ(CodeOfGeom("type='ball' size='1'"), FailureCode::kMjcfChoice);
}

TEST(MjcfMeshes, AreNamedByThemselvesOrByTheirFile) {
  const MjcfMeshAssets meshes = MeshesOf(
      "<compiler meshdir='m'/><asset><mesh file='a/leg.stl'/><mesh name='n' file='../b.obj'/><mesh name='inner' "
      "vertex='0 0 0 1 0 0 0 1 0 0 0 1'/><mesh name='none'/><texture name='t'/></asset>");
  ASSERT_EQ(meshes.size(), 4U);
  EXPECT_EQ(meshes.at("leg").file, "m/a/leg.stl");
  EXPECT_EQ(meshes.at("n").file, "b.obj");
  EXPECT_EQ(meshes.at("inner").file, "inline:inner");
  EXPECT_EQ(meshes.at("none").file, "");
  EXPECT_EQ(MeshesOf("<compiler strippath='true'/><asset><mesh file='a/leg.stl'/></asset>").at("leg").file, "leg.stl");
}

TEST(MjcfMeshes, ThePointOfReferenceBecomesTheOrigin) {
  const MjcfMeshAsset mesh =
      MeshesOf("<asset><mesh file='a.stl' scale='2 3 -4' refpos='1 2 3' refquat='0 0 0 2'/></asset>").at("a");
  EXPECT_LT((mesh.A() * mesh.p_ref + mesh.b()).norm(), 1e-12);
  // Half a turn about z, then scaled.
  const Vector3 step = mesh.A() * (mesh.p_ref + Vector3(1, 1, 1)) + mesh.b();
  EXPECT_LT((step - Vector3(-2, -3, -4)).norm(), 1e-12);
}

TEST(MjcfMeshes, VerticesWithoutFacesAreTheirConvexHull) {
  const std::string corners = "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1";
  const auto inner = [&](const std::string& attributes) {
    return MeshesOf("<asset><mesh name='m' vertex='" + corners + attributes + "/></asset>").at("m").inner;
  };
  const MjcfMesh hull = inner(" 0.5 0.5 0.5'");
  EXPECT_EQ(hull.vertices.size(), 9U);
  EXPECT_EQ(hull.triangles.size(), 12U);
  const MjcfMesh given = inner("' face='0 1 2 1 3 2'");
  ASSERT_EQ(given.triangles.size(), 2U);
  EXPECT_EQ(given.triangles[1], Eigen::Vector3i(1, 3, 2));
}

TEST(MjcfMeshes, RefusesVerticesByLine) {
  const auto message = [](const std::string& mesh) {
    return MjcfFailureOf([&] { MeshesOf("<asset>\n<mesh name='m' " + mesh + "/></asset>"); }).message;
  };
  const std::string four = "vertex='0 0 0 1 0 0 0 1 0 0 0 1' ";
  ExpectSays(message("vertex='0 0 0'"), {"line 2: mesh 'm'", "'vertex' is '0 0 0'", "3 numbers"});
  ExpectSays(message("vertex='0 0 0 1 0 0 0 1 0 0 0 1 1'"), {"'vertex' has 13 numbers"});
  ExpectSays(message("vertex='0 0 0 1 0 0 0 1 0 1 1 0'"), {"lie in one plane"});
  ExpectSays(message(four + "face='0 1 4'"), {"'face' names the vertex 4", "0 to 3"});
  ExpectSays(message(four + "face='0 1 1.5'"), {"'face' names the vertex 1.5"});
  ExpectSays(message(four + "face='0 1'"), {"'face' is '0 1'", "2 numbers"});
}

TEST(MjcfMeshes, RefusesByCode) {
  const auto code = [](const std::string& mesh) {
    return MjcfFailureOf([&] { MeshesOf("<asset>" + mesh + "</asset>"); }).code;
  };
  EXPECT_EQ(code("<mesh/>"), FailureCode::kMjcfMissing);
  EXPECT_EQ(code("<mesh file='a.stl' scale='1 0 1'/>"), FailureCode::kMjcfMesh);
  EXPECT_EQ(code("<mesh file='a.stl' refquat='0 0 0 0'/>"), FailureCode::kMjcfMesh);
  EXPECT_EQ(code("<mesh file='a.stl'/><mesh name='a' file='b.stl'/>"), FailureCode::kDoubleName);
  MjcfGeom geom;
  geom.mesh = "legg";
  const MjcfMeshAssets meshes = MeshesOf("<asset><mesh name='leg' file='a.stl'/></asset>");
  const Failure failure = MjcfFailureOf([&] { MjcfMeshOf(geom, meshes); });
  EXPECT_EQ(failure.code, FailureCode::kMjcfMesh);
  ExpectSays(failure.message, {"'legg'", "'leg'"});
}

TEST(MjcfGeoms, HiddenOnesCollideWhereNoneElseDoes) {
  GeomsOfText made("");
  MjcfGeom shown, hidden;
  shown.collides = hidden.collides = hidden.is_shown = false;
  std::vector<std::vector<MjcfGeom>> geoms = {{shown, hidden}, {hidden}};
  LetHiddenMjcfGeomsCollide(made.context, geoms);
  EXPECT_FALSE(geoms[0][0].collides);
  EXPECT_TRUE(geoms[0][1].collides && geoms[1][0].collides);
  shown.collides = true;
  geoms = {{shown, hidden}, {hidden}};
  LetHiddenMjcfGeomsCollide(made.context, geoms);
  EXPECT_FALSE(geoms[0][1].collides || geoms[1][0].collides);
}

}  // namespace
}  // namespace gaitwright
