// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kinematics/base/non_finite.h"
#include "kinematics/stability/polygon.h"
#include "optimisation/swing/refine_swing.h"

namespace gaitwright {
namespace {

const std::vector<Vector3> kTip = {Vector3::Zero()};
constexpr double kNoGround = -kInfinity;

SwingCurve ForwardStep(double length_m, double lift_m) {
  SwingCurve curve;
  curve.X_WF_end.translation() = Vector3(length_m, 0.0, 0.0);
  curve.lift_m = lift_m;
  return curve;
}

GroundHeight LevelAt(double height_m) {
  return [height_m](const Vector2&) { return height_m; };
}

TEST(UndersideOf, OfASphereIsItsLowerHalf) {
  Foot ball;
  ball.type = FootType::kSphere;
  ball.radius = 0.03;
  const std::vector<Vector3> points = UndersideOf(ball);
  double widest = 0.0;
  Vector3 sum = Vector3::Zero();
  for (const Vector3& p : points) {
    EXPECT_NEAR((p - Vector3(0.0, 0.0, 0.03)).norm(), 0.03, 1e-12) << p.transpose();
    EXPECT_GE(p.z(), 0.0);
    EXPECT_LE(p.z(), 0.03 + 1e-12);
    widest = std::max(widest, p.head<2>().norm());
    sum += p;
  }
  EXPECT_LT(points.front().norm(), 1e-15) << "the lowest is the contact point";
  EXPECT_NEAR(widest, 0.03, 1e-12) << "out to its equator";
  EXPECT_LT(sum.head<2>().norm(), 1e-12) << "the same on all sides";
}

TEST(UndersideOf, OfASoleHasItsCornersAndStaysWithinIt) {
  Foot sole;
  sole.type = FootType::kSole;
  sole.sole_F = {{-0.06, -0.04}, {0.1, -0.03}, {0.1, 0.05}, {-0.06, 0.04}};
  const std::vector<Vector3> points = UndersideOf(sole);
  for (const Vector3& p : points) {
    EXPECT_EQ(p.z(), 0.0);
    EXPECT_GE(SignedDistance(sole.sole_F, p.head<2>()), -1e-12) << p.transpose();
  }
  const auto has = [&](const Vector2& q) {
    return std::any_of(points.begin(), points.end(),
                       [&](const Vector3& p) { return (p.head<2>() - q).norm() < 1e-12; });
  };
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(has(sole.sole_F[i]));
    EXPECT_TRUE(has(0.5 * (sole.sole_F[i] + sole.sole_F[(i + 1) % 4]))) << "the middle of an edge";
  }
  EXPECT_TRUE(has(0.25 * (sole.sole_F[0] + sole.sole_F[1] + sole.sole_F[2] + sole.sole_F[3])));
}

TEST(UndersideOf, OfAPointIsThatPoint) {
  const std::vector<Vector3> points = UndersideOf(Foot{});
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].norm(), 0.0);
}

TEST(ClearanceRamp, RisesFromNothingToAllAndFallsLikewise) {
  EXPECT_EQ(ClearanceRamp(0.0), 0.0);
  EXPECT_EQ(ClearanceRamp(1.0), 0.0);
  double last = 0.0;
  for (int k = 1; k <= 50; ++k) {
    const double u = 0.01 * k;
    EXPECT_NEAR(ClearanceRamp(u), ClearanceRamp(1.0 - u), 1e-12) << u;
    EXPECT_GE(ClearanceRamp(u), last) << u;
    last = ClearanceRamp(u);
    EXPECT_EQ(last > 1.0 - 1e-12, u > kClearanceEnds - 1e-12) << u;
  }
  EXPECT_NEAR(ClearanceRamp(0.5 * kClearanceEnds), 0.5, 1e-12);
}

TEST(ClearanceMargin, LowerGroundGivesAsMuchMore) {
  const SwingCurve curve = ForwardStep(0.2, 0.05);
  const double level = ClearanceMargin(curve, kTip, LevelAt(0.0), 0.02);
  for (const double change_m : {-0.03, 0.01, 0.4})
    EXPECT_NEAR(ClearanceMargin(curve, kTip, LevelAt(change_m), 0.02), level - change_m, 1e-12);
  EXPECT_EQ(ClearanceMargin(curve, kTip, LevelAt(kNoGround), 0.02), kInfinity);
}

TEST(ClearanceMargin, OfARidgeInMidSwingIsTheHeightAboveIt) {
  const SwingCurve curve = ForwardStep(0.2, 0.08);
  const GroundHeight ridge = [](const Vector2& p_W) { return std::abs(p_W.x() - 0.1) < 0.004 ? 0.05 : kNoGround; };
  // Halfway, the foot is 0.08 m high, 0.03 m above the ridge; 0.02 m are required.
  EXPECT_NEAR(ClearanceMargin(curve, kTip, ridge, 0.02), 0.01, 1e-3);
  EXPECT_LT(ClearanceMargin(curve, kTip, ridge, 0.04), 0.0);
}

TEST(ClearanceMargin, IsThatOfTheLowestPointOfTheUnderside) {
  const SwingCurve curve = ForwardStep(0.2, 0.05);
  const auto low = [](double z) { return std::vector<Vector3>{{0.0, 0.0, 0.0}, {0.02, 0.0, z}}; };
  const double tip = ClearanceMargin(curve, kTip, LevelAt(-0.1), 0.0);
  EXPECT_NEAR(ClearanceMargin(curve, low(-0.01), LevelAt(-0.1), 0.0), tip - 0.01, 1e-12);
  EXPECT_NEAR(ClearanceMargin(curve, low(0.01), LevelAt(-0.1), 0.0), tip, 1e-12);
}

TEST(ClearanceMargin, SeesWhereAFootRolls) {
  const SwingCurve curve = ForwardStep(0.2, 0.05);
  const SwingRoll lifted({Vector3(0.0, 0.0, 0.01), Vector3(0.0, 0.0, 0.01)});
  EXPECT_NEAR(ClearanceMargin(curve, kTip, LevelAt(0.0), 0.02, lifted),
              ClearanceMargin(curve, kTip, LevelAt(0.0), 0.02) + 0.01, 1e-12);
}

TEST(OutOfReach, IsTheLargestDistanceBeyondAnySide) {
  const SwingCurve curve = ForwardStep(0.4, 0.1);
  const ReachSide forward{Vector3::UnitX(), 0.1}, above{Vector3::UnitZ(), 0.08};
  EXPECT_EQ(OutOfReach(curve, {}), -kInfinity) << "nothing is asked";
  EXPECT_NEAR(OutOfReach(curve, {{1.0, {forward}}}), 0.3, 1e-12);
  EXPECT_NEAR(OutOfReach(curve, {{0.0, {forward}}}), -0.1, 1e-12);
  EXPECT_NEAR(OutOfReach(curve, {{0.5, {above}}}), 0.02, 1e-12);
  EXPECT_NEAR(OutOfReach(curve, {{0.0, {forward}}, {0.5, {forward, above}}}), 0.1, 1e-12);
  const SwingRoll back({Vector3(-0.05, 0.0, 0.0), Vector3(-0.05, 0.0, 0.0)});
  EXPECT_NEAR(OutOfReach(curve, {{1.0, {forward}}}, back), 0.25, 1e-12);
}

}  // namespace
}  // namespace gaitwright
