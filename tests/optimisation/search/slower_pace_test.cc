// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/slower_pace.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

TEST(SlowerPace, SaysNoMoreThanIsKnown) {
  WalkCommand command;
  command.speed_m_s = 0.75;
  using Known = SlowerPace::Known;
  EXPECT_EQ((SlowerPace{0.75, Known::kLargest}.Text(command, "trot")),
            "the largest speed with gait 'trot' is 0.75 m/s");
  EXPECT_EQ((SlowerPace{0.75, Known::kServes}.Text(command, "trot")), "a speed of 0.75 m/s serves with gait 'trot'");
  EXPECT_EQ((SlowerPace{0.75, Known::kMay}.Text(command, "trot")),
            "a speed of about 0.75 m/s may serve with gait 'trot'");
}

TEST(SlowerPace, EachPaceIsNamedWithItsUnitAndAsAnAmount) {
  WalkCommand aside, turning, steps;
  aside.lateral_speed_m_s = -0.2;
  turning.extent = WalkCommand::Extent::kDuration;
  turning.yaw_rate_rad_s = -0.5;
  steps.extent = WalkCommand::Extent::kSteps;
  steps.step_length_m = -0.1;
  EXPECT_EQ(PaceName(PaceOf(aside)) + " " + PaceText(aside), "lateral speed 0.2 m/s");
  EXPECT_EQ(PaceName(PaceOf(turning)) + " " + PaceText(turning), "turning rate 0.5 rad/s");
  EXPECT_EQ(PaceName(PaceOf(steps)) + " " + PaceText(steps), "step length 0.1 m");
}

}  // namespace
}  // namespace gaitwright
