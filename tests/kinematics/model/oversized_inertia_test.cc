// SPDX-License-Identifier: BSD-3-Clause
// Inertias that are far too large for their links, such as those of files in other units.
#include "kinematics/model/oversized_inertia.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/model/repaired_urdf.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

constexpr char kSoundInertia[] = "ixx='0.01' iyy='0.01' izz='0.01'";

/// The robot with an inertia of 40 kg m^2 in its trunk, which is a box of 1 kg and 0.46 m.
std::string WithHeavyTrunk() {
  std::string urdf = FourLegs();
  urdf.replace(urdf.find(kSoundInertia), sizeof(kSoundInertia) - 1, "ixx='40' iyy='40' izz='40'");
  return urdf;
}

std::size_t CountOfCode(const RobotModel& model, FailureCode code) {
  return static_cast<std::size_t>(std::count_if(model.findings.begin(), model.findings.end(),
                                                [&](const Finding& finding) { return finding.code == code; }));
}

TEST(OversizedInertia, TheShapesTellInsteadFromFourTimesTheExtentOn) {
  Shape box;
  box.size = Vector3(0.3, 0.2, 0.1);
  const double extent = LinkExtent({&box}, {Vector3::Zero()});
  EXPECT_NEAR(extent, box.size.norm(), 1e-12);
  const auto of_gyration = [&](double radius) {
    return Matrix3(2.0 / 3.0 * 2.0 * radius * radius * Matrix3::Identity());  // 2 kg
  };
  EXPECT_FALSE(MendOversizedInertia(of_gyration(3.9 * extent), 2.0, extent, {&box}).has_value());
  const auto mended = MendOversizedInertia(of_gyration(4.1 * extent), 2.0, extent, {&box});
  ASSERT_TRUE(mended.has_value());
  EXPECT_NEAR(mended->I(0, 0), 2.0 * (0.04 + 0.01) / 12.0, 1e-12);
  EXPECT_NEAR(mended->I(2, 2), 2.0 * (0.09 + 0.04) / 12.0, 1e-12);
  EXPECT_FALSE(MendOversizedInertia(of_gyration(100.0), 2.0, extent, {}).has_value()) << "nothing tells its shape";
}

TEST(OversizedInertia, APointTellsNoSize) {
  Shape point;
  point.type = ShapeType::kSphere;
  point.size = Vector3(1e-4, 0.0, 0.0);
  const Matrix3 I = 1e-5 * Matrix3::Identity();
  EXPECT_FALSE(MendOversizedInertia(I, 0.05, LinkExtent({&point}, {Vector3::Zero()}), {&point}).has_value());
}

TEST(OversizedInertia, PointsFarFromTheShapesAreOfTheLinkToo) {
  Shape ball;
  ball.type = ShapeType::kSphere;
  ball.size = Vector3(0.01, 0.0, 0.0);
  EXPECT_NEAR(LinkExtent({&ball}, {Vector3::Zero(), Vector3(0.5, 0.0, 0.0)}), 0.51, 1e-12);
}

TEST(OversizedInertia, ARobotIsLoadedWithOneWarningAndRefusedStrictly) {
  const RobotModel model = LoadRobotFromText(WithHeavyTrunk(), "").value();
  ASSERT_EQ(CountOfCode(model, FailureCode::kImpossibleInertia), 1U);
  EXPECT_NEAR(model.bodies[0].I_C(2, 2), (0.4 * 0.4 + 0.2 * 0.2) / 12.0, 1e-9);
  EXPECT_NE(MessageOf(WithHeavyTrunk(), "", true), "");
  EXPECT_EQ(MessageOf(FourLegs(), "", true), "");
}

TEST(OversizedInertia, LinksOfNoWeightAreLeftAsTheyAre) {
  const std::string sensor =
      "<link name='imu'><inertial><mass value='0.001'/><inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' "
      "iyz='0'/></inertial><collision><geometry><box size='0.01 0.01 0.01'/></geometry></collision></link>"
      "<joint name='imu_joint' type='fixed'><parent link='trunk'/><child link='imu'/></joint></robot>";
  const RobotModel model = LoadRobotFromText(Replaced(FourLegs(), "</robot>", sensor), "").value();
  EXPECT_EQ(CountOfCode(model, FailureCode::kImpossibleInertia), 0U);
}

TEST(OversizedInertia, WhatAMeshThatIsMissingMightShowIsNotGuessed) {
  const std::string urdf =
      Replaced(WithHeavyTrunk(), "<link name='A_thigh'>",
               "<link name='ghost'><inertial><mass value='1'/><inertia ixx='9' iyy='9' izz='9' ixy='0' ixz='0' "
               "iyz='0'/></inertial><collision><geometry><mesh filename='gone.stl'/></geometry></collision>"
               "<collision><geometry><box size='0.01 0.01 0.01'/></geometry></collision></link><joint name='haunt' "
               "type='fixed'><parent link='trunk'/><child link='ghost'/></joint><link name='A_thigh'>");
  EXPECT_EQ(CountOfCode(LoadRobotFromText(urdf, "").value(), FailureCode::kImpossibleInertia), 1U)
      << "the trunk's alone";
}

TEST(OversizedInertia, TheRepairedFileHasWhatIsUsed) {
  for (const std::string& yaml : {std::string(), std::string("scale: 0.5\n")}) {
    const RobotModel model = LoadRobotFromText(WithHeavyTrunk(), yaml).value();
    const RobotModel again = LoadRobotFromText(RepairedUrdf(model), yaml).value();
    EXPECT_EQ(CountOfCode(again, FailureCode::kImpossibleInertia), 0U);
    EXPECT_LT((again.bodies[0].I_C - model.bodies[0].I_C).norm(), 1e-9);
  }
}

TEST(OversizedInertia, TheRepairedFileHasThoseOfPlaceholdersToo) {
  const std::string urdf = Replaced(FourLegs(), "<link name='trunk'><inertial><mass value='1'/>",
                                    "<link name='trunk'><inertial><mass value='7'/>");
  const RobotModel model = LoadRobotFromText(urdf, "").value();
  ASSERT_GT(CountOfCode(model, FailureCode::kPlaceholderInertia), 0U);
  const RobotModel again = LoadRobotFromText(RepairedUrdf(model), "").value();
  EXPECT_EQ(CountOfCode(again, FailureCode::kPlaceholderInertia), 0U);
  EXPECT_LT((again.bodies[0].I_C - model.bodies[0].I_C).norm(), 1e-9);
}

}  // namespace
}  // namespace gaitwright
