// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "kinematics/base/result.h"
#include "kinematics/model/load_robot.h"
#include "planning/gait/find_gait.h"
#include "planning/gait/schedule_contacts.h"

namespace gaitwright {
namespace {

TEST(Gaits, BuiltInOnesAreWhatTheirNamesSay) {
  const auto gaits = BuiltInGaits();
  ASSERT_TRUE(gaits.ok()) << gaits.failure().message;
  ASSERT_GE(gaits->size(), 8U);
  for (const GaitEntry& entry : *gaits) {
    const bool flies = entry.gait.name == "bound" || entry.gait.name == "pronk" || entry.gait.name == "gallop";
    EXPECT_EQ(HasFlight(entry.gait), flies) << entry.gait.name;
  }
}

TEST(Gaits, CrawlKeepsThreeFeetOnTheGround) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  const Result<Gait> crawl = FindGait(*a1, "walk", 0.1, {});
  ASSERT_TRUE(crawl.ok());
  for (double u = 0.0; u < 1.0; u += 0.001) EXPECT_GE(__builtin_popcountll(StanceAt(*crawl, u)), 3);
}

TEST(Gaits, FasterWalkingShortensTheCycle) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  const double slow = FindGait(*a1, "trot", 0.3, {})->cycle_s, fast = FindGait(*a1, "trot", 0.8, {})->cycle_s;
  EXPECT_NEAR(slow, 0.5, 0.02);
  EXPECT_LT(fast, slow);
}

TEST(Gaits, UnknownNameListsWhatThereIs) {
  const Result<RobotModel> nao = LoadNamedRobot("nao");
  const Result<Gait> gait = FindGait(*nao, "trot", 0.1, {});
  ASSERT_FALSE(gait.ok());
  EXPECT_NE(gait.failure().message.find("'biped'"), std::string::npos);
}

TEST(Gaits, FilesAreValidated) {
  const std::string path = testing::TempDir() + "gaits_test.yaml";
  const auto message = [&](const std::string& text) {
    std::ofstream(path) << text;
    const auto gaits = LoadGaits(path);
    std::remove(path.c_str());
    return gaits.ok() ? std::string() : gaits.failure().message;
  };
  EXPECT_EQ(message("hop: {feet: 2, cycle_s: 1.0, duty_factor: 0.6, phase: [0, 0.5]}"), "");
  EXPECT_NE(message("hop: {feet: 2, cycle_s: 1.0, duty_facto: 0.6, phase: [0, 0.5]}").find("'duty_factor'"),
            std::string::npos);
  EXPECT_NE(message("hop: {feet: 2, cycle_s: .nan, duty_factor: 0.6, phase: [0, 0.5]}").find("cycle_s"),
            std::string::npos);
  EXPECT_NE(message("hop: {feet: 2, cycle_s: 1.0, duty_factor: 0.6, phase: [0, 0.5, 0.7]}").find("3 entries"),
            std::string::npos);
  EXPECT_NE(message("hop: {feet: 2, cycle_s: 1.0, duty_factor: 1.6, phase: 0}").find("accepted"), std::string::npos);
}

TEST(Schedule, IntervalsAbutExactlyOnTheGrid) {
  for (const char* name : {"trot", "crawl", "amble", "pace"}) {
    const Result<RobotModel> a1 = LoadNamedRobot("a1");
    Gait gait = *FindGait(*a1, name, 0.2, {});
    for (int i = 0; i < 20; ++i) {
      gait.cycle_s = 0.31 + 0.0717 * i;
      ScheduleRequest request;
      request.stepping_s = 3.0 * gait.cycle_s;
      const Result<ContactSchedule> schedule = ScheduleContacts(gait, request);
      ASSERT_TRUE(schedule.ok());
      EXPECT_NO_THROW(CheckSchedule(*schedule, 4));
      EXPECT_EQ(schedule->phases.front().stance, AllFeet(4));
      EXPECT_EQ(schedule->phases.back().stance, AllFeet(4));
      for (const ContactPhase& phase : schedule->phases) {
        EXPECT_NEAR(std::remainder(phase.start_s, request.grid_s), 0.0, 1e-9);
        EXPECT_NE(phase.stance, FootSet{0});
      }
    }
  }
}

TEST(Schedule, FlightIsRefusedAsNotPlannedYet) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  const Result<ContactSchedule> schedule = ScheduleContacts(*FindGait(*a1, "pronk", 1.0, {}), {});
  ASSERT_FALSE(schedule.ok());
  EXPECT_EQ(schedule.failure().kind, FailureKind::kInfeasible);
}

TEST(Schedule, MistakesAreNamed) {
  EXPECT_THROW(CheckSchedule({}, 2), InvalidArgument);
  EXPECT_THROW(CheckSchedule({{{0.0, 1.0, 3}, {1.1, 2.0, 1}}}, 2), InvalidArgument);
  EXPECT_THROW(CheckSchedule({{{0.0, 1.0, 8}}}, 2), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
