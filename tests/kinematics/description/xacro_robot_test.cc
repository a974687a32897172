// SPDX-License-Identifier: BSD-3-Clause
// A complete quadruped in several files: macros for legs and inertias, sizes in YAML, a package.
#include <gtest/gtest.h>

#include <numbers>

#include "kinematics/base/file.h"
#include "kinematics/model/load_robot.h"
#include "tests/built_paths.h"
#include "tests/kinematics/description/xacro_files.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

const std::string kMadeQuadruped = SourceFolder() + "/tests/kinematics/description/made_quadruped/urdf/robot.xacro";

TEST(XacroRobot, AQuadrupedHasFourLegsOfThreeJoints) {
  const Result<std::string> urdf = ExpandXacro({kMadeQuadruped, {}, {}});
  ASSERT_TRUE(urdf.ok()) << urdf.failure().message;
  EXPECT_FALSE(IsXacro(*urdf));
  const Result<RobotModel> model = LoadRobotFromText(*urdf, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  ASSERT_EQ(model->legs.size(), 4U);
  for (const Leg& leg : model->legs) EXPECT_EQ(leg.joints.size(), 3U) << leg.name;
  EXPECT_EQ(model->num_dofs(), 12);
  EXPECT_NE(urdf->find("<robot name=\"made\">"), std::string::npos);
  EXPECT_EQ(urdf->find("gazebo"), std::string::npos);
  EXPECT_NE(urdf->find("<transmission name=\"RR_transmission\">"), std::string::npos);

  // The trunk has 9 kg. A leg has 1.75 m and a foot of 0.05 kg, where m is 0.8 kg in front and 0.9 kg behind.
  EXPECT_NEAR(model->total_mass_kg, 9.0 + 4 * 0.05 + 2 * 1.75 * (0.8 + 0.9), 1e-12);
  const int hip = model->DofIndex("FR_hip_joint");
  EXPECT_EQ(model->dof_lower(hip), -std::numbers::pi / 4);
  for (const Foot& foot : model->feet) EXPECT_EQ(foot.radius, 0.02);
}

TEST(XacroRobot, LeftAndRightMirrorEachOther) {
  const std::string urdf = ExpandXacro({kMadeQuadruped, {}, {}}).value();
  EXPECT_NE(urdf.find("<origin xyz=\"0.25 0.1 0\"/>"), std::string::npos);
  EXPECT_NE(urdf.find("<origin xyz=\"0.25 -0.1 0\"/>"), std::string::npos);
  EXPECT_NE(urdf.find("<origin xyz=\"-0.25 -0.1 0\"/>"), std::string::npos);
}

TEST(XacroRobot, ArgumentsChooseWhatItHas) {
  const Result<std::string> urdf = ExpandXacro({kMadeQuadruped, {{"simulated", "true"}, {"name", "other"}}, {}});
  ASSERT_TRUE(urdf.ok()) << urdf.failure().message;
  EXPECT_NE(urdf->find("<robot name=\"other\">"), std::string::npos);
  EXPECT_NE(urdf->find("<plugin name=\"control\" filename=\"libcontrol.so\"/>"), std::string::npos);
}

TEST(XacroRobot, TheSameFilesGiveTheSameText) {
  const std::string once = ExpandXacro({kMadeQuadruped, {}, {}}).value();
  EXPECT_EQ(once, ExpandXacro({kMadeQuadruped, {}, {}}).value());
  EXPECT_EQ(once, ExpandXacroText(once, "again", {}, SourcesWith({})).value());
}

TEST(XacroRobot, ATextInLatin1IsConvertedUnlessThatIsRefused) {
  const std::string file = ScratchFile("latin.xacro");
  ASSERT_TRUE(WriteFileAtomically(file, "<robot name='b\xf6t'><a b='${1 + 1}'/></robot>").ok());
  const Result<std::string> expanded = ExpandXacro({file, {}, {}});
  ASSERT_TRUE(expanded.ok()) << expanded.failure().message;
  EXPECT_NE(expanded->find("<robot name=\"b\u00f6t\">"), std::string::npos) << *expanded;
  EXPECT_EQ(ExpandXacro({file, {}, {}, true}).failure().code, FailureCode::kNotText);
}

TEST(XacroRobot, AFileThatDoesNotExistIsRefused) {
  const Result<std::string> none = ExpandXacro({"no/such.xacro", {}, {}});
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.failure().code, FailureCode::kNoSuchFile);
}

}  // namespace
}  // namespace gaitwright
