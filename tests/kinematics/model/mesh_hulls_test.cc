// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/model/mesh_file.h"
#include "kinematics/model/mesh_hulls_internal.h"
#include "tests/built_paths.h"
#include "tests/kinematics/model/mesh_boxes.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

class MeshHullsOfFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = BuildFolder() + "/test_files/mesh_hulls/" + testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) {
    return WriteFileAtomically(folder_ + "/" + name, text).value();
  }

  std::string folder_;
};

const Vector3 kHulledBox(0.11, 0.057, 0.013);

TEST_F(MeshHullsOfFiles, EqualFilesAreHulledOnce) {
  MeshHulls hulls;
  const std::string one = Write("one.stl", BinaryStl(kHulledBox)), two = Write("other/two.STL", BinaryStl(kHulledBox));
  const Result<std::vector<Vector3>> first = hulls.Of(one), second = hulls.Of(two), again = hulls.Of(one);
  ASSERT_TRUE(first.ok() && second.ok() && again.ok());
  EXPECT_EQ(hulls.size(), 1U);
  EXPECT_EQ(first->size(), 8U);
  EXPECT_EQ(*first, *second);
  EXPECT_EQ(*first, *again);
}

TEST_F(MeshHullsOfFiles, AFileThatChangedIsReadAnew) {
  MeshHulls hulls;
  const std::string file = Write("one.stl", BinaryStl(kHulledBox));
  const std::vector<Vector3> before = hulls.Of(file).value();
  Write("one.stl", BinaryStl(2.0 * kHulledBox));  // as many bytes
  const std::vector<Vector3> after = hulls.Of(file).value();
  EXPECT_EQ(hulls.size(), 2U);
  EXPECT_NEAR(after[0].norm(), 2.0 * before[0].norm(), 1e-6);
}

TEST_F(MeshHullsOfFiles, TheEndingBelongsToTheContent) {
  MeshHulls hulls;
  ASSERT_TRUE(hulls.Of(Write("box.obj", Obj(kHulledBox))).ok());
  EXPECT_FALSE(hulls.Of(Write("box.stl", Obj(kHulledBox))).ok());
  EXPECT_EQ(hulls.size(), 1U);
}

TEST_F(MeshHullsOfFiles, AFailureIsNotKept) {
  MeshHulls hulls;
  EXPECT_FALSE(hulls.Of(folder_ + "/one.stl").ok());
  Write("one.stl", "solid nonsense");
  EXPECT_EQ(hulls.Of(folder_ + "/one.stl").failure().code, FailureCode::kMeshEmpty);
  Write("one.stl", BinaryStl(kHulledBox));
  EXPECT_TRUE(hulls.Of(folder_ + "/one.stl").ok());
}

TEST_F(MeshHullsOfFiles, ARobotLoadedTwiceWithOneMeshOnAllFeetIsHulledOnce) {
  Write("foot.stl", BinaryStl(Vector3(0.0213, 0.0213, 0.0213)));
  std::string urdf = FourLegs("<mesh filename='foot.stl'/>");
  Write("foot2.stl", BinaryStl(Vector3(0.0213, 0.0213, 0.0213)));
  urdf.replace(urdf.rfind("foot.stl"), 8, "foot2.stl");
  const std::string file = Write("robot.urdf", urdf);
  const std::size_t before = HullsOfThisRun().size();
  const Result<RobotModel> once = LoadRobot(file), twice = LoadRobot(file);
  ASSERT_TRUE(once.ok() && twice.ok()) << (once.ok() ? "" : once.failure().message);
  EXPECT_EQ(HullsOfThisRun().size(), before + 1);
  EXPECT_EQ(once->hash, twice->hash);
  EXPECT_EQ(once->meshes.size(), 2U);
}

}  // namespace
}  // namespace gaitwright
