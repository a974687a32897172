// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/toe_joints.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/convex_hull.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

/// A biped with soles of 0.16 m by 0.1 m, 0.05 m below the ankle, and toes in front of them.
/// @param above_m  height of the toes above the soles.  @param long_m  length of the toes.
std::string Toed(double above_m, double long_m = 0.05) {
  unusual::UrdfText urdf;
  urdf.Link("body", 10.0, 0.25, urdf.Block(0.15, 0.2, 0.3, -0.15));
  for (const double side : {1.0, -1.0}) {
    const std::string n = side > 0.0 ? "l" : "r";
    for (const char* part : {"1", "2", "3", "4", "5"}) urdf.Link(n + part, 0.5, 0.15);
    urdf.Link(n + "_foot", 0.5, 0.12, urdf.Block(0.16, 0.1, 0.02, 0.04));
    urdf.Link(n + "_toes", 0.1, 0.06, urdf.Block(long_m, 0.1, 0.02, 0.0));
    urdf.Joint("body", n + "1", {0.0, 0.1 * side, -0.05}, {.axis = "0 0 1", .lower = -0.8, .upper = 0.8});
    urdf.Joint(n + "1", n + "2", {0.0, 0.0, 0.0}, {.axis = "1 0 0", .lower = -0.6, .upper = 0.6});
    urdf.Joint(n + "2", n + "3", {0.0, 0.0, 0.0}, {});
    urdf.Joint(n + "3", n + "4", {0.0, 0.0, -0.25}, {.lower = 0.0, .upper = 2.2});
    urdf.Joint(n + "4", n + "5", {0.0, 0.0, -0.25}, {.lower = -1.0, .upper = 1.0});
    urdf.Joint(n + "5", n + "_foot", {0.0, 0.0, 0.0}, {.axis = "1 0 0", .lower = -0.5, .upper = 0.5});
    urdf.Joint(n + "_foot", n + "_toes", {0.08 + 0.5 * long_m, 0.0, -0.04 + above_m},
               {.lower = -0.3, .upper = 0.8, .effort = 10.0});
  }
  return urdf.Done("toed");
}

TEST(ToeJoints, BothLinksAreOneSole) {
  const RobotModel model = LoadRobotFromText(Toed(0.0), "").value();
  ASSERT_EQ(model.feet.size(), 2U);
  for (const Foot& foot : model.feet) EXPECT_NEAR(Area(foot.sole_F), 0.21 * 0.1, 1e-9);
  EXPECT_EQ(model.num_dofs(), 12);
  EXPECT_EQ(std::count_if(model.findings.begin(), model.findings.end(),
                          [](const Finding& f) { return f.code == FailureCode::kToeHeld; }),
            2);
}

TEST(ToeJoints, TheHeelMayBeShorterThanTheToes) {
  const RobotModel model = LoadRobotFromText(Toed(0.0, 0.24), "").value();
  ASSERT_EQ(model.feet.size(), 2U);
  for (const Foot& foot : model.feet) EXPECT_NEAR(Area(foot.sole_F), 0.4 * 0.1, 1e-9);
}

TEST(ToeJoints, RobotYamlMayStillSpeakOfThem) {
  const Result<RobotModel> model = LoadRobotFromText(Toed(0.0), "standing: {l_toes_joint: 0.1}\n");
  EXPECT_TRUE(model.ok()) << model.failure().message;
}

TEST(ToeJoints, NamedFeetAndStrictReadersKeepThem) {
  const RobotModel named = LoadRobotFromText(Toed(0.0), "feet: [{link: l_toes}, {link: r_toes}]").value();
  EXPECT_EQ(named.num_dofs(), 14);
  EXPECT_EQ(LoadRobotFromText(Toed(0.0), "", "robot", {}, true)->num_dofs(), 14);
}

TEST(ToeJoints, OtherFeetHaveNone) {
  EXPECT_TRUE(ToeJoints(LoadRobotFromText(Toed(0.02), "", "robot", {}, true).value()).empty()) << "on another level";
  EXPECT_TRUE(ToeJoints(LoadRobotFromText(unusual::SoledBiped(true, true), "").value()).empty());
  for (const char* name : {"nao", "h1", "a1"}) EXPECT_TRUE(ToeJoints(LoadNamedRobot(name).value()).empty()) << name;
}

TEST(FindFeet, ASoleThatIsAslantAtZeroIsFound) {
  const std::string sole = unusual::UrdfText().Block(0.16, 0.1, 0.02, 0.04);
  for (const char* aslant : {"0 0.3 0", "0 -0.47 0", "0 0.8 0", "0.3 0 0"}) {
    const std::string pitched = Replaced(sole, "<origin ", fmt::format("<origin rpy='{}' ", aslant));
    const std::string urdf = Replaced(Toed(0.0), sole, pitched);
    std::string heel_alone = urdf;
    for (const char* toes : {"l_toes", "r_toes"}) {  // without toes
      const std::size_t link = heel_alone.find(fmt::format("<link name='{}'", toes));
      heel_alone.erase(link, heel_alone.find("</link>", link) + 7 - link);
      const std::size_t joint = heel_alone.find(fmt::format("<joint name='{}_joint'", toes));
      heel_alone.erase(joint, heel_alone.find("</joint>", joint) + 8 - joint);
    }
    const RobotModel model = LoadRobotFromText(heel_alone, "").value();
    ASSERT_EQ(model.feet.size(), 2U);
    for (const Foot& foot : model.feet) {
      EXPECT_EQ(foot.type, FootType::kSole) << aslant;
      EXPECT_NEAR(Area(foot.sole_F), 0.16 * 0.1, 1e-6) << aslant;
    }
  }
}

}  // namespace
}  // namespace gaitwright
