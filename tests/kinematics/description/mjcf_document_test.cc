// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <map>

#include "kinematics/base/file.h"
#include "kinematics/model/robot_yaml.h"
#include "tests/kinematics/description/mjcf_texts.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

/// Files by name.
MjcfFiles FilesOf(std::map<std::string, std::string> texts) {
  MjcfFiles files;
  files.text = [texts = std::move(texts)](const std::string& file) -> Result<std::string> {
    const auto at = texts.find(file);
    if (at != texts.end()) return at->second;
    return Failure{FailureKind::kBadInput, FailureCode::kNoFile, "ReadFile", "there is no file '" + file + "'", {}};
  };
  return files;
}

TEST(MjcfDocument, ItsRootElementTellsAModelFromAUrdf) {
  EXPECT_TRUE(IsMjcf("<mujoco/>"));
  EXPECT_TRUE(IsMjcf("\xEF\xBB\xBF<?xml version='1.0'?>\n<!-- <robot> -->\n<!DOCTYPE x>\n<mujoco model='a'>"));
  EXPECT_TRUE(IsMjcf(" <mujocoinclude>"));
  for (const char* other : {"", "<", "<robot name='mujoco'>", "mujoco", "<!-- <mujoco> -->", "<?xml", "<mujocos>"})
    EXPECT_FALSE(IsMjcf(other)) << other;
}

TEST(MjcfDocument, IncludedFilesStandInPlaceOfTheirElement) {
  const std::string model =
      "<mujoco><include file='parts/settings.xml'/><worldbody><body name='base'><freejoint/>"
      "<include file='parts/leg.xml'/></body></worldbody></mujoco>";
  const MjcfFiles files = FilesOf({{"parts/settings.xml",
                                    "<mujocoinclude><compiler angle='radian'/><default><joint damping='3'/></default>"
                                    "</mujocoinclude>"},
                                   {"parts/leg.xml", "<mujocoinclude>\n<include file='joint.xml'/></mujocoinclude>"},
                                   {"parts/joint.xml",
                                    "<mujoco>\n<geom size='0.1'/>\n<body name='leg'><joint name='j' range='-1 1'/>\n"
                                    "<geom type='mesh' mesh='m'/><geom size='1'/></body></mujoco>"}});
  const std::string message = MjcfMessage(model, files);
  ExpectSays(message, {"parts/joint.xml, line 4: <geom>", "no mesh 'm'"});
  const std::string without = Replaced(model, "<worldbody>", "<asset><mesh name='m' file='m.stl'/></asset><worldbody>");
  MjcfFiles with_mesh = files;
  with_mesh.mesh = [](const std::string&) -> Result<MjcfMesh> {
    return MjcfMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  };
  const RobotModel tree = TreeOf(Converted(without, with_mesh));
  EXPECT_EQ(JointNamed(tree, "j").damping, 3.0);
  EXPECT_EQ(JointNamed(tree, "j").upper, 1.0);
}

TEST(MjcfDocument, SectionsAndCompilersAddUp) {
  const std::string text =
      "<mujoco><compiler angle='radian' eulerseq='zyx'/><worldbody><geom size='1'/></worldbody>"
      "<worldbody><body name='a'><joint type='free'/><geom size='1'/></body></worldbody><compiler eulerseq='xyz'/>"
      "<worldbody><body name='b'><freejoint/><geom size='1'/><body name='c' euler='0.1 0.2 0.3'><joint name='j'/>"
      "<geom size='1'/></body></body></worldbody></mujoco>";
  const ConvertedMjcf converted = Converted(text);
  ExpectNote(converted, {"body 'a'", "not part of the robot, whose first body is 'b'"});
  const Matrix3 R = TreeOf(converted).joints[0].X_PJ.linear();
  EXPECT_NEAR(R(0, 2), std::sin(0.2), 1e-12);  // Rx Ry Rz, in radians
}

TEST(MjcfDocument, ReadsFilesBesideTheModel) {
  const std::string path = ScratchFile("mjcf/robot.xml");
  ASSERT_TRUE(WriteFileAtomically(ScratchFile("mjcf/sub/leg.xml"), "<mujoco><geom size='0.1'/></mujoco>"));
  ASSERT_TRUE(WriteFileAtomically(path,
                                  "<mujoco model='two words'><worldbody><body name='b'><freejoint/><include "
                                  "file='sub/leg.xml'/></body></worldbody></mujoco>"));
  const Result<ConvertedMjcf> converted = ConvertMjcf(path);
  ASSERT_TRUE(converted.ok()) << converted.failure().message;
  EXPECT_EQ(ParseRobotYaml(converted->yaml).name, "two words");
  ASSERT_TRUE(WriteFileAtomically(path, "<mujoco>\n<include file='none.xml'/></mujoco>"));
  ExpectSays(ConvertMjcf(path).failure().message, {"robot.xml, line 2: <include>", "none.xml"});
  ExpectSays(ConvertMjcf(ScratchFile("mjcf/nowhere.xml")).failure().message, {"nowhere.xml"});
}

TEST(MjcfDocument, RefusesIncludesThatGoInCirclesOrAreNotThere) {
  const std::string model = "<mujoco>\n<include file='a.xml'/></mujoco>";
  ExpectSays(MjcfMessage(model), {"model.xml, line 2: <include>", "'a.xml' was not given with the model's text"});
  ExpectSays(MjcfMessage(model, FilesOf({})), {"model.xml, line 2", "there is no file 'a.xml'"});
  ExpectSays(MjcfMessage(model, FilesOf({{"a.xml", "<mujoco><include file='./a.xml'/></mujoco>"}})),
             {"a.xml, line 1", "included twice, or includes itself"});
  ExpectSays(MjcfMessage(model, FilesOf({{"a.xml", "<mujoco><b></mujoco>"}})), {"a.xml, line 1: it is not XML"});
  ExpectSays(MjcfMessage("<mujoco><include/></mujoco>"), {"line 1: <include>", "no 'file'"});
  std::map<std::string, std::string> many;
  std::string includes;
  for (int i = 0; i < 101; ++i) {
    many[fmt::format("{}.xml", i)] = "<mujoco/>";
    includes += fmt::format("<include file='{}.xml'/>", i);
  }
  ExpectSays(MjcfMessage("<mujoco>" + includes + "</mujoco>", FilesOf(many)), {"over 100 files"});
}

TEST(MjcfDocument, RefusesWhatIsNoModel) {
  ExpectSays(MjcfMessage("<robot/>"), {"model.xml", "<robot>", "has <mujoco>"});
  ExpectSays(MjcfMessage("<mujoco>\n<a></b></mujoco>"), {"model.xml, line 2: it is not XML"});
  ExpectSays(MjcfMessage(""), {"not XML"});
  ExpectSays(MjcfMessage(std::string("<mujoco>\0</mujoco>", 18)), {"0x00"});
  ExpectSays(MjcfMessage("<mujoco model='&#x0;'/>"), {"0x00"});
  ExpectSays(MjcfMessage("<mujoco/>"), {"no body"});
}

TEST(MjcfDocument, RefusesWhatIsTooLarge) {
  ExpectSays(MjcfMessage("<mujoco>" + std::string(std::size_t{17} << 20, ' ') + "</mujoco>"), {"16777216 bytes"});
  std::string bodies, deep, classes;
  for (int i = 0; i < 1001; ++i) bodies += "<body/>";
  ExpectSays(MjcfMessage("<mujoco><worldbody>" + bodies + "</worldbody></mujoco>"), {"over 1000 bodies"});
  for (int i = 0; i < 600; ++i) classes += fmt::format("<default class='c{}'/>", i);
  ExpectSays(MjcfMessage("<mujoco><default>" + classes + "</default></mujoco>"), {"over 500 classes"});
  std::string attributes;
  for (int i = 0; i < 1001; ++i) attributes += fmt::format(" a{}='='", i);
  ExpectSays(MjcfMessage("<mujoco" + attributes + "/>"), {"over 1000 attributes"});
  ExpectSays(MjcfMessage("<mujoco><!--" + std::string(2000, '=') + "--></mujoco>"), {"no body"});
  // The depth of an included file adds to that of its <include>.
  std::map<std::string, std::string> files;
  for (int i = 0; i < 4; ++i) {
    std::string text = fmt::format("<include file='{}.xml'/>", i + 1);
    for (int level = 0; level < 60; ++level) text = "<body>" + text + "</body>";
    files[fmt::format("{}.xml", i)] = "<mujoco>" + text + "</mujoco>";
  }
  files["4.xml"] = "<mujoco/>";
  ExpectSays(MjcfMessage("<mujoco><worldbody><include file='0.xml'/></worldbody></mujoco>", FilesOf(files)),
             {"over 200 levels deep"});
}

}  // namespace
}  // namespace gaitwright
