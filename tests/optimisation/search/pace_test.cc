// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/pace.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

WalkCommand Speeds(double forward, double lateral, double turning) {
  WalkCommand command;
  command.speed_m_s = forward;
  command.lateral_speed_m_s = lateral;
  command.yaw_rate_rad_s = turning;
  command.extent = WalkCommand::Extent::kDuration;
  command.duration_s = 2.0;
  return command;
}

TEST(Pace, KeepsTheProportionsOfSpeeds) {
  const RobotModel a1 = *LoadNamedRobot("a1");
  const WalkCommand half = AtPace(a1, Speeds(0.6, -0.2, 0.4), 0.3);
  EXPECT_EQ(half.speed_m_s, 0.3);
  EXPECT_EQ(half.lateral_speed_m_s, -0.1);
  EXPECT_EQ(half.yaw_rate_rad_s, 0.2);
  EXPECT_EQ(PaceFlags(half), "--speed 0.3 --lateral-speed -0.1 --yaw-rate 0.2");
}

TEST(Pace, PrefersTheForwardSpeedToTheLateralSpeedAndTheYawRate) {
  EXPECT_EQ(PaceOf(Speeds(0.3, 0.1, 0.2)), Pace::kSpeed);
  EXPECT_EQ(PaceOf(Speeds(0, 0.1, 0.2)), Pace::kLateralSpeed);
  EXPECT_EQ(PaceOf(Speeds(0, 0, 0.2)), Pace::kYawRate);
  EXPECT_EQ(PaceOf(Speeds(0, 0, 0)), Pace::kSpeed);
}

TEST(Pace, OfEachKindHasAValueThatNoLegReaches) {
  const RobotModel a1 = *LoadNamedRobot("a1");
  EXPECT_NEAR(UnreachablePace(a1, Pace::kSpeed), 3.0 * std::sqrt(9.81 * a1.leg_length_m()), 0.01);
  EXPECT_DOUBLE_EQ(UnreachablePace(a1, Pace::kStepLength), 2.0 * a1.leg_length_m());
  EXPECT_DOUBLE_EQ(UnreachablePace(a1, Pace::kYawRate) * a1.leg_length_m(), UnreachablePace(a1, Pace::kSpeed));
}

TEST(Pace, EachPaceIsNamedWithItsUnitAndAsAnAmount) {
  WalkCommand lateral, turning, steps;
  lateral.lateral_speed_m_s = -0.2;
  turning.extent = WalkCommand::Extent::kDuration;
  turning.yaw_rate_rad_s = -0.5;
  steps.extent = WalkCommand::Extent::kSteps;
  steps.step_length_m = -0.1;
  EXPECT_EQ(PaceName(PaceOf(lateral)) + " " + PaceText(lateral), "lateral speed 0.2 m/s");
  EXPECT_EQ(PaceName(PaceOf(turning)) + " " + PaceText(turning), "turning rate 0.5 rad/s");
  EXPECT_EQ(PaceName(PaceOf(steps)) + " " + PaceText(steps), "step length 0.1 m");
}

}  // namespace
}  // namespace gaitwright
