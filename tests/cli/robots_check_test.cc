// SPDX-License-Identifier: BSD-3-Clause
// The linter of robot descriptions.
#include <algorithm>
#include <filesystem>

#include "tests/cli/stranger.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright::cli {
namespace {

class RobotsCheck : public Stranger {
 protected:
  /// The findings of a kind.
  static std::vector<Json> Of(const Json& checked, const std::string& code) {
    std::vector<Json> found;
    for (const Json& finding : checked.at("findings")) {
      if (finding.at("code") == code) found.push_back(finding);
    }
    return found;
  }
};

TEST_F(RobotsCheck, RobotsOfOursHaveNoWarnings) {
  for (const char* robot : {"a1", "go1", "nao", "mini_cheetah", "laikago"}) {
    const Ran ran = Run({"robots", "check", robot, "--json"});
    EXPECT_EQ(ran.status, 0) << robot;
    EXPECT_EQ(ran.json().at("warnings"), 0) << robot << ran.json().at("findings");
    EXPECT_EQ(ran.json().at("verdict"), "walks");
  }
}

TEST_F(RobotsCheck, TheVerdictIsThatOfAPlan) {
  for (const char* robot : {"a1", "h1"}) {
    const Ran shown = Run({"robots", "show", robot, "--json"});
    const Ran planned = Run({"plan", "--robot", robot, "--distance", "1", "--quiet"});
    EXPECT_EQ(shown.json().at("verdict").get<std::string>().starts_with("walks"), planned.status == 0) << robot;
  }
}

TEST_F(RobotsCheck, WhatIsMendedIsAWarningWithItsPlace) {
  Write("robot.urdf", Replaced(FourLegs(), "izz='0.01' ixy", "izz='0.03' ixy"));
  const Ran ran = Run({"robots", "check", "robot.urdf", "--json"});
  EXPECT_EQ(ran.status, 0);
  const std::vector<Json> found = Of(ran.json(), "impossible_inertia");
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().at("level"), "warning");
  EXPECT_EQ(found.front().at("part"), "link 'trunk'");
  EXPECT_GT(ran.json().at("warnings"), 0);
}

TEST_F(RobotsCheck, WhatIsRefusedIsAnErrorWithStatusOne) {
  Write("robot.urdf", Replaced(FourLegs(), "mass value='1'", "mass value='-1'"));
  const Ran ran = Run({"robots", "check", "robot.urdf", "--json"});
  EXPECT_EQ(ran.status, 1);
  EXPECT_EQ(ran.json().at("errors"), 1);
  EXPECT_EQ(Of(ran.json(), "negative_mass").size(), 1U);
}

TEST_F(RobotsCheck, TheRepairedFileIsTakenStrictly) {
  Write("robot.urdf", Replaced(Replaced(FourLegs(), "izz='0.01' ixy", "izz='0.03' ixy"), " lower='-2' upper='1'", ""));
  EXPECT_EQ(Run({"robots", "check", "robot.urdf", "--strict"}).status, 1);
  const Ran ran = Run({"robots", "check", "robot.urdf", "--repaired", "repaired.urdf", "--json"});
  EXPECT_EQ(ran.json().at("files").at("repaired"), "repaired.urdf");
  const Ran again = Run({"robots", "check", "repaired.urdf", "--strict", "--json"});
  EXPECT_EQ(again.status, 0) << again.out;
  EXPECT_TRUE(Of(again.json(), "impossible_inertia").empty());
}

TEST_F(RobotsCheck, LinesAreThoseOfTheFileOrNone) {
  const std::string urdf = Replaced(FourLegs(), "<link name='A_foot'>", "\n\n<link name='A_foot'>");
  Write("robot.urdf", Replaced(urdf, "radius='0.02'", "radius='0'"));
  EXPECT_EQ(Of(Run({"robots", "check", "robot.urdf", "--json"}).json(), "zero_size").front().at("line"), 3);
  const std::string declared =
      "<robot xmlns:xacro='http://www.ros.org/wiki/xacro' name='four'><xacro:property name='r' value='0'/>";
  Write("robot.xacro", Replaced(Replaced(urdf, "<robot name='four'>", declared), "radius='0.02'", "radius='${r}'"));
  const Ran expanded = Run({"robots", "check", "robot.xacro", "--json"});
  ASSERT_EQ(expanded.status, 0) << expanded.out;
  EXPECT_TRUE(Of(expanded.json(), "zero_size").front().at("line").is_null());
}

TEST_F(RobotsCheck, SizesAreJudged) {
  Write("heavy.urdf", Replaced(FourLegs(), "ixx='0.01' iyy='0.01' izz='0.01'", "ixx='3' iyy='3' izz='3'"));
  EXPECT_FALSE(Of(Run({"robots", "check", "heavy.urdf", "--json"}).json(), "large_inertia").empty());
  std::string one_side = FourLegs();
  const std::size_t at = one_side.find("effort='30'", one_side.find("B_knee"));
  one_side.replace(at, 11, "effort='13'");
  Write("sides.urdf", one_side);
  EXPECT_FALSE(Of(Run({"robots", "check", "sides.urdf", "--json"}).json(), "sides_differ").empty());
  Write("strong.urdf", Replaced(FourLegs(), "effort='30'", "effort='900'"));
  EXPECT_FALSE(Of(Run({"robots", "check", "strong.urdf", "--json"}).json(), "strong_motor").empty());
}

TEST_F(RobotsCheck, FilesGoByFlagsAsWithOtherVerbs) {
  Write("a.urdf", FourLegs());
  EXPECT_EQ(Run({"robots", "check", "--urdf", "a.urdf"}).out, Run({"robots", "check", "a.urdf"}).out);
  EXPECT_EQ(Run({"robots", "show", "--urdf", "a.urdf", "--json"}).json().at("name"), "a");
  EXPECT_EQ(Run({"robots", "check", "a.urdf", "--urdf", "a.urdf"}).status, 1);
  EXPECT_EQ(Run({"robots", "check"}).status, 1);
  EXPECT_EQ(Run({"robots", "show"}).status, 1);
}

TEST_F(RobotsCheck, TwoDescriptionsOfOneRobotAreCompared) {
  Write("a.urdf", FourLegs());
  Write("b.urdf", Replaced(FourLegs(), "upper='1'", "upper='1.5'"));
  const Ran same = Run({"robots", "check", "a.urdf", "--against", "a.urdf", "--json"});
  EXPECT_TRUE(Of(same.json(), "descriptions_differ").empty());
  const Ran differ = Run({"robots", "check", "a.urdf", "--against", "b.urdf", "--json"});
  EXPECT_EQ(Of(differ.json(), "descriptions_differ").size(), 8U);
}

}  // namespace
}  // namespace gaitwright::cli
