// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <numbers>

#include "kinematics/description/mjcf_inertia_internal.h"
#include "kinematics/spatial/steiner.h"
#include "tests/kinematics/description/mjcf_texts.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

constexpr double kPi = std::numbers::pi;

/// The only body of a model, with these geoms and without <inertial>.
Body BodyOfGeoms(const std::string& geoms, const std::string& sections = "", const MjcfFiles& files = {}) {
  const std::string text =
      "<mujoco>" + sections + "<worldbody><body name='base'><freejoint/>" + geoms + "</body></worldbody></mujoco>";
  const RobotModel model = TreeOf(Converted(text, files));
  return model.bodies.empty() ? Body() : model.bodies.front();
}

void ExpectInertia(const Body& body, double mass, const Vector3& moments, const std::string& what) {
  EXPECT_NEAR(body.mass, mass, 1e-12 * mass) << what;
  EXPECT_LT((body.I_C - Matrix3(moments.asDiagonal())).norm(), 1e-12 * moments.norm()) << what << "\n" << body.I_C;
}

TEST(MjcfInertia, OfSolidsIsTheClosedForm) {
  const double r = 0.1, h = 0.3;  // half of the length
  ExpectInertia(BodyOfGeoms("<geom size='0.1'/>"), 1000.0 * 4.0 / 3.0 * kPi * r * r * r,
                Vector3::Constant(0.4 * 1000.0 * 4.0 / 3.0 * kPi * std::pow(r, 5)), "sphere");
  ExpectInertia(BodyOfGeoms("<geom type='box' size='0.1 0.2 0.3' mass='6'/>"), 6.0,
                6.0 / 3.0 * Vector3(0.04 + 0.09, 0.01 + 0.09, 0.01 + 0.04), "box");
  ExpectInertia(BodyOfGeoms("<geom type='ellipsoid' size='0.1 0.2 0.3' density='500'/>"),
                500.0 * 4.0 / 3.0 * kPi * 0.006,
                500.0 * 4.0 / 3.0 * kPi * 0.006 / 5.0 * Vector3(0.04 + 0.09, 0.01 + 0.09, 0.01 + 0.04), "ellipsoid");
  ExpectInertia(BodyOfGeoms("<geom type='cylinder' size='0.1 0.3' mass='2'/>"), 2.0,
                2.0 * Vector3(r * r / 4.0 + h * h / 3.0, r * r / 4.0 + h * h / 3.0, r * r / 2.0), "cylinder");
  // A capsule: cylinder of mass mc, two half balls of mass mb together, whose centres are at h + 3/8 r.
  const double vc = 2.0 * kPi * r * r * h, vb = 4.0 / 3.0 * kPi * r * r * r, mc = 3.0 * vc / (vc + vb), mb = 3.0 - mc;
  const double across =
      mc * (r * r / 4.0 + h * h / 3.0) + mb * (0.4 * r * r - 9.0 / 64.0 * r * r) + mb * std::pow(h + 0.375 * r, 2);
  ExpectInertia(BodyOfGeoms("<geom type='capsule' size='0.1 0.3' mass='3'/>"), 3.0,
                {across, across, mc * r * r / 2.0 + mb * 0.4 * r * r}, "capsule");
}

TEST(MjcfInertia, OfTurnedGeomsAddsUpAboutTheCommonCentre) {
  const Body body = BodyOfGeoms(
      "<geom type='box' size='0.1 0.2 0.3' mass='6' pos='1 0 0' axisangle='0 0 1 90'/>"
      "<geom type='sphere' size='0.1' mass='2' pos='-1 0 2'/>");
  const Vector3 centre(0.5, 0.0, 0.5);
  EXPECT_NEAR(body.mass, 8.0, 1e-12);
  EXPECT_LT((body.p_BC - centre).norm(), 1e-12);
  Matrix3 I = Matrix3(Vector3(6.0 / 3.0 * Vector3(0.01 + 0.09, 0.04 + 0.09, 0.01 + 0.04)).asDiagonal());
  I += Matrix3(Vector3::Constant(0.4 * 2.0 * 0.01).asDiagonal());
  I += Steiner(6.0, Vector3(1, 0, 0) - centre) + Steiner(2.0, Vector3(-1, 0, 2) - centre);
  EXPECT_LT((body.I_C - I).norm(), 1e-12) << body.I_C << "\nwanted\n" << I;
}

TEST(MjcfInertia, ComesFromWhereTheCompilerSays) {
  const std::string both = "<inertial pos='0 0 1' mass='5' diaginertia='1 2 2.5'/><geom size='0.1' mass='3'/>";
  EXPECT_EQ(BodyOfGeoms(both).mass, 5.0);
  EXPECT_EQ(BodyOfGeoms(both, "<compiler inertiafromgeom='false'/>").mass, 5.0);
  EXPECT_EQ(BodyOfGeoms(both, "<compiler inertiafromgeom='true'/>").mass, 3.0);
  const std::string groups = "<geom size='0.1' mass='3' group='1'/><geom size='0.1' mass='4' group='3'/>";
  EXPECT_EQ(BodyOfGeoms(groups).mass, 7.0);
  EXPECT_EQ(BodyOfGeoms(groups, "<compiler inertiagrouprange='2 4'/>").mass, 4.0);
  EXPECT_EQ(BodyOfGeoms("<geom size='0.1' mass='3'/><geom size='0.1' density='0'/>").mass, 3.0);
}

TEST(MjcfInertia, IsGivenInAxesOfItsOwn) {
  const Body diagonal = BodyOfGeoms("<inertial pos='1 2 3' euler='0 0 90' mass='5' diaginertia='1 2 2.5'/>");
  EXPECT_LT((diagonal.p_BC - Vector3(1, 2, 3)).norm(), 1e-12);
  EXPECT_LT((diagonal.I_C - Matrix3(Vector3(2, 1, 2.5).asDiagonal())).norm(), 1e-12);
  const Body full = BodyOfGeoms("<inertial pos='0 0 0' mass='5' fullinertia='1 2 2.5 0.1 0.2 0.3'/>");
  Matrix3 wanted;
  wanted << 1, 0.1, 0.2, 0.1, 2, 0.3, 0.2, 0.3, 2.5;
  EXPECT_LT((full.I_C - wanted).norm(), 1e-12);
}

TEST(MjcfInertia, KeepsTheBoundsOfTheCompiler) {
  const std::string light = "<inertial pos='0 0 0' mass='0.001' diaginertia='1e-5 2e-5 2.5e-5'/>";
  const Body bound = BodyOfGeoms(light, "<compiler boundmass='0.5' boundinertia='1.5e-5'/>");
  EXPECT_EQ(bound.mass, 0.5);
  EXPECT_LT((bound.I_C - Matrix3(Vector3(1.5e-5, 2e-5, 2.5e-5).asDiagonal())).norm(), 1e-16);
  const std::string odd = "<inertial pos='0 0 0' mass='1' diaginertia='1 1 4'/>";
  EXPECT_LT((BodyOfGeoms(odd, "<compiler balanceinertia='true'/>").I_C - 2.0 * Matrix3::Identity()).norm(), 1e-12);
  const Body scaled =
      BodyOfGeoms("<inertial pos='0 0 0' mass='2' diaginertia='1 2 3'/>", "<compiler settotalmass='6'/>");
  ExpectInertia(scaled, 6.0, {3, 6, 9}, "settotalmass");
}

/// A box of edges (2, 3, 4) about (1, 1, 1), with faces pointing outward or inward.
MjcfMesh BoxMesh(bool inside_out) {
  MjcfMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.emplace_back(1.0 + ((i & 1) != 0 ? 1.0 : -1.0), 1.0 + ((i & 2) != 0 ? 1.5 : -1.5),
                               1.0 + ((i & 4) != 0 ? 2.0 : -2.0));
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  if (inside_out) {
    for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[0], t[1]);
  }
  return mesh;
}

TEST(MjcfInertia, OfAMeshIsThatOfTheSolidBetweenItsTriangles) {
  for (const bool inside_out : {false, true}) {
    const auto volume = VolumeOfMjcfMesh(BoxMesh(inside_out));
    ASSERT_TRUE(volume.has_value());
    EXPECT_NEAR(volume->volume, 24.0, 1e-12);
    EXPECT_LT((volume->centre - Vector3(1, 1, 1)).norm(), 1e-12);
    EXPECT_LT((InertiaOfMjcfVolume(*volume, 12.0) - Matrix3(Vector3(25, 20, 13).asDiagonal())).norm(), 1e-10);
  }
  MjcfMesh open = BoxMesh(false);
  open.triangles.pop_back();
  EXPECT_FALSE(VolumeOfMjcfMesh(open).has_value());
  open.triangles = {{0, 1, 99}};
  EXPECT_FALSE(VolumeOfMjcfMesh(open).has_value());
}

const std::string kBoxAsset = "<asset><mesh name='m' file='box.stl' scale='0.1 0.1 -0.2' refpos='1 0 0'/></asset>";

TEST(MjcfInertia, OfAMeshFollowsScaleAndReference) {
  std::string asked;
  MjcfFiles files;
  files.mesh = [&](const std::string& file) -> Result<MjcfMesh> {
    asked = file;
    return BoxMesh(false);
  };
  const Body body = BodyOfGeoms("<geom type='mesh' mesh='m' mass='12' pos='5 0 0'/>",
                                "<compiler meshdir='assets'/>" + kBoxAsset, files);
  EXPECT_EQ(asked, "assets/box.stl");
  EXPECT_LT((body.p_BC - Vector3(5.0, 0.1, -0.2)).norm(), 1e-12);
  EXPECT_LT((body.I_C - Matrix3(Vector3(0.09 + 0.64, 0.04 + 0.64, 0.04 + 0.09).asDiagonal())).norm(), 1e-12)
      << body.I_C;
}

TEST(MjcfInertia, OfAnOpenMeshIsThatOfTheBoxAroundItAndIsNoted) {
  MjcfFiles files;
  files.mesh = [](const std::string&) -> Result<MjcfMesh> {
    MjcfMesh open = BoxMesh(false);
    open.triangles.pop_back();
    return open;
  };
  const std::string text =
      "<mujoco>" + kBoxAsset +
      "<worldbody><body name='base'><freejoint/><geom type='mesh' mesh='m' mass='12'/></body></worldbody></mujoco>";
  const ConvertedMjcf converted = Converted(text, files);
  ExpectNote(converted, {"line 1: mesh 'm'", "do not enclose a volume", "bounding box"});
  EXPECT_NEAR(TreeOf(converted).bodies[0].I_C(0, 0), 0.73, 1e-12);
}

TEST(MjcfInertia, RefusesWhatIsWrongByLine) {
  const auto with = [](const std::string& geoms, const std::string& sections = "", const MjcfFiles& files = {}) {
    return MjcfMessage(
        "<mujoco>" + sections + "<worldbody>\n<body name='base'>\n" + geoms + "\n</body></worldbody></mujoco>", files);
  };
  ExpectSays(with("<inertial pos='0 0 0' diaginertia='1 1 1'/>"), {"line 3: <inertial>", "no 'mass'"});
  ExpectSays(with("<inertial mass='-1' pos='0 0 0'/>"), {"line 3", "its mass is -1 kg"});
  ExpectSays(with("<inertial mass='1' diaginertia='1 1 1' fullinertia='1 1 1 0 0 0'/>"), {"both 'diaginertia'"});
  ExpectSays(with("<inertial mass='1'/><inertial mass='1'/>"), {"body 'base'", "two <inertial>"});
  ExpectSays(with("<geom size='0.1' shellinertia='true'/>"), {"line 3", "shell"});
  ExpectSays(with("<geom name='g' type='mesh' mesh='m'/>", kBoxAsset),
             {"line 3: geom 'g'", "comes from the mesh 'm'", "give the body an <inertial>"});
  MjcfFiles missing;
  missing.mesh = [](const std::string& file) -> Result<MjcfMesh> {
    return Failure{FailureKind::kBadInput, FailureCode::kNoFile, "ReadMesh", "there is no file '" + file + "'", {}};
  };
  ExpectSays(with("<geom name='g' type='mesh' mesh='m'/>", kBoxAsset, missing),
             {"line 3: geom 'g'", "there is no file 'box.stl'"});
  ExpectSays(with("<geom name='g' type='mesh' mesh='n'/>", kBoxAsset), {"geom 'g'", "no mesh 'n'"});
}

}  // namespace
}  // namespace gaitwright
