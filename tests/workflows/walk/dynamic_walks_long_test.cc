// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "kinematics/model/load_robot.h"
#include "tests/unusual_robots.h"
#include "tests/workflows/walk/dynamic_walks.h"

namespace gaitwright {
namespace {

class DynamicWalksLong : public testing::TestWithParam<DynamicWalk> {};

TEST_P(DynamicWalksLong, PassOverFiveMetres) { ExpectToFly(GetParam()); }

TEST(DynamicWalksLong, BoundsOverAGapOf30Centimetres) {
  WalkRequest request;
  request.gait = "bound";
  request.terrain = "gap:width_m=0.3";
  request.command.speed_m_s = 0.8;
  request.command.distance_m = 3.0;
  ExpectToFly(request);
}

TEST(DynamicWalksLong, ABipedHopsForwardAndRuns) {
  const RobotModel runner = *LoadRobotFromText(unusual::Runner(), "");
  for (const DynamicWalk& walk :
       {DynamicWalk{"hop", 0.3, 2.0}, DynamicWalk{"run", 0.5, 3.0}, DynamicWalk{"run", 1.0, 5.0}}) {
    WalkRequest request;
    request.gait = walk.gait;
    request.command.speed_m_s = walk.speed_m_s;
    request.command.distance_m = walk.distance_m;
    SCOPED_TRACE(walk.gait);
    ExpectToFly(runner, request);
  }
}

/// Flights of 0.05 s are near the limit of its knee speed.
TEST(DynamicWalksLong, TheNaoHopsInPlace) {
  WalkRequest request;
  request.gait = "hop";
  request.gait_options.cycle_s = 0.5;
  request.gait_options.duty_factor = 0.9;
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = 4;
  request.command.step_length_m = 0.0;
  ExpectToFly(LoadNamedRobot("nao").value(), request);
}

class JumpsLong : public testing::TestWithParam<std::pair<std::string, double>> {};

TEST_P(JumpsLong, PassAtDefaultSettings) { ExpectToFly(OneLeap(GetParam().first, GetParam().second)); }

TEST(OtherFlightsLong, AreNotNeededForALeapDownABlock) {
  const WalkRequest request = OneLeap("block:height_m=0.15,start_m=-1.5,length_m=1.76", 0.66);
  const Result<PlannedWalk> planned = PlanWalk(*LoadNamedRobot("a1"), request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  EXPECT_TRUE(planned->motion.plan.adjustments.empty());
}

INSTANTIATE_TEST_SUITE_P(OntoABlock, JumpsLong,
                         testing::Values(std::pair{"block:height_m=0.15,start_m=0.26,length_m=2", 0.52},
                                         std::pair{"block:height_m=0.15,start_m=0.28,length_m=2", 0.52},
                                         std::pair{"block:height_m=0.15,start_m=0.3,length_m=2", 0.52},
                                         std::pair{"block:height_m=0.15,start_m=0.33,length_m=2", 0.52},
                                         std::pair{"block:height_m=0.15,start_m=0.36,length_m=2", 0.52},
                                         std::pair{"block:height_m=0.2,start_m=0.31,length_m=2", 0.52}));
INSTANTIATE_TEST_SUITE_P(Down, JumpsLong,
                         testing::Values(std::pair{"block:height_m=0.1,start_m=-1.5,length_m=1.72", 0.6},
                                         std::pair{"block:height_m=0.15,start_m=-1.5,length_m=1.76", 0.66},
                                         std::pair{"block:height_m=0.2,start_m=-1.5,length_m=1.72", 0.6}));
INSTANTIATE_TEST_SUITE_P(OverAGap, JumpsLong,
                         testing::Values(std::pair{"gap:width_m=0.2,start_m=0.2", 0.4},
                                         std::pair{"gap:width_m=0.2,start_m=0.28", 0.4}));

INSTANTIATE_TEST_SUITE_P(A1, DynamicWalksLong,
                         testing::Values(DynamicWalk{"trot", 1.5, 5.0}, DynamicWalk{"trot", 1.0, 5.0, 0.4},
                                         DynamicWalk{"bound", 0.8, 5.0}, DynamicWalk{"pronk", 0.5, 5.0},
                                         DynamicWalk{"gallop", 1.0, 5.0}));
// Near the limits of the motors; the stances of the bound, 0.07 s, need a finer grid than other gaits.
INSTANTIATE_TEST_SUITE_P(A1AtSpeed, DynamicWalksLong,
                         testing::Values(DynamicWalk{"trot", 2.5, 6.0}, DynamicWalk{"bound", 3.0, 6.0},
                                         DynamicWalk{"gallop", 1.5, 5.0}));

}  // namespace
}  // namespace gaitwright
