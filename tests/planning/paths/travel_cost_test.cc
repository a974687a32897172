// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/travel_cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "planning/paths/direct_route.h"

namespace gaitwright {
namespace {

const TravelWeights kWeights{2.5, 1.5, 0.25};

PlanarPose RandomPose(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-2.0, 2.0), yaw(-std::numbers::pi, std::numbers::pi);
  return {place(random), place(random), yaw(random)};
}

TEST(TravelCost, IsTheWeightOfEachDirectionByItself) {
  const double yaw = 0.7, c = std::cos(yaw), s = std::sin(yaw);
  const PlanarPose at{1.0, -2.0, yaw};
  EXPECT_NEAR(TravelCost(at, {1.0 + 3.0 * c, -2.0 + 3.0 * s, yaw}, kWeights), 3.0, 1e-12);
  EXPECT_NEAR(TravelCost(at, {1.0 - 3.0 * c, -2.0 - 3.0 * s, yaw}, kWeights), 4.5, 1e-12);
  EXPECT_NEAR(TravelCost(at, {1.0 - 3.0 * s, -2.0 + 3.0 * c, yaw}, kWeights), 7.5, 1e-12);
  EXPECT_NEAR(TravelCost(at, {1.0, -2.0, yaw - 2.0}, kWeights), 0.5, 1e-12);
}

TEST(TravelCost, AgreesWithAFineSumAndIsNoLessThanTheDistance) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const PlanarPose a = RandomPose(random), b = RandomPose(random);
    double sum = 0.0;
    constexpr int kParts = 4000;
    for (int k = 0; k < kParts; ++k)
      sum += TravelCost(Between(a, b, k / double{kParts}), Between(a, b, (k + 1) / double{kParts}), kWeights);
    const double cost = TravelCost(a, b, kWeights);
    EXPECT_NEAR(cost, sum, 0.01 * sum) << "trial " << trial;
    EXPECT_GE(cost, 0.99 * std::hypot(b.x_m - a.x_m, b.y_m - a.y_m));
  }
}

TEST(TravelCost, IsTheSameForAMirroredPath) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 50; ++trial) {
    const PlanarPose a = RandomPose(random), b = RandomPose(random);
    const PlanarPose am{a.x_m, -a.y_m, -a.yaw_rad}, bm{b.x_m, -b.y_m, -b.yaw_rad};
    EXPECT_NEAR(TravelCost(a, b, kWeights), TravelCost(am, bm, kWeights), 1e-12);
  }
}

TEST(DirectRoute, CostsWhatItsWaypointsDo) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const PlanarPose a = RandomPose(random), b = RandomPose(random);
    for (const DirectRoute kind : kDirectRoutes) {
      const double along = TravelCost(WaypointsOf(kind, a, b, {0.002, 0.002}), kWeights);
      EXPECT_NEAR(CostOf(kind, a, b, kWeights), along, 0.01 * along) << "kind " << static_cast<int>(kind);
    }
  }
}

TEST(DirectRoute, LeadsFromEndToEndWithoutGaps) {
  std::mt19937 random(6);
  const Spacing spacing{0.05, 0.1};
  for (int trial = 0; trial < 100; ++trial) {
    const PlanarPose a = RandomPose(random), b = RandomPose(random);
    for (const DirectRoute kind : kDirectRoutes) {
      const std::vector<PlanarPose> waypoints = WaypointsOf(kind, a, b, spacing);
      EXPECT_EQ(waypoints.front(), a);
      EXPECT_EQ(waypoints.back().x_m, b.x_m);
      EXPECT_EQ(waypoints.back().y_m, b.y_m);
      EXPECT_NEAR(std::remainder(waypoints.back().yaw_rad - b.yaw_rad, 2.0 * std::numbers::pi), 0.0, 1e-12);
      for (std::size_t i = 1; i < waypoints.size(); ++i) {
        EXPECT_LE(std::hypot(waypoints[i].x_m - waypoints[i - 1].x_m, waypoints[i].y_m - waypoints[i - 1].y_m),
                  spacing.distance_m + 1e-9);
        EXPECT_LE(std::abs(waypoints[i].yaw_rad - waypoints[i - 1].yaw_rad), spacing.turn_rad + 1e-9);
      }
    }
  }
}

TEST(DirectRoute, ForwardFacesTheGoalAndStraightBackIsBackward) {
  const std::vector<PlanarPose> waypoints = WaypointsOf(DirectRoute::kForward, {}, {0.0, 2.0, 0.0}, {0.05, 0.1});
  EXPECT_NEAR(waypoints[waypoints.size() / 2].yaw_rad, 0.5 * std::numbers::pi, 1e-12);
  EXPECT_EQ(ByCost({}, {0.0, 5.0, 0.0}, kWeights).front().second, DirectRoute::kForward);
  EXPECT_NEAR(ByCost({}, {-1.0, 0.0, 0.0}, kWeights).front().first, 1.5, 1e-9);
}

}  // namespace
}  // namespace gaitwright
