// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/check/compare_robots.h"

#include <gtest/gtest.h>

#include <set>

#include "kinematics/check/check_robot.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

/// The parts that differ between two descriptions.
std::set<std::string> DifferentParts(const std::string& a, const std::string& b) {
  std::set<std::string> parts;
  for (const Finding& finding : CompareRobots(LoadRobotFromText(a, "").value(), LoadRobotFromText(b, "").value())) {
    EXPECT_EQ(finding.code, FailureCode::kDescriptionsDiffer);
    parts.insert(PartText(finding.part));
  }
  return parts;
}

/// The text with its first `from` after `after` replaced.
std::string FirstReplaced(std::string text, const std::string& after, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from, text.find(after));
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

using Parts = std::set<std::string>;

TEST(CompareRobots, OneRobotDoesNotDifferFromItself) { EXPECT_EQ(DifferentParts(FourLegs(), FourLegs()), Parts()); }

TEST(CompareRobots, PlacesAxesMassesCentresAndInertiasAreCompared) {
  const std::string four = FourLegs();
  const Parts knee = {"joint 'A_knee'"};
  EXPECT_EQ(DifferentParts(four, FirstReplaced(four, "name='A_knee'", "xyz='0 0 -0.2'", "xyz='0 0 -0.22'")), knee);
  EXPECT_EQ(DifferentParts(four, FirstReplaced(four, "name='A_knee'", "axis xyz='0 1 0'", "axis xyz='0 -1 0'")), knee);
  EXPECT_EQ(DifferentParts(four, FirstReplaced(four, "name='A_shank'", "izz='0.01'", "izz='0.019'")), knee);
  EXPECT_EQ(
      DifferentParts(four, FirstReplaced(four, "name='A_shank'", "<inertial>", "<inertial><origin xyz='0.02 0 0'/>")),
      knee);
  const std::string heavy = FirstReplaced(four, "name='A_shank'", "mass value='1'/><inertia ixx='0.01'",
                                          "mass value='1.1'/><inertia ixx='0.011'");
  EXPECT_EQ(DifferentParts(four, heavy), knee) << "the whole robot's mass differs by less than 1 %";
}

TEST(CompareRobots, ALimitThatOneRobotLacksIsCalledSo) {
  const std::string four = FourLegs();
  const RobotModel with = LoadRobotFromText(four, "").value();
  const RobotModel without =
      LoadRobotFromText(FirstReplaced(four, "name='A_knee'", "effort='30'", "effort='1e6'"), "").value();
  ASSERT_EQ(CompareRobots(with, without).size(), 1U);
  EXPECT_EQ(CompareRobots(with, without)[0].message, "its effort limit is 30 N m here and unknown in the other robot");
  EXPECT_EQ(CompareRobots(without, with)[0].message,
            "its effort limit is unknown here and is 30 N m in the other robot");
}

TEST(CompareRobots, WhereTheRootLinkHasItsOriginIsNoDifference) {
  const std::string raised =
      Replaced(FourLegs(), "</robot>",
               "<link name='root'/><joint name='raise' type='fixed'><parent link='root'/><child link='trunk'/><origin "
               "xyz='0.1 0 0.3'/></joint></robot>");
  EXPECT_EQ(DifferentParts(FourLegs(), raised), Parts());
}

TEST(CompareRobots, JointsOfOneAloneAreNamed) {
  const std::string fixed = FirstReplaced(FourLegs(), "name='D_knee'", "type='revolute'", "type='fixed'");
  EXPECT_TRUE(DifferentParts(FourLegs(), fixed).contains("joint 'D_knee'"));
  EXPECT_TRUE(DifferentParts(fixed, FourLegs()).contains("joint 'D_knee'"));
}

/// The joint axes of an ankle cross at one point, so its size is unknown without its shapes.
TEST(CheckRobot, APartThatOnlyCrossingJointsTellOfIsNotCalledTooHeavy) {
  std::string urdf = FourLegs();
  for (const std::string leg : {"A", "B", "C", "D"}) {
    urdf = Replaced(urdf, "<parent link='" + leg + "_thigh'/><child link='" + leg + "_shank'/>",
                    "<parent link='" + leg + "_cross'/><child link='" + leg + "_shank'/>");
    urdf = Replaced(urdf, "</robot>",
                    "<link name='" + leg +
                        "_cross'><inertial><origin xyz='0.002 0 0'/><mass value='0.1'/><inertia ixx='5e-5' iyy='5e-5' "
                        "izz='5e-5' ixy='0' ixz='0' iyz='0'/></inertial></link>" +
                        PitchJoint(leg + "_swing", leg + "_thigh", leg + "_cross", "0 0 0") + "</robot>");
  }
  urdf = Replaced(urdf, "xyz='0 0 -0.2'/><axis", "xyz='0 0 0'/><axis");
  for (const Finding& finding : CheckRobot(LoadRobotFromText(urdf, "").value())) {
    const bool of_cross = PartText(finding.part).find("_cross") != std::string::npos;
    EXPECT_FALSE(of_cross && finding.code == FailureCode::kLargeInertia) << finding.message;
  }
}

}  // namespace
}  // namespace gaitwright
