// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/describe.h"

#include <nlohmann/json.hpp>

#include "tests/kinematics/made_robots.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

nlohmann::json JsonOf(const RobotModel& model) { return nlohmann::json::parse(RobotJson(model)); }

TEST(RobotJson, HasTheFiguresOfTheModel) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = AnyRobot(name);
    const nlohmann::json json = JsonOf(model);
    EXPECT_EQ(json.at("name"), model.name);
    EXPECT_EQ(json.at("mass_kg"), model.total_mass_kg);
    EXPECT_EQ(json.at("motors"), model.num_dofs());
    EXPECT_EQ(json.at("hash"), model.hash);
    EXPECT_EQ(json.at("standing_base_height_m"), model.standing_base_height_m);
    ASSERT_EQ(json.at("legs").size(), model.legs.size());
    for (int d = 0; d < model.num_dofs(); ++d) {
      const std::string& joint = model.dof_names[static_cast<std::size_t>(d)];
      EXPECT_EQ(json.at("standing").at(joint), model.standing_joints[d]);
      const bool slides = model.LeaderOf(d).is_prismatic();
      const nlohmann::json& limits = json.at("limits").at(joint);
      EXPECT_EQ(limits.size(), 4U);
      EXPECT_EQ(limits.at(slides ? "lower_m" : "lower_rad"), model.dof_lower(d)) << joint;
      EXPECT_TRUE(limits.contains(slides ? "effort_n" : "effort_nm"));
    }
  }
}

TEST(RobotJson, LegsHaveTheirJointsFeetAndMirrors) {
  const RobotModel model = Robot("nao");
  const nlohmann::json json = JsonOf(model);
  for (const Leg& leg : model.legs) {
    const nlohmann::json& of = json.at("legs").at(leg.name);
    EXPECT_EQ(of.at("joints").size(), leg.joints.size());
    EXPECT_EQ(of.at("joints").front(), model.joints[static_cast<std::size_t>(leg.joints.front())].name);
    EXPECT_EQ(of.at("mirror"), model.legs[static_cast<std::size_t>(leg.mirror)].name);
    EXPECT_EQ(of.at("foot").at("type"), "sole");
    const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
    ASSERT_EQ(of.at("foot").at("sole_m").size(), foot.sole_F.size());
    EXPECT_EQ(of.at("foot").at("sole_m")[0][1], foot.sole_F[0].y());
  }
  ASSERT_EQ(json.at("mirror_pairs").size(), 1U) << "each pair once";
}

TEST(RobotJson, WhatIsUnknownIsNull) {
  const std::string urdf = Replaced(FourLegs(), "effort='30' velocity='20'", "effort='0' velocity='0'");
  const Result<RobotModel> model = LoadRobotFromText(urdf, "gains: {A_hip: {stiffness_nm_rad: 80}}");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const nlohmann::json json = JsonOf(*model);
  EXPECT_TRUE(json.at("limits").at("A_hip").at("effort_nm").is_null());
  EXPECT_TRUE(json.at("limits").at("A_hip").at("velocity_rad_s").is_null());
  EXPECT_EQ(json.at("gains").at("A_hip").at("stiffness_nm_rad"), 80.0);
  EXPECT_TRUE(json.at("gains").at("A_hip").at("damping_nm_s_rad").is_null());
  EXPECT_TRUE(json.at("gains").at("B_hip").at("stiffness_nm_rad").is_null());
  EXPECT_TRUE(json.at("motor_limits").at("A_hip").at("no_load_speed").is_null());
}

TEST(RobotJson, TransmissionsHaveRatiosAndMotors) {
  const std::string yaml =
      "transmissions: [{name: t, joints: [A_hip, A_knee], motors: [{name: m1, ratios: [2, 1], effort_nm: 5}, {name: "
      "m2, "
      "ratios: [0, -3], rotor_inertia_kg_m2: 0.01}]}]";
  const Result<RobotModel> model = LoadRobotFromText(FourLegs(), yaml);
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const nlohmann::json t = JsonOf(*model).at("transmissions").at(0);
  EXPECT_EQ(t.at("joints"), nlohmann::json({"A_hip", "A_knee"}));
  EXPECT_EQ(t.at("motors").at(0).at("ratios"), nlohmann::json({2.0, 1.0}));
  EXPECT_EQ(t.at("motors").at(0).at("effort_limit"), 5.0);
  EXPECT_TRUE(t.at("motors").at(0).at("velocity_limit").is_null());
  EXPECT_EQ(t.at("motors").at(1).at("rotor_inertia"), 0.01);
}

TEST(DescribeRobot, NamesEveryLegJointAndNote) {
  for (const char* name : {"a1", "nao"}) {
    RobotModel model = AnyRobot(name);
    model.description = "a robot of the tests";
    const std::string text = DescribeRobot(model);
    std::vector<std::string> parts = model.notes;
    parts.insert(parts.end(), model.dof_names.begin(), model.dof_names.end());
    for (const Leg& leg : model.legs) parts.push_back("  " + leg.name + ": ");
    parts.push_back("a robot of the tests");
    ExpectSays(text, parts);
    bool follows = false;
    for (const Leg& leg : model.legs) {
      for (const int j : leg.joints) follows = follows || model.joints[static_cast<std::size_t>(j)].is_mimic;
    }
    EXPECT_EQ(text.find("(mimic)") != std::string::npos, follows) << name;
  }
}

TEST(DescribeRobot, WithoutNotesOrMotorDataThereIsNoHeadingOfThem) {
  RobotModel model = *LoadRobotFromText(Replaced(FourLegs(), "<dynamics damping='0.1'/>", ""), "");
  model.notes.clear();
  const std::string text = DescribeRobot(model);
  EXPECT_EQ(text.find("\nnotes\n"), std::string::npos);
  EXPECT_EQ(text.find("motors and joints"), std::string::npos);
  model.notes = {"one"};
  model.motors.resize(8);
  model.motors[3].rotor_inertia = 0.25;
  ExpectSays(DescribeRobot(model), {"\nnotes\n  one\n", "motors and joints", "rotor inertia 0.25"});
}

}  // namespace
}  // namespace gaitwright
