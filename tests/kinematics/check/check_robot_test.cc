// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/check/check_robot.h"

#include <algorithm>

#include "tests/kinematics/made_robots.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

RobotModel PlainRobot() { return *LoadRobotFromText(unusual::Plain(), ""); }

/// The findings of one kind.
std::vector<Finding> FindingsOfKind(const RobotModel& model, FailureCode code) {
  std::vector<Finding> findings = CheckRobot(model);
  std::erase_if(findings, [&](const Finding& finding) { return finding.code != code; });
  return findings;
}

TEST(CheckRobot, TheModelsOwnFindingsComeFirst) {
  RobotModel model = PlainRobot();
  const Finding own{FindingLevel::kInfo, FailureCode::kXacro, RobotPart(), 12, "of the file"};
  model.findings = {own};
  ASSERT_FALSE(CheckRobot(model).empty());
  EXPECT_EQ(CheckRobot(model).front(), own);
}

TEST(CheckRobot, ASoundRobotHasNoErrors) {
  for (const RobotModel& model : {PlainRobot(), Robot("a1"), Robot("nao")}) {
    for (const Finding& finding : CheckRobot(model)) EXPECT_NE(finding.level, FindingLevel::kError) << finding.message;
  }
}

TEST(CheckRobot, EachDifferenceBetweenTheSidesIsNamedByItsJoint) {
  RobotModel model = PlainRobot();
  ASSERT_TRUE(FindingsOfKind(model, FailureCode::kSidesDiffer).empty());
  const Leg& left = model.legs[0];
  Joint& knee = model.joints[static_cast<std::size_t>(left.knee_joint)];
  knee.effort_limit *= 1.005;
  EXPECT_TRUE(FindingsOfKind(model, FailureCode::kSidesDiffer).empty()) << "half a percent is rounding";
  knee.effort_limit *= 1.1;
  knee.velocity_limit *= 0.5;
  const std::vector<Finding> findings = FindingsOfKind(model, FailureCode::kSidesDiffer);
  ASSERT_EQ(findings.size(), 2U);
  for (const Finding& finding : findings) EXPECT_EQ(PartText(finding.part), "joint '" + knee.name + "'");
  model.bodies[static_cast<std::size_t>(left.knee_joint) + 1].mass *= 2.0;
  EXPECT_EQ(FindingsOfKind(model, FailureCode::kSidesDiffer).size(), 3U);
}

TEST(CheckRobot, LegsOfDifferentNumbersOfJointsAreOneFinding) {
  RobotModel model = PlainRobot();
  model.legs[0].joints.pop_back();
  EXPECT_EQ(FindingsOfKind(model, FailureCode::kSidesDiffer).size(), 1U);
}

TEST(CheckRobot, FeetThatAreLongerBehindTheAnkleFaceBack) {
  const auto with_box = [](const std::string& x) {
    return Made(SixJoints(), "<collision><origin xyz='" + x +
                                 " 0 -0.04'/><geometry><box size='0.2 0.1 0.02'/></geometry></collision>");
  };
  EXPECT_TRUE(FindingsOfKind(with_box("0.02"), FailureCode::kFacesBack).empty());
  EXPECT_TRUE(FindingsOfKind(with_box("0"), FailureCode::kFacesBack).empty());
  EXPECT_EQ(FindingsOfKind(with_box("-0.05"), FailureCode::kFacesBack).size(), 1U);
}

TEST(CheckRobot, MassMustFitTheLengthOfTheLegs) {
  for (const double factor : {0.1, 1.0, 10.0}) {
    RobotModel model = PlainRobot();
    model.total_mass_kg *= factor;
    EXPECT_TRUE(FindingsOfKind(model, FailureCode::kOddSize).empty()) << factor;
  }
  for (const double factor : {1e-3, 1e3}) {
    RobotModel model = PlainRobot();
    model.total_mass_kg *= factor;
    EXPECT_EQ(FindingsOfKind(model, FailureCode::kOddSize).size(), 1U) << factor;
  }
}

TEST(CheckRobot, PartsBelowTheGroundAreNamedOnceWithTheirDepth) {
  RobotModel model = PlainRobot();
  ASSERT_TRUE(FindingsOfKind(model, FailureCode::kInTheGround).empty());
  Shape low;
  low.type = ShapeType::kSphere;
  low.size = Vector3(0.01, 0.0, 0.0);
  low.link = "keel";
  low.X_BS.translation().z() = -model.standing_base_height_m;  // its middle is on the ground
  model.collision_shapes.push_back(low);
  model.collision_shapes.push_back(low);
  const std::vector<Finding> findings = FindingsOfKind(model, FailureCode::kInTheGround);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(PartText(findings[0].part), "link 'keel'");
  ExpectSays(findings[0].message, {"10.0 mm"});
}

}  // namespace
}  // namespace gaitwright
