// SPDX-License-Identifier: BSD-3-Clause
#include "examples/own_robot.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/model/load_robot.h"
#include "tests/scratch_folder.h"
#include "tests/unusual_robots.h"

namespace gaitwright::examples {
namespace {

/// The robot of a URDF that is written to a file of its own.
Result<RobotModel> Read(const std::string& urdf_text) {
  const std::string file = ScratchFile("own.urdf");
  EXPECT_TRUE(WriteFileAtomically(file, urdf_text));
  return ReadOwnRobot(file);
}

void ExpectText(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(OwnRobotExample, DerivesLegsFeetAndHeightAndPlansAWalk) {
  const RobotModel model = Read(unusual::Plain()).value();
  ASSERT_EQ(model.legs.size(), 4U);
  for (const Foot& foot : model.feet) {
    EXPECT_EQ(foot.type, FootType::kSphere);
    EXPECT_NEAR(foot.radius, 0.02, 1e-12);
  }
  ExpectText(WhatWasDerived(model), {"on 4 legs", "leg   a_foot: 3 joints", "on a sphere", "note  foot 'a_foot'"});
  const Result<PlannedWalk> walk = PlanOwnWalk(model);
  ASSERT_TRUE(walk.ok()) << ReasonRefused(walk.failure());
  EXPECT_TRUE(walk->audit.pass()) << AuditText(walk->audit);
  EXPECT_NEAR(walk->motion.plan.goal.x_m, 2.0 * model.leg_length_m(), 1e-9);
}

TEST(OwnRobotExample, TakesNothingButTheUrdf) {
  const std::string yaml = ScratchFile("robot.yaml");
  ASSERT_TRUE(WriteFileAtomically(yaml, "nominal_speed_m_s: 0.123\n"));
  const RobotModel model = Read(unusual::Plain()).value();
  EXPECT_NE(model.nominal_speed_m_s, 0.123);
  EXPECT_EQ(LoadRobot(ScratchFile("own.urdf")).value().nominal_speed_m_s, 0.123) << "that file does say something";
  std::filesystem::remove(yaml);
}

TEST(OwnRobotExample, PlansAWalkOnTwoPoints) {
  const Result<PlannedWalk> walk = PlanOwnWalk(Read(unusual::PointBiped()).value());
  ASSERT_TRUE(walk.ok()) << ReasonRefused(walk.failure());
  EXPECT_TRUE(walk->audit.pass()) << AuditText(walk->audit);
}

TEST(OwnRobotExample, SaysWhyARobotCannotWalk) {
  const Result<PlannedWalk> stiff = PlanOwnWalk(Read(unusual::Pantograph()).value());
  ASSERT_FALSE(stiff.ok());
  ExpectText(ReasonRefused(stiff.failure()), {"leg 'a_foot' cannot walk", "ahead", "\nhint  "});
}

TEST(OwnRobotExample, SaysWhatIsWrongInAFile) {
  const Result<RobotModel> missing = ReadOwnRobot("/none/robot.urdf");
  ASSERT_FALSE(missing.ok());
  ExpectText(ReasonRefused(missing.failure()), {"/none/robot.urdf"});
  std::string urdf = unusual::Plain();
  urdf.replace(urdf.find("mass value='"), 12, "mass value='-");
  const Result<RobotModel> broken = Read(urdf);
  ASSERT_FALSE(broken.ok());
  ExpectText(ReasonRefused(broken.failure()), {"'body'", "mass"});
}

}  // namespace
}  // namespace gaitwright::examples
