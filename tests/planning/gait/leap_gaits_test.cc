// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "planning/gait/leap_gaits_internal.h"

namespace gaitwright {
namespace {

TEST(LeapGaits, AreFoundByWhatTheGaitsDo) {
  EXPECT_EQ(LeapGait(4), "jump") << "it has a stride of its own, unlike the pronk";
  EXPECT_EQ(LeapGait(2), "hop");
  for (const int feet : {0, 1, 3, 6}) EXPECT_EQ(LeapGait(feet), "") << feet;
  EXPECT_EQ(GaitTurningOver(4, "backward"), "backflip");
  EXPECT_EQ(GaitTurningOver(4, "right"), "barrel-roll");
  EXPECT_EQ(GaitTurningOver(4, "left"), "barrel-roll-left");
  EXPECT_EQ(GaitTurningOver(4, "forward"), "");
  EXPECT_EQ(GaitTurningOver(2, "backward"), "");
}

}  // namespace
}  // namespace gaitwright
