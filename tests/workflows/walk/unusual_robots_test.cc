// SPDX-License-Identifier: BSD-3-Clause
// Robots of other kinds and sizes, from their URDF alone: each walks at its default speed, or the refusal gives the
// reason.
#include "tests/unusual_robots.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/model/load_robot.h"
#include "tests/scratch_folder.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

struct Case {
  std::string name, urdf, gait;
};

void PrintTo(const Case& robot, std::ostream* out) { *out << robot.name; }

class UnusualRobot : public testing::TestWithParam<Case> {};

TEST_P(UnusualRobot, WalksAtItsOwnSpeed) {
  const Result<RobotModel> model = LoadRobotFromText(GetParam().urdf, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  WalkRequest request;
  request.gait = GetParam().gait;
  request.command.distance_m = 0.7 * model->leg_length_m();
  const Result<PlannedWalk> planned = PlanWalk(*model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  const Result<PlayedWalk> played = PlayWalk(*model, planned->motion.plan, PlayRequest{});
  ASSERT_TRUE(played.ok()) << played.failure().message;
  EXPECT_TRUE(played->report.pass) << played->report.reason;
}

/// A quadruped with joint damping and friction of small geared motors, 3 % of its effort limits.
std::string Rubbing() {
  std::string urdf = unusual::Plain();
  for (std::size_t at = 0; (at = urdf.find("<limit", at)) != std::string::npos; at += 50) {
    urdf.insert(at, "<dynamics damping='0.3' friction='1.2'/>");
  }
  return urdf;
}

std::vector<Case> Cases() {
  return {{"telescopic", unusual::Telescopic(), ""},
          {"insect", unusual::Insect(), ""},
          {"wheeled", unusual::Wheeled(), ""},
          {"arm_and_tail", unusual::ArmAndTail(), ""},
          {"biped", unusual::SoledBiped(true, false), ""},
          {"humanoid", unusual::SoledBiped(true, true), ""},
          {"biped_on_points", unusual::PointBiped(), ""},
          {"rubbing", Rubbing(), ""},
          {"tiny", unusual::Plain(0.25), ""},
          {"huge", unusual::Plain(3.0), ""}};
}

INSTANTIATE_TEST_SUITE_P(All, UnusualRobot, testing::ValuesIn(Cases()),
                         [](const auto& robot) { return robot.param.name; });

TEST(UnusualRobots, ThreeLegsWalkOneAtATime) {
  const std::string file = ScratchFile("three_legs.yaml");
  ASSERT_TRUE(WriteFileAtomically(file,
                                  "three:\n  feet: 3\n  cycle_per_leg_time: 4.0\n  duty_factor: 0.8\n"
                                  "  phase: [0.0, 0.3333333, 0.6666667]\n"));
  const RobotModel model = *LoadRobotFromText(unusual::Tripod(), "");
  WalkRequest request;
  request.gait = file;
  request.command.distance_m = 0.3;
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  std::filesystem::remove(file);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  const Result<PlayedWalk> played = PlayWalk(model, planned->motion.plan, PlayRequest{});
  ASSERT_TRUE(played.ok());
  EXPECT_TRUE(played->report.pass) << played->report.reason;
}

TEST(UnusualRobots, LegsOfTwoJointsWalkStraightAndDoNotTurn) {
  const RobotModel model = *LoadRobotFromText(unusual::Planar(), "");
  WalkRequest request;
  request.command.distance_m = 0.5;
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  const Result<PlayedWalk> played = PlayWalk(model, planned->motion.plan, PlayRequest{});
  ASSERT_TRUE(played.ok());
  EXPECT_TRUE(played->report.pass) << played->report.reason;
  for (const auto& [lateral_m_s, yaw_rad_s] : {std::pair(0.1, 0.0), {0.0, 0.2}}) {
    WalkRequest lateral = request;
    lateral.command.lateral_speed_m_s = lateral_m_s;
    lateral.command.yaw_rate_rad_s = yaw_rad_s;
    const Result<PlannedWalk> refused = PlanWalk(model, lateral);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.failure().code, FailureCode::kFreedoms) << refused.failure().message;
  }
}

TEST(UnusualRobots, WideSolesWithoutAnkleRollHaveASoundPlanAndDoNotFall) {
  const RobotModel model = *LoadRobotFromText(unusual::SoledBiped(false, false), "");
  WalkRequest request;
  request.command.distance_m = 0.5;
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  const Result<PlayedWalk> played = PlayWalk(model, planned->motion.plan, PlayRequest{});
  ASSERT_TRUE(played.ok()) << played.failure().message;
  EXPECT_EQ(*played->report.At("fell").value, 0.0) << played->report.reason;
}

TEST(UnusualRobots, ABipedOnPointsStepsForTenSecondsAndDoesNotStand) {
  const RobotModel model = *LoadRobotFromText(unusual::PointBiped(), "");
  WalkRequest request;
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = 40;
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_GT(planned->motion.plan.duration_s(), 8.0);
  PlayRequest play;
  play.play.world.engine = ProvingEngine();
  const Result<PlayedWalk> played = PlayWalk(model, planned->motion.plan, play);
  ASSERT_TRUE(played.ok()) << played.failure().message;
  EXPECT_TRUE(played->pass()) << played->decisive().report.reason;
  WalkRequest stand;
  stand.sequence = "stand: duration=1";
  const Result<PlannedWalk> refused = PlanWalk(model, stand);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.failure().code, FailureCode::kNoSupport);
}

TEST(UnusualRobots, ARobotThatCannotWalkIsRefusedWithTheReason) {
  const std::vector<std::pair<std::string, std::string>> refused = {
      {unusual::Pantograph(), "leg 'a_foot' cannot walk"}};
  for (const auto& [urdf, why] : refused) {
    WalkRequest request;
    request.command.distance_m = 0.5;
    const Result<PlannedWalk> planned = PlanWalk(*LoadRobotFromText(urdf, ""), request);
    ASSERT_FALSE(planned.ok()) << why;
    EXPECT_EQ(planned.failure().kind, FailureKind::kInfeasible);
    EXPECT_NE(planned.failure().message.find(why), std::string::npos) << planned.failure().message;
    const bool of_build =
        planned.failure().code == FailureCode::kFreedoms || planned.failure().code == FailureCode::kNoSupport;
    EXPECT_EQ(planned.failure().message.find("no speed") == std::string::npos, of_build) << "no speed is to blame";
  }
}

}  // namespace
}  // namespace gaitwright
