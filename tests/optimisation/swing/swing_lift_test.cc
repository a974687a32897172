// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/swing_lift.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

RobotModel WithKnee(double speed, double lower = -2.7) {
  unusual::UrdfText::Motion knee = unusual::Knee();
  knee.speed = speed;
  knee.lower = lower;
  return LoadRobotFromText(unusual::FourLegged(unusual::Abduction(), knee), "").value();
}

TEST(SwingLift, SlowMotorsLiftLess) {
  const RobotModel fast = WithKnee(20.0), slow = WithKnee(1.0);
  const double usual = SwingLift(fast, {});
  EXPECT_GT(usual, 0.04);
  EXPECT_EQ(SpeedBoundLift(fast).LiftInTime(0, 0.3, usual), usual);
  const double bound = SpeedBoundLift(slow).LiftInTime(0, 0.3, usual);
  EXPECT_LT(bound, 0.9 * usual);
  EXPECT_GE(bound, 0.25 * usual);
  EXPECT_EQ(SpeedBoundLift(slow).LiftInTime(0, 3.0, usual), usual) << "in ten times the time";
}

TEST(SwingLift, KneesThatBendLittleLiftLess) {
  const RobotModel free = WithKnee(20.0), narrow = WithKnee(20.0, -1.3);
  EXPECT_LT(SwingLift(narrow, {}), SwingLift(free, {}));
  EXPECT_EQ(SwingLift(narrow, {.height_m = 0.07}), 0.07) << "as it is given";
}

}  // namespace
}  // namespace gaitwright
