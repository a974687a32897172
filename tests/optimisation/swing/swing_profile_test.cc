// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/swing_profile.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

/// From the origin forward, optionally up onto a step.
SwingCurve Forward(double distance_m, double rise_m) {
  SwingCurve swing;
  swing.X_WF_end.translation() = Vector3(distance_m, 0.0, rise_m);
  return swing;
}

const std::vector<Vector3> kPoint = {Vector3::Zero()};

TEST(SwingProfile, IsLevelOverLevelGround) {
  const SwingProfile profile(Forward(0.4, 0.0), kPoint, [](const Vector2&) { return 0.0; }, {});
  EXPECT_DOUBLE_EQ(profile.length_m(), 0.4);
  EXPECT_LT((profile.along_W() - Vector2::UnitX()).norm(), 1e-12);
  for (const double s : {0.0, 0.13, 0.4}) {
    EXPECT_DOUBLE_EQ(profile.Highest(s, 0.05).first, 0.0);
    EXPECT_DOUBLE_EQ(profile.Highest(s, 0.05).second, 0.0);
  }
}

TEST(SwingProfile, IsNowhereBelowTheGroundAndLeavesTheEndsAsTheyAre) {
  const auto step = [](const Vector2& p_W) { return p_W.x() < 0.2 ? 0.0 : 0.15; };
  const SwingProfile profile(Forward(0.4, 0.15), kPoint, step, {});
  for (int k = 0; k <= 200; ++k) {
    const double s = 0.002 * k;
    EXPECT_GE(profile.Highest(s, 0.0).first, step({s, 0.0}) - 1e-12) << s;
  }
  EXPECT_NEAR(profile.Highest(0.0, 0.0).first, 0.0, 1e-12);
  EXPECT_NEAR(profile.Highest(0.4, 0.0).first, 0.15, 1e-12);
  // It rises before the riser, so that the solver has a gradient; within the reach of the foot it is as high as the
  // step.
  EXPECT_GT(profile.Highest(0.19, 0.0).first, 0.05);
  EXPECT_GT(profile.Highest(0.19, 0.0).second, 1.0);
  EXPECT_NEAR(profile.Highest(0.15, 0.06).first, 0.15, 1e-12);
}

TEST(SwingProfile, OfAWideSoleIsThatOfItsForemostPoint) {
  const auto step = [](const Vector2& p_W) { return p_W.x() < 0.3 ? 0.0 : 0.1; };
  const std::vector<Vector3> sole = {{-0.05, 0.0, 0.0}, {0.05, 0.0, 0.0}};
  const SwingProfile profile(Forward(0.5, 0.1), sole, step, {});
  EXPECT_NEAR(profile.Highest(0.26, 0.0).first, 0.1, 1e-12);
}

TEST(SwingProfile, ToTheSideSeesWhatIsThere) {
  const auto ridge = [](const Vector2& p_W) { return p_W.y() > 0.05 ? 0.2 : 0.0; };
  RefineChoice lateral;
  lateral.sideways_m = 0.1;
  EXPECT_NEAR(SwingProfile(Forward(0.4, 0.0), kPoint, ridge, lateral).Highest(0.2, 0.0).first, 0.2, 1e-12);
  EXPECT_NEAR(SwingProfile(Forward(0.4, 0.0), kPoint, ridge, {}).Highest(0.2, 0.0).first, 0.0, 1e-12);
}

}  // namespace
}  // namespace gaitwright
