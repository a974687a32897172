// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/time_route.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kinematics/base/result.h"
#include "planning/paths/base_path.h"
#include "planning/paths/direct_route.h"

namespace gaitwright {
namespace {

const RouteTiming kTiming{0.5, 0.2, 0.8, 0.6, 1.0, 0.0};

/// Fastest motion of the body between samples, in its own frame.
PlanarTwist Fastest(const BasePath& path) {
  PlanarTwist most;
  for (std::size_t i = 1; i < path.time_s.size(); ++i) {
    const PlanarPose &a = path.pose[i - 1], &b = path.pose[i];
    const double step = path.time_s[i] - path.time_s[i - 1], yaw = 0.5 * (a.yaw_rad + b.yaw_rad);
    const double c = std::cos(yaw), s = std::sin(yaw), dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
    most.x_m = std::max(most.x_m, std::abs(c * dx + s * dy) / step);
    most.y_m = std::max(most.y_m, std::abs(c * dy - s * dx) / step);
    most.yaw_rad = std::max(most.yaw_rad, std::abs(b.yaw_rad - a.yaw_rad) / step);
  }
  return most;
}

/// An L: forward, a turn on the spot, forward, and sideways.
std::vector<PlanarPose> Corners() {
  const double left = 0.5 * std::numbers::pi;
  return Densified({{}, {1.0, 0.0, 0.0}, {1.0, 0.0, left}, {1.0, 1.0, left}, {0.5, 1.0, left}}, {0.05, 0.1});
}

TEST(TimeRoute, AStraightRouteTakesItsLengthAtFullSpeedAndARamp) {
  const std::vector<PlanarPose> waypoints = {{}, {2.0, 0.0, 0.0}};
  EXPECT_NEAR(RouteDuration(waypoints, kTiming), 2.0 / 0.5 + kTiming.ramp_s, 0.03);
  const BasePath path = TimeRoute(waypoints, kTiming);
  EXPECT_NEAR(path.time_s.back(), kTiming.start_s + RouteDuration(waypoints, kTiming), 1e-9);
  EXPECT_NEAR(PoseAt(path, kTiming.start_s + 0.5 * (2.0 / 0.5 + kTiming.ramp_s)).x_m, 1.0, 0.01);
  EXPECT_EQ(PoseAt(path, 0.5 * kTiming.start_s), PlanarPose{});
  EXPECT_NEAR(Fastest(path).x_m, 0.5, 1e-9);
}

TEST(TimeRoute, KeepsTheSpeedsOnEveryRoute) {
  for (const DirectRoute kind : kDirectRoutes) {
    const auto waypoints = WaypointsOf(kind, {}, {1.5, -1.0, 2.0}, {0.05, 0.1});
    const PlanarTwist most = Fastest(TimeRoute(waypoints, kTiming));
    EXPECT_LE(most.x_m, 0.5 * (1.0 + 1e-6));
    EXPECT_LE(most.y_m, 0.2 * (1.0 + 1e-6));
    EXPECT_LE(most.yaw_rad, 0.8 * (1.0 + 1e-6));
    EXPECT_GT(std::max({most.x_m / 0.5, most.y_m / 0.2, most.yaw_rad / 0.8}), 0.95) << "slower than need be";
  }
}

TEST(TimeRoute, StartsAndEndsAtRestSmoothly) {
  const BasePath path = TimeRoute(Corners(), kTiming);
  const double end = path.time_s.back(), start = kTiming.start_s;
  EXPECT_EQ(path.pose.back(), Corners().back());
  const auto moved = [&](double from, double to) {
    const PlanarPose a = PoseAt(path, from), b = PoseAt(path, to);
    return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
  };
  EXPECT_LT(moved(start, start + 0.05), 0.1 * 0.5 * 0.05);
  EXPECT_LT(moved(end - 0.05, end), 0.1 * 0.2 * 0.05);
}

TEST(TimeRoute, IsOnTheRouteAndTurnsBackNowhere) {
  const std::vector<PlanarPose> waypoints = Corners();
  const BasePath path = TimeRoute(waypoints, kTiming);
  std::size_t i = 0;
  for (const PlanarPose& at : path.pose) {
    double nearest = 1e9;
    for (std::size_t j = i; j + 1 < waypoints.size(); ++j) {
      for (int k = 0; k <= 100; ++k) {
        const PlanarPose on = Between(waypoints[j], waypoints[j + 1], k / 100.0);
        const double off = std::hypot(on.x_m - at.x_m, on.y_m - at.y_m, on.yaw_rad - at.yaw_rad);
        if (off < nearest - 1e-6) {
          nearest = off;
          i = j;
        }
      }
    }
    EXPECT_LT(nearest, 1e-3);
  }
}

TEST(TimeRoute, SlowsWhereTheMotionChangesItsDirection) {
  const BasePath path = TimeRoute(Corners(), kTiming);
  double slowest = 1e9;
  for (std::size_t i = 1; i < path.time_s.size(); ++i) {
    const double x = 0.5 * (path.pose[i].x_m + path.pose[i - 1].x_m);
    if (path.pose[i].yaw_rad > 0.0 || x < 0.99) continue;
    slowest = std::min(slowest, (path.pose[i].x_m - path.pose[i - 1].x_m) / (path.time_s[i] - path.time_s[i - 1]));
  }
  EXPECT_LT(slowest, 0.5 * 0.5) << "at the end of the first part";
  EXPECT_GT(slowest, 0.0);
}

TEST(TimeRoute, StandsOnUntilTheEndAskedFor) {
  RouteTiming timing = kTiming;
  timing.end_s = 30.0;
  const BasePath path = TimeRoute(Corners(), timing);
  EXPECT_EQ(path.time_s.back(), 30.0);
  EXPECT_EQ(PoseAt(path, 29.0), Corners().back());
  EXPECT_EQ(TimeRoute({PlanarPose{1.0, 2.0, 3.0}}, timing).pose.back(), (PlanarPose{1.0, 2.0, 3.0}));
}

TEST(TimeRoute, RefusesSpeedsThatLeadNowhere) {
  RouteTiming timing = kTiming;
  timing.lateral_speed_m_s = 0.0;
  EXPECT_THROW(TimeRoute(Corners(), timing), InvalidArgument);
  EXPECT_THROW(TimeRoute({}, kTiming), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
