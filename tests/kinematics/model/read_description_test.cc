// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/read_description.h"

#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/model/robot_yaml.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

class ReadDescriptionTest : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(ScratchFile("description")); }

  static std::string Write(const std::string& name, const std::string& text) {
    std::string path = ScratchFile("description/" + name);
    EXPECT_TRUE(WriteFileAtomically(path, text).ok());
    return path;
  }
  static RobotDescription Read(const std::string& path, const RobotLoading& loading = {}) {
    const Result<RobotDescription> read = ReadDescription(path, loading);
    EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.failure().message);
    return read.ok() ? *read : RobotDescription();
  }
  static FailureCode CodeOf(const std::string& path, const RobotLoading& loading = {}) {
    const Result<RobotDescription> read = ReadDescription(path, loading);
    EXPECT_FALSE(read.ok());
    return read.failure().code;
  }
};

const char kTinyMjcf[] =
    "<mujoco model='tiny'><worldbody><body name='b'><freejoint/><geom size='1'/><body name='c'><joint name='j'/><geom "
    "size='1'/></body></body></worldbody><keyframe><key name='home' qpos='0 0 1 1 0 0 0 0.5'/></keyframe></mujoco>";

TEST_F(ReadDescriptionTest, TheContentDecidesTheKindOfFile) {
  const RobotDescription urdf = Read(Write("a.xml", FourLegs()));
  EXPECT_EQ(urdf.urdf, FourLegs());
  EXPECT_TRUE(urdf.findings.empty());
  const RobotDescription xacro = Read(Write("b.urdf", "<robot name='r'><link name='${1 + 1}'/></robot>"));
  ExpectSays(xacro.urdf, {"<link name=\"2\"/>"});
  ASSERT_EQ(xacro.findings.size(), 1U);
  EXPECT_EQ(xacro.findings[0].code, FailureCode::kXacro);
  const RobotDescription mjcf = Read(Write("c.urdf", kTinyMjcf));
  ExpectSays(mjcf.urdf, {"<robot", "name=\"j\""});
  ASSERT_FALSE(mjcf.findings.empty());
  EXPECT_EQ(mjcf.findings[0].code, FailureCode::kMjcf);
  EXPECT_EQ(CodeOf(Write("d.urdf", "<sdf version='1.7'/>")), FailureCode::kNotUrdf);
}

TEST_F(ReadDescriptionTest, TheYamlBesideTheFileIsTakenUnlessAnotherIsNamed) {
  const std::string path = Write("robot.urdf", FourLegs());
  EXPECT_EQ(Read(path).yaml, "");
  Write("robot.yaml", "name: beside\n");
  const std::string other = Write("other.yaml", "name: other\n");
  EXPECT_EQ(Read(path).yaml, "name: beside\n");
  RobotLoading loading;
  loading.yaml_path = other;
  EXPECT_EQ(Read(path, loading).yaml, "name: other\n");
  loading.yaml_path = "none";
  EXPECT_EQ(Read(path, loading).yaml, "");
  loading.yaml_path = ScratchFile("description/missing.yaml");
  EXPECT_EQ(CodeOf(path, loading), FailureCode::kNoSuchFile);
}

TEST_F(ReadDescriptionTest, OfAnMjcfTheYamlOfTheUserComesFirst) {
  const std::string path = Write("tiny.xml", kTinyMjcf);
  const RobotYaml own = ParseRobotYaml(Read(path).yaml);
  EXPECT_EQ(own.name, "tiny");
  ASSERT_EQ(own.standing.size(), 1U);
  EXPECT_EQ(own.standing[0].position, 0.5);
  Write("robot.yaml", "name: mine\nnominal_speed_m_s: 0.5");
  const RobotDescription both = Read(path);
  const RobotYaml joined = ParseRobotYaml(both.yaml);
  EXPECT_EQ(joined.name, "mine");
  EXPECT_EQ(joined.nominal_speed_m_s, 0.5);
  EXPECT_EQ(joined.standing.size(), 1U) << "what the user does not give is the model's";
  EXPECT_TRUE(ParseRobotYaml(both.yaml_without_posture).standing.empty());
  EXPECT_EQ(ParseRobotYaml(both.yaml_without_posture).name, "mine");
}

TEST_F(ReadDescriptionTest, ArgumentsOfAXacroFileAreTaken) {
  const std::string path =
      Write("r.xacro", "<robot xmlns:xacro='x'><xacro:arg name='n' default='a'/><link name='$(arg n)'/></robot>");
  ExpectSays(Read(path).urdf, {"<link name=\"a\"/>"});
  RobotLoading loading;
  loading.xacro_arguments = {{"n", "b"}};
  ExpectSays(Read(path, loading).urdf, {"<link name=\"b\"/>"});
  loading.xacro_arguments = {{"m", "b"}};
  EXPECT_EQ(CodeOf(path, loading), FailureCode::kUnknownArgument);
}

TEST_F(ReadDescriptionTest, OtherEncodingsAreConvertedUnlessStrict) {
  const std::string path = Write("latin.urdf", "<robot name='fu\xDF'/>");
  EXPECT_EQ(Read(path).urdf, "<robot name='fu\xC3\x9F'/>");
  RobotLoading strict;
  strict.strict = true;
  EXPECT_EQ(CodeOf(path, strict), FailureCode::kNotText);
  EXPECT_EQ(CodeOf(ScratchFile("description/none.urdf")), FailureCode::kNoSuchFile);
}

}  // namespace
}  // namespace gaitwright
