// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/mjcf_shapes_internal.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

ConvertedMjcf WithGeom(const std::string& geom, const std::string& sections = "") {
  return Converted(MjcfOf("<geom name='g' " + geom + "/>", sections));
}

/// The only collision shape of a model with that geom.
Shape ShapeOf(const std::string& geom, const std::string& sections = "") {
  const RobotModel model = TreeOf(WithGeom(geom, sections));
  EXPECT_EQ(model.collision_shapes.size(), 1U) << geom;
  return model.collision_shapes.empty() ? Shape() : model.collision_shapes.front();
}

TEST(MjcfShapes, HaveTheSizesOfTheGeoms) {
  const Shape box = ShapeOf("type='box' size='0.1 0.2 0.3' pos='1 2 3'");
  EXPECT_EQ(box.type, ShapeType::kBox);
  EXPECT_EQ(box.size, Vector3(0.2, 0.4, 0.6));
  EXPECT_EQ(box.X_BS.translation(), Vector3(1, 2, 3));
  const Shape sphere = ShapeOf("size='0.1'");
  EXPECT_EQ(sphere.type, ShapeType::kSphere);
  EXPECT_EQ(sphere.size.x(), 0.1);
  const Shape cylinder = ShapeOf("type='cylinder' size='0.1 0.2'");
  EXPECT_EQ(cylinder.type, ShapeType::kCylinder);
  EXPECT_EQ(cylinder.size, Vector3(0.1, 0.4, 0.0));
  const Shape capsule = ShapeOf("type='capsule' size='0.1 0.2'");
  EXPECT_EQ(capsule.type, ShapeType::kCapsule);
  EXPECT_EQ(capsule.size, Vector3(0.1, 0.4, 0.0));
}

TEST(MjcfShapes, LieBetweenTheEndsOfFromto) {
  const Shape capsule = ShapeOf("type='capsule' size='0.1' fromto='0 0 1 0 2 1'");
  EXPECT_NEAR(capsule.size.y(), 2.0, 1e-12);
  EXPECT_LT((capsule.X_BS.translation() - Vector3(0, 1, 1)).norm(), 1e-12);
  EXPECT_LT((capsule.X_BS.linear().col(2) - Vector3(0, -1, 0)).norm(), 1e-12);  // z points to the first end
  const Shape box = ShapeOf("type='box' size='0.1' fromto='0 0 0 0 0 -0.5'");
  EXPECT_LT((box.size - Vector3(0.2, 0.2, 0.5)).norm(), 1e-12);
  EXPECT_LT((box.X_BS.linear() - Matrix3::Identity()).norm(), 1e-12);
}

TEST(MjcfShapes, OfEllipsoidsLieAroundThem) {
  const Shape capsule = ShapeOf("type='ellipsoid' size='0.3 0.1 0.09'");
  EXPECT_EQ(capsule.type, ShapeType::kCapsule);
  EXPECT_NEAR(capsule.size.x(), 0.1, 1e-12);
  EXPECT_NEAR(0.5 * capsule.size.y() + capsule.size.x(), 0.3, 1e-12);
  EXPECT_LT((capsule.X_BS.linear().col(2).cwiseAbs() - Vector3(1, 0, 0)).norm(), 1e-12);
  // Points of the ellipsoid must be in the capsule.
  for (double turn = 0.0; turn < 6.3; turn += 0.1) {
    const Vector3 p(0.3 * std::cos(turn), 0.1 * std::sin(turn), 0.0);
    const Vector3 on_axis(std::clamp(p.x(), -0.5 * capsule.size.y(), 0.5 * capsule.size.y()), 0.0, 0.0);
    EXPECT_LE((p - on_axis).norm(), capsule.size.x() + 1e-12) << turn;
  }
  EXPECT_EQ(ShapeOf("type='ellipsoid' size='0.3 0.3 0.1'").type, ShapeType::kBox);
  EXPECT_EQ(ShapeOf("type='ellipsoid' size='0.3 0.3 0.3'").type, ShapeType::kSphere);
  ExpectNote(WithGeom("type='ellipsoid' size='0.3 0.3 0.1'"), {"line 7: geom 'g'", "bounding box"});
}

TEST(MjcfShapes, CollideOrAreShownAsTheirGroupsAndBitsSay) {
  const auto count = [](const std::string& geom, const std::string& sections = "") {
    const RobotModel model = TreeOf(WithGeom("size='0.1' " + geom, sections));
    return std::pair(model.collision_shapes.size(), model.visual_shapes.size());
  };
  EXPECT_EQ(count(""), std::pair(1UL, 1UL));
  EXPECT_EQ(count("group='3'"), std::pair(1UL, 0UL));
  EXPECT_EQ(count("group='2' contype='0' conaffinity='0'"), std::pair(0UL, 1UL));
  EXPECT_EQ(count("group='2' contype='0' conaffinity='1'"), std::pair(1UL, 1UL));
  const RobotModel two =
      TreeOf(Converted(MjcfOf("<geom size='1'/><geom size='2' group='4' contype='0' conaffinity='0'/>")));
  EXPECT_EQ(two.collision_shapes.size(), 1U);
  EXPECT_EQ(two.visual_shapes.size(), 1U);
  // The geoms of a pair collide regardless of contype and conaffinity.
  EXPECT_EQ(count("group='4' contype='0' conaffinity='0'", "<contact><pair geom1='floor' geom2='g'/></contact>"),
            std::pair(1UL, 0UL));
}

TEST(MjcfShapes, OfMeshesNameTheFileAsTheCompilerPlacesIt) {
  const std::string asset = "<asset><mesh file='parts/leg.stl' scale='0.001 0.001 0.001'/></asset>";
  const auto urdf = [&](const std::string& compiler) {
    return WithGeom("type='mesh' mesh='leg'", compiler + asset).urdf;
  };
  ExpectSays(urdf(""), {"<mesh filename=\"parts/leg.stl\" scale=\"0.001 0.001 0.001\"/>"});
  ExpectSays(urdf("<compiler meshdir='../assets'/>"), {"\"../assets/parts/leg.stl\""});
  ExpectSays(urdf("<compiler assetdir='all' strippath='true'/>"), {"\"all/leg.stl\""});
  ExpectSays(urdf("<compiler assetdir='all' meshdir='mine'/>"), {"\"mine/parts/leg.stl\""});
}

TEST(MjcfShapes, OfMeshesAreMovedFromTheirReference) {
  // v in the file is R^T (v - p) 0.5 in the geom: with R a quarter turn about z, (2, 0, 0) comes to (0, -0.5, 0).
  const std::string asset =
      "<asset><mesh name='m' file='m.obj' scale='0.5 0.5 0.5' refpos='1 0 0' refquat='1 0 0 1'/></asset>";
  const ConvertedMjcf converted = WithGeom("type='mesh' mesh='m' pos='0 0 1'", asset);
  const UrdfParts parts = SplitUrdf(converted.urdf, 1.0);
  ASSERT_EQ(parts.collision.size(), 1U);
  const Vector3 v = parts.collision[0].X_BS * parts.collision[0].size.cwiseProduct(Vector3(2, 0, 0));
  EXPECT_LT((v - Vector3(0, -0.5, 1)).norm(), 1e-12) << v.transpose();
}

TEST(MjcfShapes, OfVerticesInTheModelNameTheirMesh) {
  const std::string asset = "<asset><mesh name='m' vertex='0 0 0 1 0 0 0 1 0 0 0 1' scale='2 2 2'/></asset>";
  const ConvertedMjcf converted = WithGeom("type='mesh' mesh='m'", asset);
  ExpectSays(converted.urdf, {"<mesh filename=\"inline:m\" scale=\"2 2 2\"/>"});
  ASSERT_EQ(converted.meshes.size(), 1U);
  EXPECT_EQ(converted.meshes[0].file, "inline:m");
  EXPECT_EQ(converted.meshes[0].mesh.vertices.size(), 4U);
  // A file for collision that cannot be read is left to who loads it, who has a replacement.
  ExpectSays(WithGeom("type='mesh' mesh='m'", "<asset><mesh file='m.msh'/></asset>").urdf, {"\"m.msh\""});
}

TEST(MjcfShapes, LeaveOutWhatARobotHasNoUseFor) {
  ExpectNote(WithGeom("type='plane' size='1 1 1'"), {"geom 'g'", "type 'plane' is left out"});
  ExpectNote(WithGeom("type='mesh' mesh='m'", "<asset><mesh name='m'/></asset>"),
             {"geom 'g'", "neither 'file' nor 'vertex'"});
  ExpectNote(WithGeom("type='mesh' mesh='m' contype='0' conaffinity='0'", "<asset><mesh file='m.msh'/></asset>"),
             {"geom 'g'", "'m.msh' has an unsupported format"});
  ExpectNote(WithGeom("type='box' mesh='m'", "<asset><mesh file='m.stl'/></asset>"),
             {"geom 'g'", "the mesh is used instead of the box"});
  ExpectNote(WithGeom("size='0.1' friction='0.6'"), {"geom 'g'", "'friction' is ignored"});
}

TEST(MjcfShapes, RefuseSizesByLine) {
  const auto with = [](const std::string& geom, const std::string& sections = "") {
    return MjcfMessage(MjcfOf("<geom name='g' " + geom + "/>", sections));
  };
  ExpectSays(with("type='sphere'"), {"line 7: geom 'g'", "no 'size'"});
  ExpectSays(with("type='box' size='1 1'"), {"line 7: geom 'g'", "'size' is '1 1'", "3 are needed"});
  ExpectSays(with("type='cylinder' size='0.1 0'"), {"'size' contains 0; it must be positive"});
  ExpectSays(with("type='cone' size='1'"), {"'type' is 'cone'", "'sphere'"});
  ExpectSays(with("type='sphere' size='1' fromto='0 0 0 0 0 1'"), {"'fromto' is for capsule"});
  ExpectSays(with("type='capsule' size='1' fromto='0 0 1 0 0 1'"), {"'fromto' are the same point"});
  ExpectSays(with("type='capsule' size='1' fromto='0 0 0 0 0 1' pos='1 0 0'"), {"both 'pos' and 'fromto'"});
  ExpectSays(with("size='1' mass='-1'"), {"mass is -1 kg"});
  ExpectSays(with("type='mesh'"), {"it is of type mesh, but has no 'mesh'"});
  ExpectSays(with("type='mesh' mesh='m'", "<asset><mesh file='m.stl' scale='1 1 2' refquat='1 1 0 0'/></asset>"),
             {"line 2: <mesh>", "'refquat' together with a scale"});
  ExpectSays(with("", "<asset><mesh file='m.stl'/>\n<mesh file='n/m.stl'/></asset>"),
             {"line 3", "two meshes are named 'm'"});
  ExpectSays(with("", "<asset><mesh file='m.stl' scale='1 0 1'/></asset>"), {"its scale is 0"});
}

TEST(MjcfShapes, WhereNoGeomCollidesThoseThatAreNotShownDo) {
  const std::string none = "<default><geom contype='0' conaffinity='0'/></default>";
  const std::string geoms = "<geom name='skin' size='1' group='1'/><geom name='hull' size='2' group='3'/>";
  const ConvertedMjcf converted = Converted(MjcfOf(geoms, none));
  const UrdfParts parts = SplitUrdf(converted.urdf, 1.0);
  ASSERT_EQ(parts.collision.size(), 1U);
  EXPECT_EQ(parts.collision[0].size.x(), 2.0);
  ExpectNote(converted, {"exclude every contact of the robot's geoms", "group 3"});
  const std::string pair = "<contact><pair geom1='skin' geom2='skin'/></contact>";
  const UrdfParts paired = SplitUrdf(Converted(MjcfOf(geoms, none + pair)).urdf, 1.0);
  ASSERT_EQ(paired.collision.size(), 1U);
  EXPECT_EQ(paired.collision[0].size.x(), 1.0);
}

}  // namespace
}  // namespace gaitwright
