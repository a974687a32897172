// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

std::string WithMore(const std::string& parts) { return Replaced(FourLegs(), "</robot>", parts + "</robot>"); }

TEST(RobotBounds, NamesAreTextAndNotEmpty) {
  EXPECT_EQ(MessageOf(FourLegs()), "");
  ExpectSays(MessageOf(Replaced(FourLegs(), "'trunk'", "'tr&#0;unk'")), {"not XML", "&#0;"});
  ExpectSays(MessageOf(Replaced(FourLegs(), "'trunk'", "'&#x000;'")), {"not XML", "&#0;"});
  ExpectSays(MessageOf(Replaced(FourLegs(), "'trunk'", "'&#xD800;'")), {"a link", "not valid UTF-8"});
  ExpectSays(MessageOf(Replaced(FourLegs(), "'trunk'", "''")), {"a link", "empty name"});
  ExpectSays(MessageOf(FourLegs() + std::string(1, '\0')), {"is 0x00"});
  ExpectSays(MessageOf(Replaced(FourLegs(), "'trunk'", "'" + std::string(1001, 'x') + "'")),
             {"1001 bytes", "at most 1000"});
}

TEST(RobotBounds, PartsAreCounted) {
  std::string links, joints;
  for (int i = 0; i < 1001; ++i) links += "<link name='l" + std::to_string(i) + "'/>";
  ExpectSays(MessageOf(WithMore(links)), {"elements <link>", "at most 1000"});
  for (int i = 0; i < 300; ++i) {
    const std::string name = "m" + std::to_string(i);
    joints += SmallLink(name) + PitchJoint(name + "_joint", "trunk", name, "0 0 0");
  }
  ExpectSays(MessageOf(WithMore(joints)), {"308 moving joints", "at most 300"});
}

/// A set of feet has 64 bits.
TEST(RobotBounds, LegsAreAtMostThoseOfASetOfFeet) {
  std::string legs;
  for (int i = 0; i < 61; ++i) {
    const std::string leg = "L" + std::to_string(i);
    legs += SmallLink(leg + "_thigh") + SmallLink(leg + "_shank", "<sphere radius='0.02'/>");
    legs += PitchJoint(leg + "_hip", "trunk", leg + "_thigh", "0 0 0");
    legs += PitchJoint(leg + "_knee", leg + "_thigh", leg + "_shank", "0 0 -0.3");
  }
  ExpectSays(MessageOf(WithMore(legs)), {"65 legs", "at most 64"});
}

TEST(RobotBounds, ChainsOfMimicsStaySensible) {
  std::string chain, leader = "A_hip";
  for (int i = 0; i < 3; ++i) {
    const std::string name = "m" + std::to_string(i);
    chain += SmallLink(name) +
             PitchJoint(name + "_joint", "trunk", name, "0 0 0", "<mimic joint='" + leader + "' multiplier='1000'/>");
    leader = name + "_joint";
  }
  ExpectSays(MessageOf(WithMore(chain)), {"'m2_joint'", "multiplier 1000000000", "1000000"});
}

TEST(RobotBounds, NumbersOfTheYamlStaySensible) {
  ExpectSays(MessageOf(FourLegs(), "limits: {A_hip: {lower_rad: -1e308}}"), {"line 1", "-1e+308", "1000000000"});
  ExpectSays(MessageOf(FourLegs(), "gains: {A_hip: {stiffness_nm_rad: 1e300}}"), {"1e+300", "at most 1000000000"});
  ExpectSays(MessageOf(FourLegs(), "feet: [{link: A_foot, radius_m: 1e9}]"), {"'radius_m'", "at most 1000"});
  ExpectSays(MessageOf(FourLegs(), "feet: [{link: A_foot, type: sole, sole_m: [[1e200, 0], [0, 1], [-1, 0]]}]"),
             {"sole_m", "-1000 to 1000"});
  ExpectSays(MessageOf(FourLegs(), "nominal_speed_m_s: 1e5"), {"'nominal_speed_m_s'", "at most 100"});
  ExpectSays(MessageOf(FourLegs(), "standing_base_height_m: 1e5"), {"'standing_base_height_m'", "at most 1000"});
}

}  // namespace
}  // namespace gaitwright
