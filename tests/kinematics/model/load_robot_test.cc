// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/load_robot.h"

#include <gtest/gtest.h>

#include "kinematics/base/file.h"
#include "kinematics/dynamics/dynamics.h"
#include "tests/built_paths.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

std::string Urdf(const std::string& name) {
  return ReadFile(SourceFolder() + "/robots/" + name + "/robot.urdf").value();
}

/// A minimal two-legged tree with `joint` and `extra`.
std::string TwoLegs(const std::string& joint, const std::string& extra = "") {
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";
  return "<robot name='r'><link name='base'>" + inertial + "</link><link name='a'>" + inertial +
         "</link><link name='b'>" + inertial + "</link>" + joint + extra + "</robot>";
}

const char kGood[] =
    "<joint name='j' type='revolute'><parent link='base'/><child link='a'/><axis xyz='0 1 0'/>"
    "<limit lower='-1' upper='1' effort='10' velocity='10'/></joint>"
    "<joint name='k' type='fixed'><parent link='a'/><child link='b'/></joint>";

TEST(LoadRobot, A1IsAsPublished) {
  const RobotModel a1 = Robot("a1");
  EXPECT_NEAR(a1.total_mass_kg, 13.741, 1e-9);
  EXPECT_EQ(a1.num_dofs(), 12);
  ASSERT_EQ(a1.legs.size(), 4U);
  EXPECT_EQ(a1.feet[0].link, "FL_foot");
  EXPECT_EQ(a1.feet[3].link, "RR_foot");
  for (const Foot& foot : a1.feet) {
    EXPECT_EQ(foot.type, FootType::kSphere);
    EXPECT_DOUBLE_EQ(foot.radius, 0.02);
  }
  EXPECT_EQ(a1.legs[0].mirror, 1);
  EXPECT_NEAR(a1.leg_length_m(), 0.42, 1e-9);
  DynamicsScratch scratch(a1);
  ForwardKinematics(a1, StandingConfiguration(a1), scratch);
  EXPECT_LT((CentreOfMass(a1, scratch) - Vector3(-0.0102, 0.0018, 0.2508)).norm(), 1e-3);
}

TEST(LoadRobot, NaoIsAsPublished) {
  const RobotModel nao = Robot("nao");
  EXPECT_NEAR(nao.total_mass_kg, 5.305354, 1e-9);
  EXPECT_EQ(nao.num_dofs(), 25);
  ASSERT_EQ(nao.legs.size(), 2U);
  EXPECT_EQ(nao.feet[0].link, "l_ankle");
  EXPECT_EQ(nao.feet[0].type, FootType::kSole);
  const Vector2 size = nao.feet[0].sole_F[2] - nao.feet[0].sole_F[0];
  EXPECT_NEAR(size.x(), 0.157, 1e-9);
  EXPECT_NEAR(size.y(), 0.088, 1e-9);
  EXPECT_EQ(nao.DofIndex("LHipYawPitch"), nao.joints[static_cast<std::size_t>(nao.legs[1].joints[0])].dof);
}

TEST(LoadRobot, NamesPlayNoPart) {
  const RobotModel a1 = Robot("a1");
  const Result<RobotModel> renamed = LoadRobotFromText(Replaced(Replaced(Urdf("a1"), "foot", "zeh"), "calf", "x7"), "");
  ASSERT_TRUE(renamed.ok()) << renamed.failure().message;
  EXPECT_EQ(renamed->legs.size(), 4U);
  EXPECT_LT((renamed->standing_joints - a1.standing_joints).norm(), 1e-9);
}

TEST(LoadRobot, FootRadiiAreRead) {
  for (const char* radius : {"0.005", "0.04"}) {
    const Result<RobotModel> model = LoadRobotFromText(
        Replaced(Urdf("a1"), "<sphere radius=\"0.02\"/>", std::string("<sphere radius=\"") + radius + "\"/>"), "");
    ASSERT_TRUE(model.ok());
    EXPECT_DOUBLE_EQ(model->feet[0].radius, std::stod(radius));
  }
}

/// Two level capsules, one behind the other, touch the ground along a line, which is not a sole.
TEST(LoadRobot, ALineHasNoArea) {
  std::string urdf = Urdf("nao");
  for (const std::string y : {"0.006", "-0.006"}) {
    const auto at = [&y](const std::string& x, const std::string& rpy) {
      return "<origin xyz=\"" + x + " " + y + " -0.03511\" rpy=\"" + rpy + "\"/>\n      <geometry>";
    };
    const std::string box = at("0.0315", "0 0 0") + "<box size=\"0.157 0.088 0.02\"/></geometry>\n    </collision>";
    ASSERT_NE(urdf.find(box), std::string::npos);
    const std::string limb =
        at("0.03", "0 1.57079632679 0") + "<capsule radius=\"0.01\" length=\"0.05\"/></geometry></collision>";
    urdf = Replaced(urdf, box, limb + "<collision>" + Replaced(limb, "0.03 ", "0.09 "));
  }
  const Result<RobotModel> model = LoadRobotFromText(urdf, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  ASSERT_EQ(model->feet.size(), 2U);
  for (const Foot& foot : model->feet) EXPECT_FALSE(foot.has_sole());
}

TEST(LoadRobot, RefusesWhatIsWrongAndNamesIt) {
  ExpectSays(MessageOf("<robot"), {"not XML"});
  ExpectSays(MessageOf("<sdf/>"), {"<sdf>"});
  ExpectSays(MessageOf(TwoLegs(kGood, "<joint name='m' type='fixed'><parent link='base'/><child link='b'/></joint>")),
             {"closed loop"});
  ExpectSays(MessageOf(TwoLegs("")), {"one root"});
  ExpectSays(MessageOf(Replaced(TwoLegs(kGood), "mass value='1'", "mass value='-1'")), {"-1 kg"});
  ExpectSays(MessageOf(Replaced(TwoLegs(kGood), "0 1 0", "0 0 0")), {"joint 'j': its axis is zero"});
  const auto strictly = [](const std::string& urdf) { return MessageOf(urdf, "", true); };
  ExpectSays(strictly(Replaced(TwoLegs(kGood), "izz='1'", "izz='3'")), {"triangle inequality"});
  ExpectSays(strictly(Replaced(TwoLegs(kGood), "<limit lower='-1' upper='1' effort='10' velocity='10'/>", "")),
             {"<limit>"});
  ExpectSays(MessageOf(Replaced(TwoLegs(kGood), "<axis xyz='0 1 0'/>", "<axis xyz='0 1 0'/><mimic joint='kk'/>")),
             {"nearest is 'k'"});
  ExpectSays(strictly(Replaced(TwoLegs(kGood), "'revolute'", "'floating'")), {"'prismatic'"});
  ExpectSays(MessageOf(Replaced(TwoLegs(kGood), "link='base'", "link='bas'")), {"nearest is 'base'"});
  ExpectSays(MessageOf(Replaced(TwoLegs(kGood), "upper='1'", "upper='nan'")), {"not a finite number"});
  ExpectSays(MessageOf(TwoLegs(kGood)), {"legs found"});
}

TEST(LoadRobot, RefusesAJointThatMovesNothing) {
  const std::string nothing = Replaced(Urdf("a1"), "<mass value=\"0.06\"/>", "<mass value=\"0\"/>");
  EXPECT_EQ(MessageOf(nothing), "");  // the calf still has mass
  const std::string light =
      "<link name='w'/><joint name='spin' type='continuous'><parent link='a'/><child link='w'/><axis xyz='1 0 "
      "0'/></joint>";
  ExpectSays(MessageOf(TwoLegs(kGood, light), "", true), {"joint 'spin' moves nothing"});
}

TEST(LoadRobot, ChecksTheYaml) {
  ExpectSays(MessageOf(Urdf("a1"), "standing_base_hight_m: 0.3"), {"nearest is 'standing_base_height_m'"});
  ExpectSays(MessageOf(Urdf("a1"), "standing: {FL_calf_joint: .nan}"), {"finite"});
  ExpectSays(MessageOf(Urdf("a1"), "standing: {FL_calf_join: -1.5}"), {"nearest is 'FL_calf_joint'"});
  ExpectSays(MessageOf(Urdf("a1"), "standing: {FL_calf_joint: 1.5}"), {"outside its limits"});
  ExpectSays(MessageOf(Urdf("a1"), "a: [1"), {"line"});
}

TEST(LoadRobot, UnknownNameListsWhatThereIs) {
  const Result<RobotModel> model = LoadNamedRobot("b2");
  ASSERT_FALSE(model.ok());
  ExpectSays(model.failure().message,
             {"'a1', 'g1', 'go1', 'h1', 'h1_2', 'humanoid', 'laikago', 'mini_cheetah', 'nao'"});
  EXPECT_FALSE(LoadRobot("/no/such.urdf").ok());
}

}  // namespace
}  // namespace gaitwright
