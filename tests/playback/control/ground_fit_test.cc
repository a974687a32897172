// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "playback/control/ground_fit_internal.h"

namespace gaitwright {
namespace {

/// Corners of a sole of 0.16 m by 0.08 m.
std::vector<GroundFit::Point> SoleAt(const Vector2& middle, double rise_m, const Vector2& slope) {
  std::vector<GroundFit::Point> points;
  for (const Vector2& corner : {Vector2(0.08, 0.04), Vector2(-0.08, 0.04), Vector2(-0.08, -0.04), Vector2(0.08, -0.04)})
    points.push_back({middle + corner, rise_m + slope.dot(corner)});
  return points;
}

TEST(GroundFit, IsThePlansGroundWithoutPoints) {
  GroundFit fit;
  fit.Reset(2);
  fit.Fit();
  EXPECT_FALSE(fit.has_points());
  EXPECT_EQ(fit.RiseAt({0.3, 0.2}), 0.0);
  EXPECT_EQ(fit.Tilt_W(), Vector3::Zero());
}

TEST(GroundFit, FindsASlopeUnderBothFeet) {
  const Vector2 slope(0.05, -0.03), left(0.0, 0.1), right(0.05, -0.1);
  GroundFit fit;
  fit.Reset(2);
  fit.Stand(0, SoleAt(left, slope.dot(left), slope));
  fit.Stand(1, SoleAt(right, slope.dot(right), slope));
  fit.Fit();
  const Vector2 next(0.1, 0.1);
  EXPECT_NEAR(fit.RiseAt(next), slope.dot(next), 0.0005);
  EXPECT_LT((fit.Tilt_W() - Vector3(slope.y(), -slope.x(), 0.0)).norm(), 0.05 * slope.norm());
}

TEST(GroundFit, TiltOfOneSoleOnABumpIsHardlyASlope) {
  const Vector2 tilted(0.0, 0.05);
  GroundFit fit;
  fit.Reset(2);
  fit.Stand(0, SoleAt({0.0, 0.1}, 0.0, tilted));
  fit.Stand(1, SoleAt({0.0, -0.1}, 0.0, Vector2::Zero()));
  fit.Fit();
  EXPECT_GT(fit.Tilt_W().x(), 0.0);
  EXPECT_LT(fit.Tilt_W().norm(), 0.1 * tilted.norm());
}

TEST(GroundFit, KeepsTheLastStanceUntilTheNextOneEnds) {
  GroundFit fit;
  fit.Reset(1);
  const auto rise = [&](double rise_m) {
    fit.Stand(0, SoleAt({0.0, 0.0}, rise_m, Vector2::Zero()));
    fit.Fit();
    return fit.RiseAt({0.0, 0.0});
  };
  EXPECT_NEAR(rise(0.01), 0.01, 1e-12);
  EXPECT_NEAR(rise(0.02), 0.02, 1e-12) << "the same stance";
  fit.Leave(0);
  EXPECT_NEAR(rise(0.04), 0.03, 1e-12) << "mean of the present and the last stance";
  fit.Leave(0);
  EXPECT_NEAR(rise(0.0), 0.02, 1e-12);
  fit.Reset(1);
  EXPECT_EQ(fit.RiseAt({0.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace gaitwright
