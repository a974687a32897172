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
  EXPECT_EQ((SlowerPace{0.75, Known::kFeasible}.Text(command, "trot")),
            "a speed of 0.75 m/s is feasible with gait 'trot'");
  EXPECT_EQ((SlowerPace{0.75, Known::kMay}.Text(command, "trot")),
            "a speed of about 0.75 m/s may be feasible with gait 'trot'");
}

}  // namespace
}  // namespace gaitwright
