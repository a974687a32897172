// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/ground_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "tests/named_robot.h"

namespace gaitwright {
namespace {

GroundLimits LimitsOf(const RobotModel& model, double foot_m, double body_m = 0.0) {
  return {std::vector<double>(model.feet.size(), foot_m), body_m};
}

/// The standing configuration with its base moved.
VectorX StandingMoved(const RobotModel& model, const Vector3& by) {
  VectorX q = StandingConfiguration(model);
  q.head<3>() += by;
  return q;
}

std::vector<GroundHit> HitsAt(GroundWatch& watch, const RobotModel& model, const VectorX& q,
                              const GroundLimits& limits) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  return watch.Look(scratch, limits);
}

Terrain WithPost(const Vector3& middle_W, const Vector3& size_m) {
  Terrain terrain = FlatTerrain();
  Obstacle post;
  post.name = "post";
  post.X_WO.translation() = middle_W;
  post.size_m = size_m;
  terrain.obstacles = {post};
  return terrain;
}

class GroundWatchTest : public testing::TestWithParam<const char*> {};

TEST_P(GroundWatchTest, AStandingRobotHitsNothing) {
  const RobotModel& model = NamedRobot(GetParam());
  GroundWatch watch(model, FlatTerrain());
  EXPECT_GE(watch.num_parts(), static_cast<int>(model.feet.size()));
  EXPECT_TRUE(HitsAt(watch, model, StandingMoved(model, Vector3::Zero()), LimitsOf(model, -1e-3)).empty());
}

TEST_P(GroundWatchTest, SunkFeetAreAsDeepAsTheRobotIsLower) {
  const RobotModel& model = NamedRobot(GetParam());
  GroundWatch watch(model, FlatTerrain());
  const auto hits = HitsAt(watch, model, StandingMoved(model, {0.0, 0.0, -0.01}), LimitsOf(model, -1e-3, -1.0));
  std::set<int> feet;
  for (const GroundHit& hit : hits) {
    ASSERT_GE(hit.foot, 0);
    feet.insert(hit.foot);
    EXPECT_LT(hit.distance_m, -0.008);
    EXPECT_GT(hit.distance_m, -0.015);
    EXPECT_EQ(hit.body, model.feet[static_cast<std::size_t>(hit.foot)].body);
  }
  EXPECT_EQ(feet.size(), model.legs.size());
}

TEST_P(GroundWatchTest, APostThroughTheBodyIsNamedByTheLinksThatItMeets) {
  const RobotModel& model = NamedRobot(GetParam());
  const double height = model.standing_base_height_m;
  GroundWatch watch(model, WithPost({0.0, 0.0, height}, {0.02, 0.02, 0.1}));
  const auto hits = HitsAt(watch, model, StandingMoved(model, Vector3::Zero()), LimitsOf(model, -1e-3));
  ASSERT_FALSE(hits.empty());
  for (const GroundHit& hit : hits) {
    EXPECT_EQ(hit.foot, -1);
    EXPECT_LT(hit.distance_m, 0.0);
    ASSERT_NE(hit.link, nullptr);
    EXPECT_FALSE(hit.link->empty());
  }
  EXPECT_TRUE(HitsAt(watch, model, StandingMoved(model, {5.0, 0.0, 0.0}), LimitsOf(model, -1e-3)).empty());
}

TEST_P(GroundWatchTest, WhatItLookedAtBeforeDoesNotMatter) {
  const RobotModel& model = NamedRobot(GetParam());
  const Terrain terrain = WithPost({0.4, 0.05, 0.3}, {0.1, 0.1, 0.6});
  GroundWatch used(model, terrain);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> draw(-0.3, 0.5), rise(-0.02, 0.02);
  int found = 0;
  for (int k = 0; k < 40; ++k) {
    const VectorX q = StandingMoved(model, {draw(random), 0.3 * draw(random), rise(random)});
    const auto hits = HitsAt(used, model, q, LimitsOf(model, -1e-3));
    GroundWatch fresh(model, terrain);
    const auto expected = HitsAt(fresh, model, q, LimitsOf(model, -1e-3));
    ASSERT_EQ(hits.size(), expected.size()) << k;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      EXPECT_EQ(hits[i].part, expected[i].part);
      EXPECT_NEAR(hits[i].distance_m, expected[i].distance_m, 1e-9);
    }
    found += static_cast<int>(hits.size());
  }
  EXPECT_GT(found, 5);
}

TEST_P(GroundWatchTest, TheExitDirectionFromLevelGroundIsUp) {
  const RobotModel& model = NamedRobot(GetParam());
  GroundWatch watch(model, FlatTerrain());
  const auto hits = HitsAt(watch, model, StandingMoved(model, {0.0, 0.0, -0.01}), LimitsOf(model, -1e-3, -1.0));
  ASSERT_FALSE(hits.empty());
  const ExitPlane out = watch.ExitPlaneOf(hits.front());
  EXPECT_LT((out.normal_W - Vector3::UnitZ()).norm(), 1e-3);
  EXPECT_LT(out.p_W.z(), -0.008) << "its lowest point";
}

TEST_P(GroundWatchTest, AFootIsAsNearAsItIsHigh) {
  const RobotModel& model = NamedRobot(GetParam());
  const GroundWatch watch(model, FlatTerrain());
  for (const double height_m : {0.03, 0.001, -0.004}) {
    Pose X_WF = Pose::Identity();
    X_WF.translation() = Vector3(0.3, -0.2, height_m + model.feet[0].radius);
    const NearestSolid nearest = watch.NearestToFoot(0, X_WF, 0.1);
    EXPECT_GE(nearest.solid, 0);
    EXPECT_NEAR(nearest.distance_m, height_m, 1e-4) << height_m;
    EXPECT_EQ(watch.NearestToFoot(0, X_WF, 0.5 * height_m).solid >= 0, height_m <= 0.0) << "none within half of it";
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, GroundWatchTest, testing::Values("a1", "nao"));

TEST(GroundWatch, APointsDistanceIsThatToTheNearestSolidWithinATenth) {
  const GroundWatch watch(NamedRobot("a1"), WithPost({1.0, 0.0, 0.5}, {0.2, 0.2, 1.0}));
  EXPECT_NEAR(watch.PointDistance({0.0, 0.0, 0.05}), 0.05, 1e-4);
  EXPECT_NEAR(watch.PointDistance({0.0, 0.0, -0.03}), -0.03, 1e-3);
  EXPECT_NEAR(watch.PointDistance({0.87, 0.0, 0.5}), 0.03, 1e-4) << "beside the post";
  EXPECT_EQ(watch.PointDistance({0.0, 0.0, 0.7}), 0.1);
}

TEST(GroundWatch, LimitsSayHowNearIsTooNear) {
  const RobotModel& a1 = NamedRobot("a1");
  GroundWatch watch(a1, FlatTerrain());
  const VectorX high = StandingMoved(a1, {0.0, 0.0, 0.03});
  EXPECT_TRUE(HitsAt(watch, a1, high, LimitsOf(a1, 0.02, -1.0)).empty());
  EXPECT_EQ(HitsAt(watch, a1, high, LimitsOf(a1, 0.04, -1.0)).size(), 4U);
  GroundLimits one = LimitsOf(a1, 0.02, -1.0);
  one.foot_m[2] = 0.04;
  const auto hits = HitsAt(watch, a1, high, one);
  ASSERT_EQ(hits.size(), 1U);
  EXPECT_EQ(hits[0].foot, 2);
  EXPECT_NEAR(hits[0].distance_m, 0.03, 1e-3);
}

}  // namespace
}  // namespace gaitwright
