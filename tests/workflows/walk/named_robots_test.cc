// SPDX-License-Identifier: BSD-3-Clause
// The built-in robots: each walks a metre at its default speed, with robot.yaml, from its URDF alone, and written in
// other conventions; or the refusal gives the reason.
#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "tests/disguised_urdf.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

void ExpectWalks(const RobotModel& model, const std::string& gait = "") {
  WalkRequest request;
  request.gait = gait;
  request.command.distance_m = 1.0;
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  const Result<PlayedWalk> played = PlayWalk(model, planned->motion.plan, PlayRequest{});
  ASSERT_TRUE(played.ok()) << played.failure().message;
  EXPECT_TRUE(played->report.pass) << played->report.reason;
}

class NamedRobot : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, NamedRobot,
                         testing::Values("a1", "go1", "laikago", "mini_cheetah", "nao", "humanoid", "h1", "g1", "h1_2"),
                         [](const auto& name) { return name.param; });

TEST_P(NamedRobot, WalksAMetre) { ExpectWalks(LoadNamedRobot(GetParam()).value()); }

TEST_P(NamedRobot, WalksAMetreFromItsUrdfAlone) {
  ExpectWalks(LoadRobotFromText(LoadNamedRobot(GetParam()).value().urdf_text, "").value());
}

TEST_P(NamedRobot, WalksAMetreInOtherConventions) {
  DisguisedUrdf disguise(LoadNamedRobot(GetParam()).value().urdf_text, 7);
  ExpectWalks(LoadRobotFromText(disguise.text(), "").value());
}

class NamedQuadruped : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, NamedQuadruped, testing::Values("a1", "go1", "laikago", "mini_cheetah"),
                         [](const auto& name) { return name.param; });

TEST_P(NamedQuadruped, TrotsAMetre) { ExpectWalks(LoadNamedRobot(GetParam()).value(), "trot"); }

void ExpectWalksInBothEngines(const std::string& robot, double speed_m_s, double distance_m,
                              const std::string& terrain = "flat") {
  const RobotModel model = LoadNamedRobot(robot).value();
  WalkRequest request;
  request.terrain = terrain;
  request.command.distance_m = distance_m;
  request.command.speed_m_s = speed_m_s;
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  PlayRequest play;
  play.play.world.engine = ProvingEngine();
  const Result<PlayedWalk> played = PlayWalk(model, planned->motion.plan, play);
  ASSERT_TRUE(played.ok()) << played.failure().message;
  EXPECT_TRUE(played->pass()) << robot << ": " << played->decisive().report.reason;
}

/// By the limits that their maker publishes.
TEST(NamedRobots, HumanoidsWalkAMetreASecondInBothEngines) {
  for (const char* robot : {"g1", "h1_2"}) ExpectWalksInBothEngines(robot, 1.0, 2.0);
}

/// The steps of houses, a quarter of its legs high.
TEST(NamedRobots, TheG1ClimbsStairsOfHouses) {
  ExpectWalksInBothEngines("g1", 0.137, 1.0, "stairs:rise_m=0.17,tread_m=0.28,count=3");
}

/// Its soles are bars of 3 cm without an ankle roll joint, so the body falls from foot to foot.
TEST(NamedRobots, TheH1WalksInBothEngines) {
  for (const double speed_m_s : {0.5, -0.3}) ExpectWalksInBothEngines("h1", speed_m_s, 1.0);
}

/// Stands for three seconds and withstands pushes of 10 N for half a second.
void ExpectStandsAgainstPushes(const RobotModel& h1) {
  WalkRequest request;
  request.sequence = "stand: duration=3";
  const Result<PlannedWalk> planned = PlanWalk(h1, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  for (const Vector3& push_n : {Vector3(10, 0, 0), Vector3(-10, 0, 0), Vector3(0, 10, 0), Vector3(0, -10, 0)}) {
    PlayRequest play;
    play.play.push_force_W = push_n;
    play.play.push_at_s = 1.0;
    play.play.push_for_s = 0.5;
    const Result<PlayedWalk> played = PlayWalk(h1, planned->motion.plan, play);
    ASSERT_TRUE(played.ok()) << played.failure().message;
    EXPECT_TRUE(played->report.pass) << played->report.reason;
  }
}

TEST(NamedRobots, TheH1StandsAgainstPushes) { ExpectStandsAgainstPushes(LoadNamedRobot("h1").value()); }

TEST(NamedRobots, TheH1StandsAgainstPushesFromItsUrdfAlone) {
  ExpectStandsAgainstPushes(LoadRobotFromText(LoadNamedRobot("h1").value().urdf_text, "").value());
}

}  // namespace
}  // namespace gaitwright
