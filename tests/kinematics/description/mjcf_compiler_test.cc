// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "kinematics/description/mjcf_compiler_internal.h"
#include "tests/kinematics/description/mjcf_texts.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

MjcfCompiler CompilerOf(const std::string& sections) {
  return ReadMjcfCompiler(MjcfDocument("<mujoco>" + sections + "</mujoco>", "model.xml", {}));
}

TEST(MjcfCompiler, WithoutOneThereAreMuJoCosDefaults) {
  const MjcfCompiler compiler = CompilerOf("");
  EXPECT_TRUE(compiler.degrees);
  EXPECT_EQ(compiler.eulerseq, "xyz");
  EXPECT_EQ(compiler.meshdir, "");
  EXPECT_FALSE(compiler.strippath);
  EXPECT_TRUE(compiler.autolimits);
  EXPECT_EQ(compiler.inertia, MjcfInertiaSource::kInertialElseGeoms);
  EXPECT_EQ(compiler.lowest_group, 0.0);
  EXPECT_EQ(compiler.highest_group, 5.0);
  EXPECT_EQ(compiler.boundmass + compiler.boundinertia + compiler.settotalmass, 0.0);
  EXPECT_NEAR(compiler.Radians(180.0), std::numbers::pi, 1e-15);
}

TEST(MjcfCompiler, EachAttributeIsRead) {
  const MjcfCompiler compiler = CompilerOf(
      "<compiler angle='radian' eulerseq='ZyX' meshdir='meshes' strippath='true' autolimits='false' "
      "inertiafromgeom='false' inertiagrouprange='1 3' boundmass='0.1' boundinertia='0.2' balanceinertia='true' "
      "settotalmass='50'/>");
  EXPECT_EQ(compiler.Radians(180.0), 180.0);
  EXPECT_EQ(compiler.eulerseq, "ZyX");
  EXPECT_EQ(compiler.meshdir, "meshes");
  EXPECT_TRUE(compiler.strippath);
  EXPECT_FALSE(compiler.autolimits);
  EXPECT_EQ(compiler.inertia, MjcfInertiaSource::kInertial);
  EXPECT_EQ(compiler.lowest_group, 1.0);
  EXPECT_EQ(compiler.highest_group, 3.0);
  EXPECT_EQ(compiler.boundmass, 0.1);
  EXPECT_EQ(compiler.boundinertia, 0.2);
  EXPECT_TRUE(compiler.balanceinertia);
  EXPECT_EQ(compiler.settotalmass, 50.0);
  EXPECT_EQ(CompilerOf("<compiler inertiafromgeom='true'/>").inertia, MjcfInertiaSource::kGeoms);
  EXPECT_EQ(CompilerOf("<compiler settotalmass='-1'/>").settotalmass, 0.0);
}

TEST(MjcfCompiler, OfSeveralTheLastOneThatNamesAnAttributeCounts) {
  const MjcfCompiler compiler = CompilerOf(
      "<compiler angle='radian' meshdir='a'/><compiler eulerseq='zyx' meshdir='b'/><compiler angle='degree'/>");
  EXPECT_TRUE(compiler.degrees);
  EXPECT_EQ(compiler.eulerseq, "zyx");
  EXPECT_EQ(compiler.meshdir, "b");
}

TEST(MjcfCompiler, AssetdirIsTheFolderOfMeshesWithoutMeshdir) {
  EXPECT_EQ(CompilerOf("<compiler assetdir='assets'/>").meshdir, "assets");
  EXPECT_EQ(CompilerOf("<compiler assetdir='assets' meshdir='meshes'/>").meshdir, "meshes");
}

TEST(MjcfCompiler, RefusesValuesByTheirCode) {
  const std::vector<std::pair<std::string, FailureCode>> rows = {
      {"coordinate='global'", FailureCode::kMjcfCoordinate}, {"angle='deg'", FailureCode::kMjcfChoice},
      {"eulerseq='xy'", FailureCode::kMjcfChoice},           {"eulerseq='xyzx'", FailureCode::kMjcfChoice},
      {"eulerseq='abc'", FailureCode::kMjcfChoice},          {"autolimits='1'", FailureCode::kMjcfChoice},
      {"boundmass='heavy'", FailureCode::kMjcfNumber},       {"inertiagrouprange='1'", FailureCode::kMjcfNumber}};
  for (const auto& [attribute, code] : rows) {
    const Failure failure = MjcfFailureOf([&, &text = attribute] { CompilerOf("\n<compiler " + text + "/>"); });
    EXPECT_EQ(failure.code, code) << attribute;
    ExpectSays(failure.message, {"model.xml, line 2: <compiler>"});
  }
}

TEST(MjcfRotationOfZ, IsTheSmallestTurnOntoADirectionOfAnyLength) {
  RandomState random(3);
  for (int i = 0; i < 100; ++i) {
    const Vector3 direction = random.Vector(3);
    const Matrix3 R = MjcfRotationOfZ(direction);
    EXPECT_LT((R.col(2) - direction.normalized()).norm(), 1e-12);
    EXPECT_NEAR(R.determinant(), 1.0, 1e-12);
    EXPECT_NEAR(RotationLog(R).norm(), std::acos(direction.normalized().z()), 1e-9);
    EXPECT_NEAR(RotationLog(R).z(), 0.0, 1e-9) << "the axis lies across z";
    EXPECT_LT((MjcfRotationOfZ(7.0 * direction) - R).norm(), 1e-12);
  }
  EXPECT_EQ(MjcfRotationOfZ(Vector3(0, 0, 3)), Matrix3::Identity());
  EXPECT_LT((MjcfRotationOfZ(Vector3(0, 0, -3)) - Vector3(1, -1, -1).asDiagonal().toDenseMatrix()).norm(), 1e-12);
}

TEST(MjcfPose, OrientationsOfOneRotationAgree) {
  // 40 degrees about (1, 2, 2) / 3.
  const Matrix3 R = Eigen::AngleAxisd(40.0 * kDegree, Vector3(1, 2, 2) / 3.0).toRotationMatrix();
  const Quaternion q(R);
  const auto text = [](std::initializer_list<double> numbers) {
    std::string all;
    for (const double number : numbers) all += fmt::format("{:.17g} ", number);
    return all;
  };
  const std::vector<MjcfAttributes::Values> same = {
      {{"pos", "1 2 3"}, {"quat", text({-2.0 * q.w(), -2.0 * q.x(), -2.0 * q.y(), -2.0 * q.z()})}},
      {{"pos", "1 2 3"}, {"axisangle", "1 2 2 40"}},
      {{"pos", "1 2 3"}, {"xyaxes", text({R(0, 0), R(1, 0), R(2, 0), R(0, 1), R(1, 1), R(2, 1)})}}};
  for (const MjcfAttributes::Values& values : same) {
    const Pose X = MjcfPose(MjcfAttributes("here", values), MjcfCompiler());
    EXPECT_EQ(X.translation(), Vector3(1, 2, 3));
    EXPECT_LT((X.linear() - R).norm(), 1e-12);
  }
  EXPECT_EQ(MjcfFailureOf([] {
              MjcfRotation(MjcfAttributes("here", {{"quat", "1 0 0 0"}, {"zaxis", "0 0 1"}}), MjcfCompiler());
            }).code,
            FailureCode::kMjcfOrientation);
}

}  // namespace
}  // namespace gaitwright
