// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/sequences.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <variant>

#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

/// Why a sequence of the A1 is refused; empty if it is accepted.
std::string Why(const std::string& sequence, const std::string& terrain = "flat") {
  WalkRequest request;
  request.sequence = sequence;
  request.terrain = terrain;
  const Result<PlannedWalk> planned = PlanWalk(LoadNamedRobot("a1").value(), request);
  return planned.ok() ? "" : planned.failure().message;
}

TEST(Sequences, A1StandsWalksTrotsAndStands) {
  ExpectToWalk("stand: duration=0.8; walk: speed=0.1, distance=0.3; trot: speed=0.4, distance=0.6; stand: duration=1",
               4);
}

TEST(Sequences, A1StandsBetweenTwoGaits) {
  ExpectToWalk("trot: speed=0.5, distance=0.6; stand: duration=1; walk: speed=0.1, distance=0.2", 3);
}

TEST(Sequences, A1TrotsAmblesAndTurnsWithoutStopping) {
  ExpectToWalk("trot: speed=0.5, distance=0.6; amble: speed=0.35, distance=0.6; trot: yaw-rate=0.6", 3);
}

TEST(Sequences, RefusalsNameThePart) {
  EXPECT_NE(Why("trot; stand: duration=1; canter").find("part 3, 'canter': there is no gait 'canter'"),
            std::string::npos);
  EXPECT_NE(Why("trot:speed=0.4; trot: duration=0").find("part 2, 'trot': the duration is 0 s"), std::string::npos);
  EXPECT_NE(Why("trot; stand: duration=1; walk", "stairs").find("level ground"), std::string::npos);
}

TEST(Sequences, APartThatIsTooFastIsNamedWithASpeedThatServes) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  const auto planned = [&](double speed_m_s) {
    WalkRequest request;
    request.sequence =
        fmt::format("trot: speed=0.4, distance=0.2; stand: duration=0.5; walk: speed={}, distance=0.3", speed_m_s);
    return PlanWalk(a1, request);
  };
  const Result<PlannedWalk> refused = planned(1.5);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.failure().message.find("part 3, 'walk'"), std::string::npos) << refused.failure().message;
  const Suggestion& slower = refused.failure().suggestions.front();
  EXPECT_EQ(slower.what, "speed");
  const Result<PlannedWalk> served = planned(std::get<double>(slower.value));
  EXPECT_TRUE(served.ok()) << served.failure().message;
}

}  // namespace
}  // namespace gaitwright
