// SPDX-License-Identifier: BSD-3-Clause
#include "examples/biped_walk.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/model/load_robot.h"

namespace gaitwright::examples {
namespace {

/// Width of a sole, across [m].
double WidthOf(const Foot& foot) {
  const auto [right, left] = std::minmax_element(foot.sole_F.begin(), foot.sole_F.end(),
                                                 [](const Vector2& a, const Vector2& b) { return a.y() < b.y(); });
  return left->y() - right->y();
}

TEST(BipedWalkExample, KeepsItsZmpInsideTheSupport) {
  const BipedWalk walk = WalkBiped("nao", 4, 0.04);
  EXPECT_TRUE(walk.report.pass) << walk.report.reason;
  EXPECT_GT(walk.margin_one_foot_m, 0.0);
  EXPECT_GT(walk.margin_both_feet_m, 0.0);
  const double half_m = 0.5 * WidthOf(LoadNamedRobot("nao").value().feet[0]);
  EXPECT_LT(walk.margin_one_foot_m, half_m) << "nothing in a sole is farther than that from its edges";
  EXPECT_EQ(std::min(walk.margin_one_foot_m, walk.margin_both_feet_m), walk.report.At("zmp_margin_min_m").value)
      << "the walk stands on one foot or on both at any time";
}

TEST(BipedWalkExample, TheLastStepClosesTheFeet) {
  const BipedWalk walk = WalkBiped("nao", 3, 0.03);
  EXPECT_NEAR(walk.report.At("distance_m").value.value_or(0.0), 2 * 0.03, 0.005);
}

TEST(BipedWalkExample, AQuadrupedIsRefused) { EXPECT_THROW(WalkBiped("a1", 4, 0.04), InvalidArgument); }

}  // namespace
}  // namespace gaitwright::examples
