// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "playback/bullet/ground_internal.h"
#include "playback/engine/world.h"

namespace gaitwright {
namespace {

TEST(Bumps, AreZeroUnderTheStartBoundedAndSmooth) {
  const Bumps bumps{{1.0, 2.0}, 0.01, 0.4, 0.5, 3};
  double highest = 0.0, lowest = 0.0, steepest = 0.0;
  for (double x = -3.0; x < 5.0; x += 0.013) {
    for (double y = -2.0; y < 6.0; y += 0.17) {
      const double h = bumps.HeightAt({x, y});
      if ((Vector2(x, y) - bumps.start).norm() < 0.5) {
        EXPECT_EQ(h, 0.0);
      }
      highest = std::max(highest, h);
      lowest = std::min(lowest, h);
      steepest = std::max(steepest, std::abs(bumps.HeightAt({x + 1e-4, y}) - h) / 1e-4);
    }
  }
  EXPECT_LE(highest, 0.01);
  EXPECT_GT(highest, 0.008);
  EXPECT_GE(lowest, -0.01);
  EXPECT_LT(lowest, -0.008);
  EXPECT_LT(steepest, 2.0 * 0.01 * 1.875 / 0.2);
}

TEST(Bumps, DependOnTheSeedAlone) {
  const Bumps one{{0.0, 0.0}, 0.01, 0.4, 0.0, 1}, same{{0.0, 0.0}, 0.01, 0.4, 0.0, 1},
      other{{0.0, 0.0}, 0.01, 0.4, 0.0, 2};
  EXPECT_EQ(one.HeightAt({1.3, 0.4}), same.HeightAt({1.3, 0.4}));
  EXPECT_NE(one.HeightAt({1.3, 0.4}), other.HeightAt({1.3, 0.4}));
}

TEST(GroundTilt, IsUphillForwardAndKeepsTheStart) {
  WorldOptions options;
  options.ground_slope_deg = 10.0;
  const Pose X = GroundTilt(FlatTerrain(), options, {2.0, 1.0});
  EXPECT_LT((X * Vector3(2.0, 1.0, 0.0) - Vector3(2.0, 1.0, 0.0)).norm(), 1e-15);
  EXPECT_NEAR((X * Vector3(3.0, 1.0, 0.0)).z(), std::sin(10.0 * 3.14159265358979 / 180.0), 1e-12);
}

}  // namespace
}  // namespace gaitwright
