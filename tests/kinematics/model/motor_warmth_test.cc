// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/motor_warmth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gaitwright {
namespace {

TEST(MotorWarmth, TheLimitFallsInALineToTheContinuousEffort) {
  const Motor motor{.continuous_effort = 4.0};
  EXPECT_EQ(EffortWhenWarm(motor, 0.0, 10.0), 10.0);
  EXPECT_EQ(EffortWhenWarm(motor, 0.8 * 16.0, 10.0), 10.0);
  EXPECT_NEAR(EffortWhenWarm(motor, 0.9 * 16.0, 10.0), 7.0, 1e-12);
  EXPECT_NEAR(EffortWhenWarm(motor, 16.0 - 1e-9, 10.0), 4.0, 1e-8);
  EXPECT_EQ(EffortWhenWarm(motor, 16.0, 10.0), 4.0);
  EXPECT_EQ(EffortWhenWarm(motor, 100.0, 10.0), 4.0);
}

TEST(MotorWarmth, NoContinuousEffortIsNoLimit) {
  EXPECT_EQ(EffortWhenWarm(Motor{}, 1e9, 10.0), 10.0);
  EXPECT_EQ(EffortWhenWarm(Motor{}, 1e9, Motor::kNone), Motor::kNone);
  EXPECT_EQ(EffortWhenWarm(Motor{.continuous_effort = 10.0}, 1e9, 10.0), 10.0);
}

TEST(MotorWarmth, WithoutAPeakTheLimitComesAtOnce) {
  const Motor motor{.continuous_effort = 4.0};
  EXPECT_EQ(EffortWhenWarm(motor, 15.9, Motor::kNone), Motor::kNone);
  EXPECT_EQ(EffortWhenWarm(motor, 16.0, Motor::kNone), 4.0);
}

TEST(MotorWarmth, GoesOnInAnyNumberOfParts) {
  const Motor motor{.continuous_effort = 4.0, .thermal_s = 3.0};
  const double whole = WarmthAfter(motor, 2.0, 5.0, 1.0);
  EXPECT_NEAR(whole, 25.0 - 23.0 * std::exp(-1.0 / 3.0), 1e-12);
  double parts = 2.0;
  for (int k = 0; k < 10; ++k) parts = WarmthAfter(motor, parts, -5.0, 0.1);
  EXPECT_NEAR(parts, whole, 1e-12);
  EXPECT_NEAR(WarmthAfter(motor, whole, 0.0, 1e3), 0.0, 1e-12) << "it cools";
}

}  // namespace
}  // namespace gaitwright
