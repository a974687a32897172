// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/smooth_route.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planning/paths/direct_route.h"
#include "tests/named_robot.h"
#include "tests/planning/paths/walled_grounds.h"

namespace gaitwright {
namespace {

const TravelWeights kSmoothWeights;

std::vector<PlanarPose> SmoothedOn(const Terrain& terrain, const std::vector<PlanarPose>& path) {
  PoseCheck check(NamedRobot("a1"), terrain, {});
  return SmoothRoute(check, path, kSmoothWeights);
}

/// A wall in front, and a path around its left end with right angles and constant heading.
Terrain SmoothWall() { return Walled({Wall("wall", {1.0, -2.0}, {1.0, 0.3})}); }
std::vector<PlanarPose> AroundTheWall() { return {{0.0, 0.0, 0.0}, {0.0, 1.6, 0.0}, {2.0, 1.6, 0.0}, {2.0, 0.0, 0.0}}; }

TEST(SmoothRoute, InTheOpenADetourBecomesADirectRoute) {
  const Terrain flat = FlatTerrain();
  const std::vector<PlanarPose> detour = {{0.0, 0.0, 0.0}, {1.0, 1.5, 0.0}, {2.0, -1.0, 0.0}, {3.0, 0.0, 0.0}};
  const std::vector<PlanarPose> smooth = SmoothedOn(flat, detour);
  EXPECT_EQ(smooth.front(), detour.front());
  EXPECT_EQ(smooth.back().x_m, 3.0);
  EXPECT_NEAR(LengthOf(smooth), 3.0, 0.03);
  EXPECT_NEAR(TravelCost(smooth, kSmoothWeights), 3.0, 0.05);
}

TEST(SmoothRoute, AStraightRouteStaysUnchanged) {
  const Terrain flat = FlatTerrain();
  for (const PlanarPose& pose : SmoothedOn(flat, {{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}})) {
    EXPECT_NEAR(pose.y_m, 0.0, 1e-9);
    EXPECT_NEAR(pose.yaw_rad, 0.0, 1e-9);
  }
}

TEST(SmoothRoute, AroundAWallIsCheaperAndFreeAllAlong) {
  const Terrain terrain = SmoothWall();
  const std::vector<PlanarPose> path = AroundTheWall(), smooth = SmoothedOn(terrain, path);
  EXPECT_LT(TravelCost(smooth, kSmoothWeights), 0.8 * TravelCost(path, kSmoothWeights));
  EXPECT_LT(LengthOf(smooth), LengthOf(path));
  EXPECT_GT(LengthOf(smooth), 2.0 * std::hypot(1.0, 0.3)) << "no shorter than a point's way around the end";
  PoseCheck check(NamedRobot("a1"), terrain, {});
  EXPECT_TRUE(check.IsFreeAlong(Densified(smooth, {0.02, 0.02})));
  EXPECT_EQ(smooth.front(), path.front());
  EXPECT_EQ(smooth.back().x_m, path.back().x_m);
  EXPECT_EQ(smooth.back().y_m, path.back().y_m);
}

TEST(SmoothRoute, NeverCostsMoreAndTwiceGainsHardlyAnything) {
  const Terrain terrain = SmoothWall();
  const std::vector<PlanarPose> once = SmoothedOn(terrain, AroundTheWall()), twice = SmoothedOn(terrain, once);
  EXPECT_LE(TravelCost(twice, kSmoothWeights), TravelCost(once, kSmoothWeights) * (1.0 + 1e-9));
  EXPECT_GT(TravelCost(twice, kSmoothWeights), 0.9 * TravelCost(once, kSmoothWeights));
}

TEST(SmoothRoute, GivesTheSameAgain) {
  const Terrain terrain = SmoothWall();
  EXPECT_EQ(SmoothedOn(terrain, AroundTheWall()), SmoothedOn(terrain, AroundTheWall()));
}

TEST(SmoothRoute, DearSideStepsAreReplacedByTurning) {
  const Terrain flat = FlatTerrain();
  const std::vector<PlanarPose> smooth = SmoothedOn(flat, {{0.0, 0.0, 0.0}, {0.0, 3.0, 0.0}});
  EXPECT_LT(TravelCost(smooth, kSmoothWeights), 3.0 + 3.2 * kSmoothWeights.turn_m_rad + 0.2);
  double turned = 0.0;
  for (const PlanarPose& pose : smooth) turned = std::max(turned, std::abs(pose.yaw_rad));
  EXPECT_GT(turned, 1.2) << "it faces the way";
}

}  // namespace
}  // namespace gaitwright
