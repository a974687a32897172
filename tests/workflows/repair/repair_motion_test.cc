// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "kinematics/model/upper_body.h"
#include "tests/scratch_folder.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/repair_motion_internal.h"
#include "workflows/repair/repair_report_internal.h"

namespace gaitwright {
namespace {

/// A robot that sways by 2 cm with its feet, as no foot can, and floats.
EvenMotion Skating(const RobotModel& model, double float_m) {
  EvenMotion motion = synthetic::Standing(model, 201);
  for (int k = 0; k < motion.size(); ++k) {
    VectorX& q = motion.q[static_cast<std::size_t>(k)];
    q[1] += 0.02 * std::pow(std::sin(M_PI * k / 200.0), 2.0);
    q[2] += float_m;
  }
  return motion;
}

RepairRequest RequestOf(const std::string& text, const std::string& name = "motion.csv") {
  std::ofstream(ScratchFile(name)) << text;
  RepairRequest request;
  request.source.file = ScratchFile(name);
  request.source.options.rate_hz = 100.0;
  return request;
}

TEST(RepairMotion, MakesASoundPlanOfAMotionThatFloatsAndSkates) {
  for (const char* name : {"a1", "h1"}) {
    const RobotModel& model = NamedRobot(name);
    const auto repaired = RepairMotion(model, RequestOf(synthetic::FramesOf(model, Skating(model, 0.02))));
    ASSERT_TRUE(repaired.ok()) << repaired.failure().message;
    ASSERT_TRUE(repaired->findings.before);
    EXPECT_FALSE(repaired->findings.before->pass());
    EXPECT_TRUE(repaired->after.pass()) << AuditText(repaired->after);
    EXPECT_FALSE(repaired->findings.kept);
    EXPECT_LT(repaired->distance.joint_rms_rad, 0.05);
    EXPECT_NEAR(repaired->distance.base_rms_m, 0.02, 0.01) << "mostly the height";

    const RepairResult result{model, repaired->findings, &*repaired};
    EXPECT_TRUE(result.pass());
    const std::string text = RepairText(result);
    EXPECT_NE(text.find("lifted: the base was moved down by 20.0 mm, because the feet are above the ground"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("pinned: foot '" + model.feet[0].name + "' from 0.00 to 2.00 s, moved by up to"),
              std::string::npos)
        << text;
    const auto json = nlohmann::json::parse(RepairJson(result, {{"plan", "plan.json"}}));
    EXPECT_EQ(json["verdict"], "pass");
    EXPECT_TRUE(json["after"]["violations"].empty());
    EXPECT_FALSE(json["before"]["violations"].empty());
    EXPECT_EQ(json["changes"][0]["what"], "lifted");
    EXPECT_NEAR(json["changes"][0]["by"].get<double>(), -0.02, 1e-4);
  }
}

TEST(RepairMotion, TakesArmsOutOfTheTrunk) {
  for (const char* name : {"h1", "nao"}) {
    const RobotModel& model = NamedRobot(name);
    EvenMotion motion = synthetic::Standing(model, 201);
    const int dof = FindUpperBody(model).left_arm->dofs[1];  // of the shoulder, about the forward axis
    for (int k = 0; k < motion.size(); ++k)
      motion.q[static_cast<std::size_t>(k)][7 + dof] -= 0.5 * std::pow(std::sin(M_PI * k / 200.0), 2.0);
    const RepairRequest request = RequestOf(synthetic::FramesOf(model, motion));
    const auto repaired = RepairMotion(model, request);
    ASSERT_TRUE(repaired.ok()) << repaired.failure().message;
    ASSERT_TRUE(repaired->findings.before);
    ASSERT_FALSE(repaired->findings.before->pass());
    const Violation& worst = repaired->findings.before->violations.front();
    EXPECT_EQ(worst.law, Law::kSelfCollision);
    EXPECT_GT(worst.value, 5e-3) << "the arm is deep in the trunk";
    EXPECT_TRUE(repaired->after.pass()) << AuditText(repaired->after);
    EXPECT_LT(repaired->distance.joint_rms_rad, 0.1);

    RepairRequest through = request;
    through.trajectory.self_distance_m = 0.0;
    const auto touching = RepairMotion(model, through);
    ASSERT_TRUE(touching.ok()) << touching.failure().message;
    EXPECT_FALSE(touching->after.pass()) << "without the distance the links touch";
    EXPECT_TRUE(touching->finished.apart.empty());
  }
}

/// An arm that swings into a wall on the left.
TEST(RepairMotion, TakesAnArmOutOfAWall) {
  const RobotModel& model = NamedRobot("h1");
  EvenMotion motion = synthetic::Standing(model, 201);
  const int dof = FindUpperBody(model).left_arm->dofs[1];
  for (int k = 0; k < motion.size(); ++k)
    motion.q[static_cast<std::size_t>(k)][7 + dof] += 0.6 * std::pow(std::sin(M_PI * k / 200.0), 2.0);
  RepairRequest request = RequestOf(synthetic::FramesOf(model, motion));
  request.ground = FlatTerrain();
  Obstacle wall;
  wall.name = "wall";
  wall.X_WO.translation() = Vector3(0.0, 1.0, 1.0);
  wall.size_m = Vector3(2.0, 1.0, 2.0);
  request.ground->obstacles.push_back(wall);
  const auto repaired = RepairMotion(model, request);
  ASSERT_TRUE(repaired.ok()) << repaired.failure().message;
  ASSERT_TRUE(repaired->findings.before);
  ASSERT_FALSE(repaired->findings.before->pass());
  EXPECT_EQ(repaired->findings.before->violations.front().law, Law::kBodyClearance);
  EXPECT_TRUE(repaired->after.pass()) << AuditText(repaired->after);
  ASSERT_FALSE(repaired->finished.apart.empty());
  EXPECT_NE(repaired->finished.apart.front().find("and 'wall'"), std::string::npos);
}

TEST(RepairMotion, KeepsAMotionThatIsSound) {
  const RobotModel& model = NamedRobot("a1");
  const RepairRequest request = RequestOf(synthetic::FramesOf(model, synthetic::Standing(model, 101)));
  auto repaired = RepairMotion(model, request);
  ASSERT_TRUE(repaired.ok()) << repaired.failure().message;
  EXPECT_TRUE(repaired->findings.kept);
  EXPECT_LT(repaired->distance.joint_largest_rad, 1e-5);
  EXPECT_NE(RepairText({model, repaired->findings, &*repaired}).find("was already feasible"), std::string::npos);

  repaired = RepairMotion(model, request, [](const MotionPlan&) { return PlayProof{false}; });
  ASSERT_TRUE(repaired.ok());
  EXPECT_FALSE(repaired->findings.kept) << "it fell in physics";
  EXPECT_LT(repaired->distance.joint_largest_rad, 0.01);
}

TEST(RepairMotion, FindsWhatIsWrongWithoutRepair) {
  const RobotModel& model = NamedRobot("a1");
  const auto found = ExamineMotion(model, RequestOf(synthetic::FramesOf(model, Skating(model, -0.03))));
  ASSERT_TRUE(found.ok()) << found.failure().message;
  EXPECT_NEAR(found->clean.lift_m, 0.03, 1e-3);
  const RepairResult result{model, *found};
  EXPECT_FALSE(result.pass());
  EXPECT_NE(RepairText(result).find("because the feet sink into the ground"), std::string::npos);
}

TEST(RepairMotion, ReadsFramesOfMotionImitation) {
  const RobotModel& model = NamedRobot("a1");
  std::string frames = synthetic::FramesOf(model, Skating(model, 0.0), "[", "],");
  frames.pop_back();
  const std::string text = "{\"LoopMode\": \"Wrap\", \"FrameDuration\": 0.01, \"Frames\": [" + frames + "]}";
  const auto repaired = RepairMotion(model, RequestOf(text, "motion.txt"));
  ASSERT_TRUE(repaired.ok()) << repaired.failure().message;
  EXPECT_EQ(repaired->findings.format, MotionFormat::kFramesJson);
  EXPECT_TRUE(repaired->after.pass()) << AuditText(repaired->after);
}

TEST(RepairMotion, RefusesAnotherNumberOfColumns) {
  const auto repaired = RepairMotion(NamedRobot("h1"), RequestOf("0,0,1,0,0,0,1\n0,0,1,0,0,0,1\n"));
  ASSERT_FALSE(repaired.ok());
  EXPECT_EQ(repaired.failure().code, FailureCode::kColumns);
  EXPECT_NE(repaired.failure().message.find("has 7 columns without names; robot 'h1' needs 26"), std::string::npos)
      << repaired.failure().message;
}

}  // namespace
}  // namespace gaitwright
