// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/mesh_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/collision/collision_checker.h"
#include "kinematics/collision/shape_extent.h"
#include "tests/built_paths.h"
#include "tests/kinematics/model/mesh_boxes.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

class MeshFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = BuildFolder() + "/test_files/mesh_file/" + testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) {
    return WriteFileAtomically(folder_ + "/" + name, text).value();
  }
  std::string ReasonRefused(const std::string& path) {
    const Result<Mesh> mesh = ReadMesh(path);
    return mesh.ok() ? "" : mesh.failure().message;
  }
  /// The message of loading a robot with four legs and this foot.
  std::string Load(const std::string& foot) {
    const Result<RobotModel> model = LoadRobot(Write("robot.urdf", FourLegs(foot)));
    return model.ok() ? "" : model.failure().message;
  }

  std::string folder_;
};

const Vector3 kHalf(0.1, 0.05, 0.01);

TEST_F(MeshFile, EveryKindGivesTheSameBox) {
  const std::vector<Vector3> corners = HullPoints(BoxCorners(2.0 * kHalf));
  ASSERT_EQ(corners.size(), 8U);
  for (const std::string& path :
       {Write("binary.stl", BinaryStl(kHalf)), Write("text.STL", TextStl(kHalf)), Write("box.obj", Obj(kHalf)),
        Write("box.dae", Collada(kHalf, 1.0)), Write("mm.dae", Collada(1e3 * kHalf, 1e-3))}) {
    const Result<Mesh> mesh = ReadMesh(path);
    ASSERT_TRUE(mesh.ok()) << mesh.failure().message;
    EXPECT_EQ(mesh->triangles.size(), 12U) << path;
    const std::vector<Vector3> hull = HullPoints(mesh->vertices);
    ASSERT_EQ(hull.size(), 8U) << path;
    for (std::size_t i = 0; i < 8; ++i) EXPECT_LT((hull[i] - corners[i]).norm(), 1e-7) << path;
  }
}

TEST_F(MeshFile, ManyPointsOfABallKeepItsSurface) {
  std::vector<Vector3> points;
  for (int i = 0; i < 20000; ++i)
    points.push_back(0.3 * Vector3(std::sin(i), std::cos(2.3 * i), std::sin(3.7 * i + 1.0)).normalized());
  points.insert(points.end(), 1000, Vector3::Zero());
  const std::vector<Vector3> hull = HullPoints(points);
  EXPECT_LE(hull.size(), 1024U);
  for (const Vector3& d : points) {
    if (d.norm() == 0.0) continue;
    double farthest = 0.0;
    for (const Vector3& p : hull) farthest = std::max(farthest, p.dot(d.normalized()));
    ASSERT_GT(farthest, 0.3 * 0.994);
  }
}

TEST_F(MeshFile, RefusesWhatIsNoMeshWithTheReason) {
  ExpectSays(ReasonRefused(folder_ + "/no.stl"), {"does not exist", "no.stl"});
  ExpectSays(ReasonRefused(Write("a.ply", "ply")), {"a.ply", "'.stl', '.obj', '.dae'"});
  ExpectSays(ReasonRefused(Write("cut.stl", BinaryStl(kHalf).substr(0, 200))), {"cut.stl", "cannot be read"});
  ExpectSays(ReasonRefused(Write("empty.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")), {"empty.obj"});
}

TEST_F(MeshFile, FindsPathsFilesAndPackages) {
  const std::string file = Write("my_robot/meshes/foot.stl", BinaryStl(kHalf));
  Write("other/package.xml", "<package><name>named</name></package>");
  const std::string named = Write("other/meshes/foot.stl", BinaryStl(kHalf));
  Write("my_robot/urdf/r.urdf", "");
  const std::string from = folder_ + "/my_robot/urdf";
  const auto same = [&](const std::string& name, const std::string& where, const std::string& expected) {
    const Result<std::string> found = FindMeshFile(name, where);
    ASSERT_TRUE(found.ok()) << found.failure().message;
    EXPECT_TRUE(fs::equivalent(*found, expected)) << name << " gives " << *found;
  };
  same("../meshes/foot.stl", from, file);
  same(file, from, file);
  same("file://" + fs::absolute(file).string(), from, file);
  same("package://my_robot/meshes/foot.stl", from, file);
  same("package://named/meshes/foot.stl", folder_ + "/other/urdf", named);
  same("package://another_name/meshes/foot.stl", from, file);  // a copy in a folder of its own name
  same("package:///meshes/foot.stl", folder_ + "/my_robot", file);
  const fs::path here = fs::current_path();
  fs::current_path(from);  // a URDF that is named without a folder
  same("../meshes/foot.stl", "", "../meshes/foot.stl");
  same("package://my_robot/meshes/foot.stl", "", "../meshes/foot.stl");
  fs::current_path(here);
  ExpectSays(FindMeshFile("meshes/foo.stl", from).failure().message,
             {"'meshes/foo.stl' does not exist", "urdf/meshes/foo.stl"});
  ExpectSays(FindMeshFile("package://nowhere/foo.stl", from).failure().message,
             {"package://nowhere/foo.stl", "no folder"});
  ExpectSays(FindMeshFile("http://x/foo.stl", from).failure().message, {"http://x/foo.stl", "'package://NAME/'"});
}

TEST_F(MeshFile, CollisionMeshesMustBeThereAndReadable) {
  ExpectSays(Load("<mesh filename='no.stl'/>"), {"link 'A_foot'", "'no.stl' does not exist"});
  Write("bad.stl", "solid nonsense");
  ExpectSays(Load("<mesh filename='bad.stl'/>"), {"link 'A_foot'", "bad.stl"});
  ExpectSays(Load("<mesh/>"), {"link 'A_foot'", "<mesh> has no 'filename'"});
  ExpectSays(Load("<mesh filename=''/>"), {"link 'A_foot'", "empty 'filename'"});
  Write("foot.stl", BinaryStl(kHalf));
  ExpectSays(Load("<mesh filename='foot.stl' scale='a b c'/>"), {"link 'A_foot'", "mesh scale", "'a' is not"});
  ExpectSays(Load("<mesh filename='foot.stl' scale='1 1'/>"), {"link 'A_foot'", "3 are needed"});
  ExpectSays(Load("<mesh filename='foot.stl' scale='1 0 1'/>"), {"link 'A_foot'", "scale 0"});
  EXPECT_EQ(Load("<mesh filename='foot.stl'/>"), "");
}

TEST_F(MeshFile, AMissingPictureIsANote) {
  const std::string urdf =
      Replaced(FourLegs(), "<link name='A_foot'>",
               "<link name='A_foot'><visual><geometry><mesh filename='no.dae'/></geometry></visual>");
  const Result<RobotModel> model = LoadRobot(Write("robot.urdf", urdf));
  ASSERT_TRUE(model.ok()) << model.failure().message;
  std::string notes;
  for (const std::string& note : model->notes) notes += note + "\n";
  ExpectSays(notes, {"link 'A_foot' is not drawn", "'no.dae' does not exist"});
}

TEST_F(MeshFile, WhereFeetAreKnownAMissingMeshIsReported) {
  const std::string mesh = "<collision><geometry><mesh filename='no.stl'/></geometry></collision></link>";
  const std::string thigh = SmallLink("A_thigh"), foot = SmallLink("A_foot", "<sphere radius='0.02'/>");
  std::string urdf = FourLegs();
  for (const std::string& link : {thigh, foot}) urdf = Replaced(urdf, link, Replaced(link, "</link>", mesh));
  const Result<RobotModel> model = LoadRobot(Write("robot.urdf", urdf));
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_EQ(model->feet[0].type, FootType::kSphere);
  EXPECT_EQ(model->feet[0].radius, 0.02);
  ASSERT_EQ(model->missing_meshes.size(), 2U);
  const auto said = std::find_if(model->findings.begin(), model->findings.end(), [](const Finding& f) {
    return f.code == FailureCode::kMissingMesh && f.part == RobotPart{PartKind::kLink, "A_foot"};
  });
  ASSERT_NE(said, model->findings.end());
  EXPECT_EQ(said->level, FindingLevel::kInfo);
  ExpectSays(said->message, {"the mesh 'no.stl' does not exist", "only the other shapes of its body are used"});
  const Result<RobotModel> text = LoadRobotFromText(model->urdf_text, "", model->name, model->meshes);
  ASSERT_TRUE(text.ok()) << text.failure().message;
  EXPECT_EQ(text->hash, model->hash);
}

TEST_F(MeshFile, TheCoreOfItsInertiaBoxStandsForAMissingMesh) {
  // A box of 1 kg with edges of 0.1, 0.2 and 0.3 m.
  const std::string mesh = "<collision><geometry><mesh filename='no.stl'/></geometry></collision></link>";
  const std::string thigh = SmallLink("A_thigh");
  std::string boxed = Replaced(Replaced(thigh, "</link>", mesh), "ixx='0.01' iyy='0.01' izz='0.01'",
                               "ixx='0.0108333333' iyy='0.0083333333' izz='0.0041666667'");
  boxed = Replaced(boxed, "<mass", "<origin xyz='0 0 -0.1'/><mass");
  const Result<RobotModel> model = LoadRobot(Write("robot.urdf", Replaced(FourLegs(), thigh, boxed)));
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const auto box = std::find_if(model->collision_shapes.begin(), model->collision_shapes.end(),
                                [](const Shape& shape) { return shape.link == "A_thigh"; });
  ASSERT_NE(box, model->collision_shapes.end());
  EXPECT_EQ(box->type, ShapeType::kBox);
  EXPECT_TRUE(box->X_BS.translation().isApprox(Vector3(0.0, 0.0, -0.1)));
  const Vector3 along = (box->X_BS.linear() * box->size.asDiagonal()).cwiseAbs().rowwise().sum();
  EXPECT_TRUE(along.isApprox(0.5 * Vector3(0.1, 0.2, 0.3), 1e-6)) << along.transpose();
  const auto warning = std::find_if(model->findings.begin(), model->findings.end(),
                                    [](const Finding& f) { return f.code == FailureCode::kMissingMesh; });
  ASSERT_NE(warning, model->findings.end());
  EXPECT_EQ(PartText(warning->part), "link 'A_thigh'");
}

TEST_F(MeshFile, AMeshThatCannotBeReadIsReplacedAsAMissingOneIs) {
  const std::string thigh = SmallLink("A_thigh");
  Write("bad.stl", "solid nonsense");
  Write("skin.ply", "ply");
  for (const auto& [mesh, reason] :
       {std::pair("bad.stl", "has no triangles"), std::pair("skin.ply", "in an unsupported format")}) {
    const std::string with =
        Replaced(thigh, "</link>",
                 std::string("<collision><geometry><mesh filename='") + mesh + "'/></geometry></collision></link>");
    const std::string file = Write("robot.urdf", Replaced(FourLegs(), thigh, with));
    const Result<RobotModel> model = LoadRobot(file);
    ASSERT_TRUE(model.ok()) << model.failure().message;
    const auto warning = std::find_if(model->findings.begin(), model->findings.end(),
                                      [](const Finding& f) { return f.code == FailureCode::kMissingMesh; });
    ASSERT_NE(warning, model->findings.end()) << mesh;
    EXPECT_EQ(PartText(warning->part), "link 'A_thigh'");
    ExpectSays(warning->message, {mesh, reason, "inertia box"});
    EXPECT_FALSE(LoadRobot(file, {.strict = true}).ok());
    ExpectSays(Load(std::string("<mesh filename='") + mesh + "'/>"), {"robot.urdf, line 1: link 'A_foot'", reason});
  }
}

TEST_F(MeshFile, AMissingMeshIsAWarningWhereNothingStandsForIt) {
  const std::string mesh = "<collision><geometry><mesh filename='no.stl'/></geometry></collision></link>";
  const std::string thigh = SmallLink("A_thigh");
  const std::string large = Replaced(Replaced(thigh, "</link>", mesh), "='0.01'", "='0.9'");  // a box of 2.3 m
  const std::string file = Write("robot.urdf", Replaced(FourLegs(), thigh, large));
  const Result<RobotModel> model = LoadRobot(file);
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const auto warning = std::find_if(model->findings.begin(), model->findings.end(),
                                    [](const Finding& f) { return f.code == FailureCode::kMissingMesh; });
  ASSERT_NE(warning, model->findings.end());
  EXPECT_EQ(warning->level, FindingLevel::kWarning);
  ExpectSays(warning->message, {"no contact of this link is checked"});
  EXPECT_FALSE(LoadRobot(file, {.strict = true}).ok());
}

TEST_F(MeshFile, ARefusalHasFileAndLine) {
  const std::string broken = Replaced(FourLegs(), "<link name='A_shank'>", "\n\n<link name='A_shank'>");
  const std::string file = Write("robot.urdf", Replaced(broken, "<link name='A_shank'><inertial><mass value='1'/>",
                                                        "<link name='A_shank'><inertial><mass value='-1'/>"));
  const Result<RobotModel> model = LoadRobot(file);
  ASSERT_FALSE(model.ok());
  ExpectSays(model.failure().message, {"robot.urdf, line 3: link 'A_shank': its mass is -1 kg"});
}

TEST_F(MeshFile, ARefusalOfTheWholeDocumentHasTheFile) {
  const auto message = [&](const std::string& text) {
    const Result<RobotModel> model = LoadRobot(Write("robot.urdf", text));
    return model.ok() ? "" : model.failure().message;
  };
  ExpectSays(message("<robot>\n<link name='a'>\n</robot>"), {"robot.urdf: ", "not XML: line", "not closed"});
  ExpectSays(message("<html/>"), {"robot.urdf: the root element is <html>"});
  ExpectSays(message("<robot/>"), {"robot.urdf: the URDF has no link"});
  ExpectSays(message("<robot>\n<link/></robot>"), {"robot.urdf: a link in line 2", "has no 'name'"});
  const std::string apart = Replaced(FourLegs(), "<child link='A_thigh'/>", "<child link='A_foot'/>");
  ExpectSays(message(Replaced(apart, "<link name='A_foot'", "<link name='B_extra'/><link name='A_foot'")),
             {"robot.urdf"});
}

TEST_F(MeshFile, APointerOfGitLfsAndAnEmptyFileAreNamed) {
  const auto message = [&](const std::string& text) { return LoadRobot(Write("robot.urdf", text)).failure().message; };
  ExpectSays(message("version https://git-lfs.github.com/spec/v1\noid sha256:4d\nsize 9\n"), {"Git LFS"});
  ExpectSays(message(" \n"), {"is empty"});
}

TEST_F(MeshFile, AFootThatNothingElseTellsOfIsToBeSaid) {
  Write("robot.urdf", FourLegs("<mesh filename='no.stl'/>"));
  const Result<RobotModel> untold = LoadRobot(folder_ + "/robot.urdf");
  ASSERT_FALSE(untold.ok());
  ASSERT_EQ(untold.failure().suggestions.size(), 2U);
  ExpectSays(untold.failure().suggestions[1].text,
             {"{link: A_foot, radius_m: R}", "{link: D_foot, radius_m: R}", "'sole_m'"});
  std::string feet;
  for (const std::string leg : {"A", "B", "C", "D"}) feet += "  - {link: " + leg + "_foot, radius_m: 0.03}\n";
  Write("robot.yaml", "feet:\n" + feet);
  const Result<RobotModel> loaded = LoadRobot(folder_ + "/robot.urdf");
  ASSERT_TRUE(loaded.ok()) << loaded.failure().message;
  EXPECT_EQ(loaded->feet[3].radius, 0.03);
}

TEST_F(MeshFile, ScaleAndPlaceAreKept) {
  Write("foot.stl", BinaryStl(10.0 * kHalf));
  const Result<RobotModel> model =
      LoadRobot(Write("robot.urdf", FourLegs("<mesh filename='foot.stl' scale='0.1 -0.1 0.1'/>")));
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const Shape& shape = model->collision_shapes[1];
  ASSERT_EQ(shape.vertices.size(), 8U);
  for (const Vector3& v : shape.vertices) EXPECT_LT((v.cwiseAbs() - kHalf).norm(), 1e-7);
  DynamicsScratch scratch(*model);
  ForwardKinematics(*model, StandingConfiguration(*model), scratch);
  EXPECT_NEAR(LowestVertex(scratch, shape), LowestPoint(scratch, shape).z(), 1e-12);
}

TEST_F(MeshFile, TextsAndHullsMakeTheSameRobot) {
  Write("foot.stl", BinaryStl(kHalf));
  const Result<RobotModel> file = LoadRobot(Write("robot.urdf", FourLegs("<mesh filename='foot.stl'/>")));
  ASSERT_TRUE(file.ok()) << file.failure().message;
  ASSERT_EQ(file->meshes.size(), 1U);
  const Result<RobotModel> text = LoadRobotFromText(file->urdf_text, file->yaml_text, file->name, file->meshes);
  ASSERT_TRUE(text.ok()) << text.failure().message;
  EXPECT_EQ(text->hash, file->hash);
  EXPECT_EQ(text->standing_joints, file->standing_joints);
  std::vector<MeshHull> other = file->meshes;
  other[0].vertices[0].x() -= 1e-3;
  EXPECT_NE(LoadRobotFromText(file->urdf_text, file->yaml_text, file->name, other)->hash, file->hash);
  ExpectSays(MessageOf(file->urdf_text), {"link 'A_foot'", "'foot.stl'"});
}

TEST_F(MeshFile, MeshesCollideAsBoxesDo) {
  Write("foot.stl", BinaryStl(Vector3(0.03, 0.03, 0.03)));
  const RobotModel mesh = LoadRobot(Write("robot.urdf", FourLegs("<mesh filename='foot.stl'/>"))).value();
  const RobotModel box = LoadRobotFromText(FourLegs("<box size='0.06 0.06 0.06'/>"), "").value();
  int touching = 0;
  for (double angle = -1.9; angle < 1.0; angle += 0.02) {
    std::string found[2];
    for (const RobotModel* model : {&mesh, &box}) {
      CollisionChecker checker(*model);
      DynamicsScratch scratch(*model);
      VectorX q = StandingConfiguration(*model);
      q[7 + model->DofIndex("A_hip")] = angle;
      q[7 + model->DofIndex("A_knee")] = 0.0;
      q[7 + model->DofIndex("C_hip")] = -angle;
      q[7 + model->DofIndex("C_knee")] = 0.0;
      ForwardKinematics(*model, q, scratch);
      for (const Overlap& overlap : checker.Overlaps(scratch))
        found[model == &box] += overlap.link_a + " " + overlap.link_b + "; ";
    }
    EXPECT_EQ(found[0], found[1]) << angle;
    touching += found[0].empty() ? 0 : 1;
  }
  EXPECT_GT(touching, 3);
}

}  // namespace
}  // namespace gaitwright
