// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/foothold_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "grounds.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/stability/polygon.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {
namespace {

struct Ground {
  Ground(const char* robot, Terrain the_terrain, const FootholdOptions& options = {})
      : model(LoadNamedRobot(robot).value()),
        terrain(std::move(the_terrain)),
        index(terrain, 0.2),
        checker(model, index, options) {}
  Ground(const Ground&) = delete;

  FootholdFault At(double x, double y = 0.0, double yaw = 0.0) const { return checker.Place(0, {x, y, yaw}).fault; }

  RobotModel model;
  Terrain terrain;
  GroundIndex index;
  FootholdChecker checker;
};

TEST(GroundIndex, AnswersAsTheTerrainItself) {
  for (const Terrain& terrain : {Stones(0.5, 2.0, 0.1, 0.13, 0.02, 1.0, 0.03, 3), RampUp(0.5, 1.0, 0.3),
                                 Rough(-1.0, 2.0, 0.03, 0.3, 5), WallWithOpening(1.0, 0.5, 1.0)}) {
    const GroundIndex index(terrain, 0.2);
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> x(-2.0, 3.0), y(-1.0, 1.0);
    int on = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vector2 p(x(engine), y(engine));
      const GroundPoint a = index.At(p), b = GroundAt(terrain, p);
      ASSERT_EQ(a.patch, b.patch) << terrain.name << " at " << p.transpose();
      EXPECT_NEAR(a.height_m, b.height_m, 1e-12);
      EXPECT_LT((a.normal_W - b.normal_W).norm(), 1e-12);
      on += a.patch >= 0 ? 1 : 0;
      if (a.patch >= 0) {
        EXPECT_LE(a.height_m, index.HighestIn(p, p) + 1e-12);
      }
    }
    EXPECT_GT(on, 300) << terrain.name;
  }
}

TEST(FootholdCheck, ASphereKeepsItsRadiusAndTheMarginFromAnEdge) {
  const Ground ground("a1", Gap(1.0, 0.5));
  const double clear = ground.model.feet[0].radius + 0.005;
  EXPECT_EQ(ground.At(1.0 - clear - 1e-6), FootholdFault::kNone);
  EXPECT_EQ(ground.At(1.0 - clear + 1e-6), FootholdFault::kEdge);
  EXPECT_EQ(ground.At(1.2), FootholdFault::kNoGround);
  EXPECT_EQ(ground.At(1.5 + clear + 1e-6), FootholdFault::kNone);
}

TEST(FootholdCheck, ASphereKeepsWhatItRollsFromARiserBelowAndItsRadiusFromTheEdgeAbove) {
  const Ground ground("a1", StepUp(1.0, 0.1));
  const double clear = ground.model.feet[0].radius + 0.005, rolls = 0.5 * ground.model.feet[0].radius;
  EXPECT_EQ(ground.At(1.0 - clear - rolls - 1e-6), FootholdFault::kNone);
  EXPECT_EQ(ground.At(1.0 - clear - rolls + 1e-6), FootholdFault::kRiser);
  EXPECT_EQ(ground.At(1.0 + clear + 1e-6), FootholdFault::kNone);
  EXPECT_EQ(ground.At(1.0 + 0.5 * clear), FootholdFault::kEdge);
}

TEST(FootholdCheck, GroundThatGoesOnIsNoEdge) {
  const Ground ground("a1", RampUp(1.0, 1.0, 0.2));
  for (const double x : {0.999, 1.001, 1.999, 2.001}) EXPECT_EQ(ground.At(x), FootholdFault::kNone) << x;
}

TEST(FootholdCheck, SlopesAreLimitedAndTheFrameStandsOnThem) {
  const Ground steep("a1", RampUp(1.0, 2.0, 0.6));
  EXPECT_EQ(steep.At(2.0), FootholdFault::kSlope);
  for (const char* robot : {"a1", "nao"}) {
    const Ground ground(robot, RampUp(1.0, 2.0, 0.25));
    const Placing placing = ground.checker.Place(0, {2.0, 0.1, 0.4});
    ASSERT_TRUE(placing.ok());
    const Pose& X_WF = placing.placed.X_WF;
    EXPECT_LT((X_WF.linear().col(2) - Vector3(-std::sin(0.25), 0.0, std::cos(0.25))).norm(), 1e-12);
    EXPECT_NEAR(std::atan2(X_WF.linear()(1, 0), X_WF.linear()(0, 0)), 0.4, 1e-12);
    EXPECT_NEAR(X_WF.linear().determinant(), 1.0, 1e-12);
    EXPECT_NEAR(X_WF.translation().z(), std::tan(0.25), 1e-12);
  }
}

TEST(FootholdCheck, ASoleMayOverhangBySoMuch) {
  const Ground ground("nao", Gap(1.0, 0.5));
  const double half = ground.model.feet[0].sole_F[1].x();
  // On the surface by the margin: from the heel to 1.0 - 0.005, 60 % of the length.
  const double last = 1.0 - 0.005 - 0.6 * 2.0 * half + half;
  EXPECT_EQ(ground.At(last - 1e-6), FootholdFault::kNone);
  EXPECT_EQ(ground.At(last + 1e-6), FootholdFault::kEdge);
  const Placing placing = ground.checker.Place(0, {last - 1e-6, 0.0, 0.0});
  const Foothold foothold{0, placing.placed.X_WF, Vector3::Zero(), placing.placed.surface, 0.0, 1.0};
  const Foot& foot = ground.model.feet[0];
  EXPECT_NEAR(Area(SupportOf(foot, foothold, ground.terrain)) / Area(foot.sole_F), 0.6, 1e-4);
}

TEST(FootholdCheck, ASoleIsNeverInARiserAndStandsOnTheHigherGround) {
  const Ground ground("nao", StepUp(1.0, 0.02));
  const double half = ground.model.feet[0].sole_F[1].x();
  EXPECT_EQ(ground.At(1.0 - half - 0.005 - 1e-6), FootholdFault::kNone);
  EXPECT_NE(ground.At(1.0 - half - 0.005 + 1e-6), FootholdFault::kNone);
  const Placing above = ground.checker.Place(0, {1.0 + 0.7 * half, 0.0, 0.0});
  ASSERT_TRUE(above.ok());
  EXPECT_NEAR(above.placed.X_WF.translation().z(), 0.02, 1e-12);
  EXPECT_GT(above.placed.risk, 0.0);
}

TEST(FootholdCheck, OnAHeightFieldASoleRestsOnTopOfAllThatIsUnderIt) {
  const Ground ground("nao", Rough(-1.0, 2.0, 0.005, 0.2, 4));
  const Foot& foot = ground.model.feet[0];
  int stood = 0;
  for (double x = -0.5; x < 1.5; x += 0.05) {
    const Placing placing = ground.checker.Place(0, {x, 0.1, 0.5 * x});
    if (!placing.ok()) continue;
    ++stood;
    double least = 1.0;
    for (int i = 0; i <= 20; ++i) {
      for (int k = 0; k <= 20; ++k) {
        const Vector2 q_F = foot.sole_F[0] + Vector2(i, k).cwiseProduct(foot.sole_F[2] - foot.sole_F[0]) / 20.0;
        const Vector3 q_W = placing.placed.X_WF * Vector3(q_F.x(), q_F.y(), 0.0);
        least = std::min(least, q_W.z() - GroundAt(ground.terrain, q_W.head<2>()).height_m);
      }
    }
    EXPECT_GT(least, -5e-4) << x;  // between the sampled places
    EXPECT_LT(least, 1e-3) << x;
    Foothold foothold;
    foothold.X_WF = placing.placed.X_WF;
    foothold.patch = placing.placed.surface;
    EXPECT_GE(Area(SupportOf(foot, foothold, ground.terrain)), 0.6 * Area(foot.sole_F)) << x;
  }
  EXPECT_GT(stood, 12);
}

TEST(FootholdCheck, ASoleRestsInTheCornerWhereASlopeBegins) {
  constexpr double kSlope = 0.1, kEdge = 0.5;
  const Ground ground("nao", RampUp(kEdge, 2.0, kSlope));
  const Foot& foot = ground.model.feet[0];
  int across = 0;
  for (double x = kEdge - 0.2; x < kEdge + 0.2; x += 0.005) {
    const Placing placing = ground.checker.Place(0, {x, 0.1, 0.0});
    ASSERT_TRUE(placing.ok()) << x;
    const double tilt = std::asin(-placing.placed.X_WF.linear()(0, 2));
    EXPECT_GT(tilt, -1e-9);
    EXPECT_LT(tilt, kSlope + 1e-9);
    Foothold foothold;
    foothold.X_WF = placing.placed.X_WF;
    foothold.patch = placing.placed.surface;
    EXPECT_GT(Area(SupportOf(foot, foothold, ground.terrain)), 0.85 * Area(foot.sole_F)) << x;
    across += tilt > 1e-3 && tilt < kSlope - 1e-3 ? 1 : 0;
    for (const Vector2& corner : foot.sole_F) {
      const Vector3 p_W = placing.placed.X_WF * Vector3(corner.x(), corner.y(), 0.0);
      EXPECT_NEAR(p_W.z(), GroundAt(ground.terrain, p_W.head<2>()).height_m, 1.1e-3) << x;
    }
  }
  EXPECT_GT(across, 10);
}

TEST(FootholdCheck, ASoleDoesNotRestAcrossAStepOrAnEdgeThatFalls) {
  const Ground step("nao", StepUp(0.5, 0.02));
  for (double x = 0.4; x < 0.6; x += 0.0005) {
    const Placing placing = step.checker.Place(0, {x, 0.1, 0.0});
    EXPECT_TRUE(!placing.ok() || placing.placed.X_WF.linear()(2, 2) == 1.0) << x;
  }
  const Ground ridge("nao", RampUp(-1.0, 1.5, 0.1));  // level from 0.5 on
  for (double x = 0.4; x < 0.6; x += 0.005) {
    const Placing placing = ridge.checker.Place(0, {x, 0.1, 0.0});
    if (!placing.ok()) continue;
    const double tilt = std::asin(-placing.placed.X_WF.linear()(0, 2));
    EXPECT_LT(std::min(std::abs(tilt), std::abs(tilt - 0.1)), 1e-6) << "on one or the other, at " << x;
  }
}

TEST(FootholdCheck, ASoleLiesNeitherAcrossAGapNorAgainstAStepThatItMayMiss) {
  constexpr double kStep = 0.001, kEdge = 0.53;
  Terrain terrain = Gap(0.5, kEdge - 0.5);
  terrain.patches[1].X_WT.translation().z() += kStep;
  const Ground ground("nao", terrain);
  const Polygon& sole_F = ground.model.feet[0].sole_F;
  double toe = 0.0;
  for (const Vector2& corner : sole_F) toe = std::max(toe, corner.x());
  int below = 0, above = 0;
  for (double x = 0.3; x < 0.7; x += 0.0005) {
    const Placing placing = ground.checker.Place(0, {x, 0.1, 0.0});
    if (!placing.ok()) continue;
    EXPECT_EQ(placing.placed.X_WF.linear()(2, 2), 1.0) << x;
    const bool on_step = placing.placed.X_WF.translation().z() > 0.5 * kStep;
    EXPECT_TRUE(on_step || x + toe < kEdge - 0.0025) << x << ": its toe might come down on the step";
    ++(on_step ? above : below);
  }
  EXPECT_GT(below, 20);
  EXPECT_GT(above, 20);
}

TEST(FootholdCheck, ObstaclesKeepFeetAwayUpToHalfALeg) {
  Terrain terrain = WallWithOpening(1.0, 0.2, 1.0);
  const Ground walls("a1", terrain);
  EXPECT_EQ(walls.At(1.0, 0.5), FootholdFault::kObstacle);
  EXPECT_EQ(walls.At(1.0, 0.0), FootholdFault::kNone);
  for (Obstacle& wall : terrain.obstacles) wall.X_WO.translation().z() += 0.5;
  const Ground lintels("a1", terrain);
  EXPECT_EQ(lintels.At(1.0, 0.5), FootholdFault::kNone);
}

TEST(FootholdCheck, SmallStonesAreHit) {
  for (const char* robot : {"a1", "nao"}) {
    const double stone = robot[0] == 'a' ? 0.06 : 0.17;
    const Ground ground(robot, Stones(0.5, 3.0, stone, 1.5 * stone, 0.01, 2.0, 0.01, 2));
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> x(0.8, 2.6), y(-0.5, 0.5);
    for (int i = 0; i < 100; ++i) {
      std::vector<PlanarPose> places;
      ground.checker.Near(0, {x(engine), y(engine), 0.0}, 1.5 * stone, places);
      int good = 0;
      for (const PlanarPose& place : places) good += ground.checker.Place(0, place).ok() ? 1 : 0;
      EXPECT_GE(good, 1) << robot << " " << i;
    }
  }
}

TEST(FootholdCheck, RefusesOptionsOutOfRange) {
  FootholdOptions options;
  options.least_on = 1.5;
  EXPECT_THROW(Ground("a1", FlatTerrain(), options), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
