// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/check/check_parts_internal.h"
#include "kinematics/model/load_robot.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

RobotModel PlainWithEfforts(double factor) {
  RobotModel model = *LoadRobotFromText(unusual::Plain(), "");
  for (Joint& joint : model.joints) joint.effort_limit *= factor;
  return model;
}

std::vector<Finding> HoldingFindings(const RobotModel& model) {
  std::vector<Finding> findings;
  CheckHolding(model, findings);
  return findings;
}

TEST(CheckHolding, StrongMotorsHoldTheRobotAndWeakOnesAreErrors) {
  EXPECT_TRUE(HoldingFindings(PlainWithEfforts(1.0)).empty());
  const std::vector<Finding> weak = HoldingFindings(PlainWithEfforts(0.01));
  ASSERT_FALSE(weak.empty());
  for (const Finding& finding : weak) {
    EXPECT_EQ(finding.code, FailureCode::kWeakMotor);
    EXPECT_TRUE(PartText(finding.part).starts_with("joint '")) << PartText(finding.part);
  }
  EXPECT_TRUE(std::any_of(weak.begin(), weak.end(), [](const Finding& f) { return f.level == FindingLevel::kError; }));
}

TEST(CheckHolding, WeakerMotorsAreNeverFewerFindings) {
  std::size_t before = 0;
  for (const double factor : {0.5, 0.1, 0.05, 0.01}) {
    const std::size_t now = HoldingFindings(PlainWithEfforts(factor)).size();
    EXPECT_GE(now, before) << factor;
    before = now;
  }
  EXPECT_GT(before, 0U);
}

TEST(CheckHolding, EachJointIsNamedOnce) {
  std::vector<std::string> parts;
  for (const Finding& finding : HoldingFindings(PlainWithEfforts(0.01))) parts.push_back(PartText(finding.part));
  std::sort(parts.begin(), parts.end());
  EXPECT_EQ(std::unique(parts.begin(), parts.end()), parts.end());
}

TEST(CheckHolding, UnknownLimitsHoldAnything) {
  RobotModel model = PlainWithEfforts(0.01);
  for (Joint& joint : model.joints) joint.effort_limit_is_placeholder = true;
  EXPECT_TRUE(HoldingFindings(model).empty());
}

TEST(CheckHolding, ALighterRobotNeedsLess) {
  RobotModel heavy = PlainWithEfforts(0.05), light = heavy;
  for (Body& body : light.bodies) {
    body.mass *= 0.01;
    body.I_C *= 0.01;
  }
  light.total_mass_kg *= 0.01;
  EXPECT_FALSE(HoldingFindings(heavy).empty());
  EXPECT_TRUE(HoldingFindings(light).empty());
}

}  // namespace
}  // namespace gaitwright
