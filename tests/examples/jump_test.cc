// SPDX-License-Identifier: BSD-3-Clause
#include "examples/jump.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright::examples {
namespace {

TEST(JumpExample, IsThrownLikeAStone) {
  const Leap leap = LeapForward("a1", 0.4);
  EXPECT_TRUE(leap.report.pass) << leap.report.reason;
  EXPECT_GT(leap.rise_m, 0.05);
  const double thrown_s = std::sqrt(2.0 * leap.rise_m / kGravity) + std::sqrt(2.0 * leap.drop_m / kGravity);
  EXPECT_NEAR(leap.air_s, thrown_s, 0.001);
  EXPECT_NEAR(leap.air_s, leap.planned_air_s, 0.02);
}

TEST(JumpExample, ABipedHasNoSuchGait) { EXPECT_THROW(LeapForward("nao", 0.1), InvalidArgument); }

}  // namespace
}  // namespace gaitwright::examples
