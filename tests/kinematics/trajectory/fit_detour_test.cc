// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/trajectory/fit_detour.h"

#include <gtest/gtest.h>

#include <random>

#include "kinematics/base/result.h"
#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {
namespace {

/// Offsets of a curve from its straight move at even fractions.
std::vector<Vector3> OffsetsOf(const SwingCurve& curve, const std::vector<double>& shares) {
  const SwingCurve straight = StraightMoveOf(curve);
  std::vector<Vector3> off_W;
  for (const double u : shares)
    off_W.emplace_back(Evaluate(curve, u).X_WF.translation() - Evaluate(straight, u).X_WF.translation());
  return off_W;
}

std::vector<double> EvenShares(int count) {
  std::vector<double> shares;
  for (int i = 1; i <= count; ++i) shares.push_back(static_cast<double>(i) / (count + 1));
  return shares;
}

TEST(FitDetour, FindsTheControlPointsOfADetour) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> even(-0.05, 0.05);
  for (const double cruise : {0.0, 0.5}) {
    SwingCurve curve;
    curve.X_WF_end.translation() = Vector3(0.3, 0.1, 0.05);
    curve.cruise = cruise;
    for (int i = 0; i < 9; ++i) curve.detour_W.emplace_back(even(random), even(random), even(random));
    const std::vector<double> shares = EvenShares(40);
    const std::vector<Vector3> found = FitDetour(shares, OffsetsOf(curve, shares), 9);
    ASSERT_EQ(found.size(), curve.detour_W.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LT((found[i] - curve.detour_W[i]).norm(), 1e-9) << i;
  }
}

TEST(FitDetour, IsNearABump) {
  SwingCurve curve;
  curve.X_WF_end.translation().x() = 0.2;
  curve.lift_m = 0.05;
  const std::vector<double> shares = EvenShares(40);
  SwingCurve fitted = curve;
  fitted.detour_W = FitDetour(shares, OffsetsOf(curve, shares), 8);
  for (double u = 0.0; u <= 1.0; u += 0.01) {
    const Vector3 off_W = Evaluate(fitted, u).X_WF.translation() - Evaluate(curve, u).X_WF.translation();
    EXPECT_LT(off_W.norm(), 1e-3) << u;
  }
}

TEST(FitDetour, RefusesMorePointsThanFractions) {
  EXPECT_THROW(FitDetour({0.3, 0.6}, {Vector3::Zero(), Vector3::Zero()}, 3), InvalidArgument);
  EXPECT_THROW(FitDetour({0.3, 0.6}, {Vector3::Zero()}, 1), InvalidArgument);
  EXPECT_THROW(FitDetour({0.3, 0.6}, {Vector3::Zero(), Vector3::Zero()}, 0), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
