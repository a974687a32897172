// SPDX-License-Identifier: BSD-3-Clause
// The linter of robot descriptions, and `robots show`.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "kinematics/dynamics/dynamics.h"
#include "tests/cli/stranger.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright::cli {
namespace {

class RobotsCheck : public Stranger {
 protected:
  /// The findings of one kind.
  static std::vector<Json> Of(const Json& checked, const std::string& code) {
    std::vector<Json> found;
    for (const Json& finding : checked.at("findings")) {
      if (finding.at("code") == code) found.push_back(finding);
    }
    return found;
  }
};

TEST_F(RobotsCheck, RobotsOfOursHaveNoWarnings) {
  for (const char* robot : {"a1", "g1", "go1", "h1_2", "nao", "mini_cheetah", "laikago"}) {
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
  std::string broken = Replaced(FourLegs(), "izz='0.01' ixy", "izz='0.03' ixy");
  const std::string limit =
      " lower='-2' upper='1'";  // only of one joint, since the check takes long without the limits of all joints
  broken.replace(broken.find(limit), limit.size(), "");
  Write("robot.urdf", broken);
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

TEST_F(RobotsCheck, FindingsOfOneTextShareALine) {
  Write("loose.urdf", Replaced(FourLegs(), " effort='30'", ""));
  const Ran json = Run({"robots", "check", "loose.urdf", "--json"});
  EXPECT_EQ(Of(json.json(), "unknown_effort").size(), 8U) << json.out;
  const std::string words = Run({"robots", "check", "loose.urdf"}).out;
  const std::size_t at = words.find("[unknown_effort]");
  EXPECT_NE(at, std::string::npos) << words;
  EXPECT_EQ(words.find("[unknown_effort]", at + 1), std::string::npos) << words;
  EXPECT_NE(words.find(" and 4 more: "), std::string::npos) << words;
}

TEST_F(RobotsCheck, FeetThatAreLongerBehindFaceBack) {
  const std::string nao = LoadNamedRobot("nao")->urdf_text, yaml = LoadNamedRobot("nao")->yaml_text;
  Write("robot.yaml", yaml);
  Write("ahead.urdf", nao);
  EXPECT_TRUE(Of(Run({"robots", "check", "ahead.urdf", "--json"}).json(), "faces_back").empty());
  // The box of its sole is 31 mm in front of the ankle; here it is moved the same distance behind it.
  const std::string behind = Replaced(nao, "xyz=\"0.0315 ", "xyz=\"-0.0315 ");
  ASSERT_NE(behind, nao);
  Write("behind.urdf", behind);
  EXPECT_EQ(Of(Run({"robots", "check", "behind.urdf", "--json"}).json(), "faces_back").size(), 1U);
}

TEST_F(RobotsCheck, ASmallLinkWithoutShapesIsNoFault) {
  const auto with = [](const std::string& inertia) {
    return Replaced(FourLegs(),
                    "<link name='A_thigh'><inertial><mass value='1'/><inertia ixx='0.01' iyy='0.01' izz='0.01'",
                    "<link name='A_thigh'><inertial><mass value='1'/><inertia " + inertia);
  };
  Write("dense.urdf",
        Replaced(with("ixx='0.02' iyy='0.02' izz='0.02'"), "xyz='0 0 -0.2'/><axis", "xyz='0 0 -0.02'/><axis"));
  EXPECT_TRUE(Of(Run({"robots", "check", "dense.urdf", "--json"}).json(), "large_inertia").empty());
  Write("wide.urdf", with("ixx='0.5' iyy='0.5' izz='0.5'"));
  EXPECT_EQ(Of(Run({"robots", "check", "wide.urdf", "--json"}).json(), "large_inertia").size(), 1U);
}

TEST_F(RobotsCheck, WeakMotorsAreNamedWithTheirStance) {
  EXPECT_TRUE(Of(Run({"robots", "check", "a1", "--json"}).json(), "weak_motor").empty());
  const Result<RobotModel> four = LoadRobotFromText(FourLegs(), "");
  ASSERT_TRUE(four.ok());
  // A knee under half the weight of a robot that stands on a diagonal: the force on the foot times its horizontal
  // distance from the knee, minus the moments of the weights of shank and foot.
  DynamicsScratch scratch(*four);
  ForwardKinematics(*four, StandingConfiguration(*four), scratch);
  const Foot& foot = four->feet[0];
  const auto shank = static_cast<std::size_t>(foot.body);
  const Vector3 p_WF = FramePose(scratch, foot.body, foot.X_BF).translation(), p_WK = scratch.p_WB[shank];
  const Body& body = four->bodies[shank];
  const Vector3 p_WS = scratch.p_WB[shank] + scratch.R_WB[shank] * body.p_BC;
  const double knee_nm =
      std::abs(0.5 * four->weight_n() * (p_WF - p_WK).x() - body.mass * kGravity * (p_WS - p_WK).x());
  for (const auto& [limit_nm, level] :
       std::map<double, std::string>{{0.95 * knee_nm, "error"}, {1.1 * knee_nm, "warning"}, {1.4 * knee_nm, ""}}) {
    Write("weak.urdf", FourLegs());
    Write("robot.yaml", fmt::format("limits: {{A_knee: {{effort_nm: {}}}}}\n", limit_nm));
    const Ran ran = Run({"robots", "check", "weak.urdf", "--json"});
    const std::vector<Json> found = Of(ran.json(), "weak_motor");
    ASSERT_EQ(found.size(), level.empty() ? 0U : 1U) << ran.out;
    EXPECT_EQ(ran.status, level == "error" ? 1 : 0);
    if (level.empty()) continue;
    EXPECT_EQ(found.front().at("level"), level);
    EXPECT_EQ(found.front().at("part"), "joint 'A_knee'");
    const std::string message = found.front().at("message");
    EXPECT_NE(message.find("'A_foot' and 'D_foot' alone"), std::string::npos) << message;
    EXPECT_NE(message.find("it needs at least"), std::string::npos) << message;
  }
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

TEST_F(RobotsCheck, RobotsShowListsThePairsThatAreNotHeldApartAndWhy) {
  for (const char* robot : {"a1", "nao"}) {
    const Json shown = Run({"robots", "show", robot, "--json"}).json().at("self_collision");
    EXPECT_GT(shown.at("pairs"), 50) << robot;
    EXPECT_GT(shown.at("left_out").size(), 5U);
    const std::string words = Run({"robots", "show", robot}).out;
    for (const Json& pair : shown.at("left_out")) {
      EXPECT_EQ(pair.at("links").size(), 2U);
      const std::string reason = pair.at("reason");
      EXPECT_TRUE(reason.starts_with("adjacent: ") || reason.find("touching") != std::string::npos) << reason;
      const std::string first = pair.at("links")[0], second = pair.at("links")[1];
      EXPECT_NE(words.find(first + " and " + second + ": " + reason), std::string::npos) << first << ' ' << second;
    }
  }
}

TEST_F(RobotsCheck, ShowTellsTheRobotsNumbers) {
  const Json shown = Run({"robots", "show", "nao", "--json"}).json();
  EXPECT_EQ(shown.at("name"), "nao");
  EXPECT_EQ(shown.at("legs").size(), 2U);
  EXPECT_EQ(shown.at("mirror_pairs").size(), 1U);
  EXPECT_EQ(shown.at("standing").size(), shown.at("motors").get<std::size_t>());
  EXPECT_EQ(shown.at("limits").size(), shown.at("motors").get<std::size_t>());
  ExpectRefused(Run({"robots", "show", "noa"}), 1, {"'noa'", "'nao'"});
}

}  // namespace
}  // namespace gaitwright::cli
