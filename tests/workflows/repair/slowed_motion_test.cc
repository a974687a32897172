// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/slowed_motion_internal.h"

namespace gaitwright {
namespace {

/// A base that moves forward at 1 m/s for 4 s, with a foot in the air in the second half.
EvenMotion Forward(const RobotModel& model) {
  EvenMotion motion = synthetic::Standing(model, 401);
  for (int k = 0; k < motion.size(); ++k) {
    motion.q[static_cast<std::size_t>(k)][0] = 0.01 * k;
    motion.v[static_cast<std::size_t>(k)][0] = 1.0;
    motion.contact.push_back(k < 200 ? 15U : 14U);
  }
  return motion;
}

TEST(SlowedMotion, TakesAPartForLonger) {
  const RobotModel& model = NamedRobot("a1");
  const EvenMotion motion = Forward(model);
  const SlowedMotion slowed = WithSlowParts(motion, motion.contact, {{1.5, 2.5, 2.0, ""}});
  // One second at half the speed adds a second, and both changes of pace add the mean over 0.4 s.
  EXPECT_NEAR(slowed.motion.TimeOf(slowed.motion.size() - 1), 4.0 + 1.0 + 0.4, 0.02);
  ASSERT_EQ(slowed.stance.size(), slowed.motion.q.size());
  double slowest = 1.0;
  for (std::size_t k = 1; k < slowed.file_s.size(); ++k) {
    const double moved = slowed.motion.q[k][0] - slowed.motion.q[k - 1][0];
    EXPECT_NEAR(slowed.motion.q[k][0], slowed.file_s[k], 1e-9);
    EXPECT_GE(moved, 0.0);
    if (k + 1 < slowed.file_s.size()) slowest = std::min(slowest, moved / 0.01);
    EXPECT_EQ(slowed.stance[k], slowed.file_s[k] < 1.995 ? 15U : 14U) << slowed.file_s[k];
  }
  EXPECT_NEAR(slowest, 0.5, 1e-6);
  EXPECT_EQ(slowed.file_s.back(), 4.0);
  EXPECT_NEAR((slowed.motion.q[50][0] - slowed.motion.q[49][0]) / 0.01, 1.0, 1e-9) << "at its own pace before";
}

TEST(SlowedMotion, WithoutPartsIsTheSame) {
  const EvenMotion motion = Forward(NamedRobot("a1"));
  const SlowedMotion same = WithSlowParts(motion, motion.contact, {});
  ASSERT_EQ(same.motion.size(), motion.size());
  EXPECT_NEAR(same.motion.q[123][0], motion.q[123][0], 1e-9);
}

TEST(SlowDown, GoesInStepsUpToTheMost) {
  std::vector<SlowedPart> parts;
  for (const double factor : {1.26, 1.5874, 2.0}) {
    ASSERT_TRUE(SlowDown({2.0, 1.9}, 2.0, "it fell", parts));
    ASSERT_EQ(parts.size(), 1U) << "near times are one part";
    EXPECT_NEAR(parts[0].factor, factor, 1e-3);
  }
  EXPECT_NEAR(parts[0].start_s, 1.5, 1e-12);
  EXPECT_NEAR(parts[0].end_s, 2.4, 1e-12);
  EXPECT_EQ(parts[0].why, "it fell");
  EXPECT_FALSE(SlowDown({2.0}, 2.0, "it fell", parts)) << "no further";
  EXPECT_TRUE(SlowDown({2.0, 2.7}, 2.0, "it fell", parts)) << "but wider";
  ASSERT_TRUE(SlowDown({7.0}, 2.0, "no solution", parts));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[1].factor, 1.26, 1e-2);
  EXPECT_EQ(parts[1].why, "no solution");
  EXPECT_FALSE(SlowDown({}, 2.0, "", parts));
}

}  // namespace
}  // namespace gaitwright
