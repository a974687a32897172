// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/rest_at_ends_internal.h"

namespace gaitwright {
namespace {

TEST(RestAtEnds, LeavesAMotionFromRestToRestAsItIs) {
  const EvenMotion motion = synthetic::Standing(NamedRobot("a1"), 100);
  const RestedMotion rested =
      WithRestAtEnds(NamedRobot("a1"), motion, std::vector<FootSet>(100, AllFeet(4)), RepairOptions{});
  EXPECT_EQ(rested.motion.size(), 100);
  EXPECT_EQ(rested.slowed_start_s + rested.slowed_end_s + rested.stood_start_s + rested.stood_end_s, 0.0);
}

TEST(RestAtEnds, BringsAMotionToItsSpeedAndBackToRest) {
  EvenMotion motion = synthetic::Standing(NamedRobot("a1"), 201);
  for (int k = 0; k <= 200; ++k) {
    motion.q[static_cast<std::size_t>(k)][0] = 0.5 * k * motion.step_s;
    motion.v[static_cast<std::size_t>(k)][0] = 0.5;
  }
  const RestedMotion rested =
      WithRestAtEnds(NamedRobot("a1"), motion, std::vector<FootSet>(201, AllFeet(4)), RepairOptions{});
  EXPECT_NEAR(rested.slowed_start_s, 0.6, 1e-9);
  EXPECT_NEAR(rested.motion.TimeOf(rested.motion.size() - 1), 2.6, 1e-9) << "half of each ramp more";
  const auto& q = rested.motion.q;
  EXPECT_LT(q[1][0] - q[0][0], 1e-5) << "from rest";
  EXPECT_LT(q.back()[0] - q[q.size() - 2][0], 1e-5) << "to rest";
  EXPECT_NEAR(q[q.size() / 2 + 1][0] - q[q.size() / 2][0], 0.005, 1e-6) << "at its own speed";
  EXPECT_NEAR(q.back()[0], 1.0, 1e-9);
  for (std::size_t k = 1; k < rested.file_s.size(); ++k) EXPECT_GE(rested.file_s[k], rested.file_s[k - 1]);
}

TEST(RestAtEnds, StandsBeforeAFootIsInTheAir) {
  const EvenMotion motion = synthetic::Standing(NamedRobot("a1"), 100);
  std::vector<FootSet> stance(100, AllFeet(4));
  for (std::size_t k = 0; k < 40; ++k) stance[k] = FootBit(0);
  const RestedMotion rested = WithRestAtEnds(NamedRobot("a1"), motion, stance, RepairOptions{});
  EXPECT_NEAR(rested.stood_start_s, 1.2, 1e-9);
  EXPECT_EQ(rested.stood_end_s, 0.0);
  EXPECT_EQ(rested.stance.front(), AllFeet(4));
  EXPECT_EQ(rested.stance[100], FootBit(0));
  EXPECT_EQ(rested.stance.back(), AllFeet(4));
}

}  // namespace
}  // namespace gaitwright
