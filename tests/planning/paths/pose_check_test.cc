// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/pose_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "kinematics/base/result.h"
#include "kinematics/model/load_robot.h"
#include "planning/plan/terrain_scale.h"
#include "tests/planning/paths/walled_grounds.h"

namespace gaitwright {
namespace {

const RobotModel& RobotCalled(const char* name) {
  static const RobotModel a1 = *LoadNamedRobot("a1"), nao = *LoadNamedRobot("nao");
  return std::string(name) == "a1" ? a1 : nao;
}

/// The smallest and largest x and y of the robot's boxes.
Eigen::AlignedBox2d PlanOf(const BodySpace& space) {
  Eigen::AlignedBox2d plan;
  for (const Shape& box : space.boxes) {
    const Vector2 middle = box.X_BS.translation().head<2>(), half = 0.5 * box.size.head<2>();
    plan.extend(Vector2(middle - half));
    plan.extend(Vector2(middle + half));
  }
  return plan;
}

TEST(BodySpace, HoldsTheStandingFeetAndIsAsWideToBothSides) {
  for (const char* name : {"a1", "nao"}) {
    const BodySpace space = BodySpaceOf(RobotCalled(name), {});
    ASSERT_EQ(space.boxes.size(), 2u) << name;
    const Eigen::AlignedBox2d plan = PlanOf(space);
    for (const Vector2& foot : space.feet_G) EXPECT_TRUE(plan.contains(foot)) << name;
    EXPECT_NEAR(plan.min().y(), -plan.max().y(), 1e-12) << name;
    for (const Shape& box : space.boxes)
      EXPECT_GE(box.X_BS.translation().z() - 0.5 * box.size.z(), space.step_height_m - 1e-12) << name;
  }
}

TEST(BodySpace, ABodyThatSwaysOverOneOfTwoFeetIsGivenRoomForIt) {
  const RobotModel& nao = RobotCalled("nao");
  const BodySpaceOptions options;
  const BodySpace space = BodySpaceOf(nao, options);
  const double over_a_foot = 0.5 * (space.feet_G[0] - space.feet_G[1]).norm();
  ASSERT_GT(over_a_foot, 0.04);
  const double standing = 0.5 * ScaleOf(nao).body_width_m;
  EXPECT_NEAR(PlanOf(space).max().y(), standing + space.margin_m + options.sway * over_a_foot, 2e-3);
}

TEST(BodySpace, RefusesOptionsOutOfRange) {
  BodySpaceOptions options;
  options.margin = -0.1;
  EXPECT_THROW(BodySpaceOf(RobotCalled("a1"), options), InvalidArgument);
}

TEST(PoseCheck, AWallBlocksPosesFromWhereTheBodySpaceTouchesIt) {
  for (const char* name : {"a1", "nao"}) {
    const Eigen::AlignedBox2d plan = PlanOf(BodySpaceOf(RobotCalled(name), {}));
    const Terrain terrain = Walled({Wall("barrier", {1.0, -1.0}, {1.0, 1.0}, 0.1)});
    PoseCheck check(RobotCalled(name), terrain, {});
    const double face = 0.95;
    EXPECT_TRUE(check.IsFree({face - plan.max().x() - 1e-3, 0.0, 0.0})) << name;
    EXPECT_FALSE(check.IsFree({face - plan.max().x() + 1e-3, 0.0, 0.0})) << name;
    EXPECT_TRUE(check.IsFree({face + plan.min().x() - 1e-3, 0.0, std::numbers::pi})) << name;
    EXPECT_FALSE(check.IsFree({face + plan.min().x() + 1e-3, 0.0, std::numbers::pi})) << name;
    const auto why = check.ReasonRefused({1.0, 0.3, 0.0});
    ASSERT_TRUE(why.has_value());
    EXPECT_EQ(why->what, "barrier");
    EXPECT_NE(why->text.find("'barrier' blocks the robot at (1.00, 0.30)"), std::string::npos) << why->text;
    EXPECT_FALSE(check.ReasonRefused({}).has_value());
  }
}

TEST(PoseCheck, MotionsBetweenFreePosesAreCheckedThroughout) {
  const Terrain terrain = Walled({Wall("barrier", {1.0, -0.3}, {1.0, 0.3}, 0.01)});
  PoseCheck check(RobotCalled("a1"), terrain, {});
  EXPECT_TRUE(check.IsFree({2.0, 0.0, 0.0}));
  EXPECT_FALSE(check.IsFreeBetween({}, {2.0, 0.0, 0.0}));
  EXPECT_TRUE(check.IsFreeBetween({0.0, 1.0, 0.0}, {2.0, 1.0, 0.0}));
  EXPECT_FALSE(check.IsFreeAlong({{}, {0.0, 0.1, 0.0}, {2.0, 0.1, 0.0}}));
}

TEST(PoseCheck, WhatIsLowerThanAStepIsWalkedOnAndWhatIsHigherIsNot) {
  const BodySpace space = BodySpaceOf(RobotCalled("a1"), {});
  for (const double share : {0.8, 1.3}) {
    Terrain terrain = FlatTerrain();
    terrain.patches.push_back(Slab("block", {1.0, -1.0}, {3.0, 1.0}, share * space.step_height_m));
    PoseCheck check(RobotCalled("a1"), terrain, {});
    EXPECT_EQ(check.IsFreeBetween({}, {2.0, 0.0, 0.0}), share < 1.0) << share;
    EXPECT_TRUE(check.IsFree({2.0, 0.0, 0.0})) << "on top of it";
  }
}

TEST(PoseCheck, SlopesAreWalkedOnUntilTooSteepOrSlippery) {
  struct Case {
    double slope_deg, friction;
    bool free;
  };
  for (const Case& c : {Case{15.0, 0.8, true}, Case{29.0, 0.8, true}, Case{31.0, 0.8, false}, Case{15.0, 0.2, false}}) {
    Terrain terrain = FlatTerrain(c.friction);
    terrain.patches[0].name = "hill";
    terrain.patches[0].X_WT.linear() =
        Eigen::AngleAxisd(-c.slope_deg * std::numbers::pi / 180.0, Vector3::UnitY()).toRotationMatrix();
    for (const char* name : {"a1", "nao"}) {
      PoseCheck check(RobotCalled(name), terrain, {});
      for (const double yaw : {0.0, 0.8, 2.0}) {
        EXPECT_EQ(check.IsFree({0.3, 0.2, yaw}), c.free) << name << " " << c.slope_deg << " deg " << yaw;
      }
      if (c.free) continue;
      const auto why = check.ReasonRefused({});
      ASSERT_TRUE(why.has_value());
      EXPECT_NE(why->text.find("'hill' is too steep for foot"), std::string::npos) << why->text;
    }
  }
}

TEST(PoseCheck, AGapIsStoodOverOnlyWhereEachFootReachesGround) {
  for (const double gap : {0.1, 0.6}) {
    Terrain terrain;
    terrain.patches = {Slab("near", {-1.0, -1.0}, {1.0, 1.0}), Slab("far", {1.0 + gap, -1.0}, {3.0, 1.0})};
    PoseCheck check(RobotCalled("a1"), terrain, {});
    EXPECT_EQ(check.IsFreeBetween({0.5, 0.0, 0.0}, {2.3, 0.0, 0.0}), gap < 0.3) << gap;
    if (gap < 0.3) continue;
    const auto why = check.ReasonRefused({1.12, 0.0, 0.0});
    ASSERT_TRUE(why.has_value());
    EXPECT_EQ(why->what, "");
    EXPECT_NE(why->text.find("the gap from (1.00, "), std::string::npos) << why->text;
    EXPECT_NE(why->text.find("is 0.6"), std::string::npos) << why->text;
  }
}

TEST(PoseCheck, FeetFindNoPlaceUnderObstacles) {
  Terrain terrain = FlatTerrain();
  Obstacle carpet;  // lower than a step, so the body passes above
  carpet.name = "bed of nails";
  carpet.size_m = Vector3(1.0, 1.0, 0.04);
  carpet.X_WO.translation() = Vector3(1.0, 0.0, 0.02);
  terrain.obstacles = {carpet};
  PoseCheck check(RobotCalled("a1"), terrain, {});
  const auto why = check.ReasonRefused({1.0, 0.0, 0.0});
  ASSERT_TRUE(why.has_value());
  EXPECT_NE(why->text.find("has no free place large enough for foot"), std::string::npos) << why->text;
  EXPECT_TRUE(check.IsFree({1.0, 1.0, 0.0}));
}

TEST(PoseCheck, HeightFieldsAndPatchesOfTheSameGroundAgree) {
  Terrain patches;
  patches.patches = {Slab("low", {-2.0, -2.0}, {2.0, 2.0}), Slab("high", {0.3, -0.7}, {0.9, 0.9}, 0.3)};
  HeightField field;
  field.name = "field";
  field.origin_W = Vector2(-2.0, -2.0);
  field.resolution_m = 0.01;
  field.columns = field.rows = 401;
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      const double x = -2.0 + 0.01 * column, y = -2.0 + 0.01 * row;
      field.height_m.push_back(x > 0.295 && x < 0.905 && y > -0.705 && y < 0.905 ? 0.3 : 0.0);
    }
  }
  Terrain fields;
  fields.height_fields = {field};
  PoseCheck a(RobotCalled("a1"), patches, {}), b(RobotCalled("a1"), fields, {});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.4, 1.4), yaw(-3.1, 3.1);
  int free = 0, blocked = 0, differing = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const PlanarPose at{place(random), place(random), yaw(random)};
    const bool free_a = a.IsFree(at);
    (free_a ? free : blocked) += 1;
    if (free_a != b.IsFree(at)) ++differing;
  }
  EXPECT_GT(free, 50);
  EXPECT_GT(blocked, 50);
  EXPECT_LE(differing, 9) << "a cell of the field beside the edge";
}

/// The ground mirrored along x.
Terrain Mirrored(Terrain terrain) {
  for (Obstacle& obstacle : terrain.obstacles) {
    obstacle.X_WO.translation().y() *= -1.0;
    const double yaw = std::atan2(obstacle.X_WO.linear()(1, 0), obstacle.X_WO.linear()(0, 0));
    obstacle.X_WO.linear() = Eigen::AngleAxisd(-yaw, Vector3::UnitZ()).toRotationMatrix();
  }
  for (TerrainPatch& patch : terrain.patches) {
    if (patch.outline_T.empty()) continue;
    patch.X_WT.translation().y() *= -1.0;
    for (Vector2& corner : patch.outline_T) corner.y() *= -1.0;
    std::reverse(patch.outline_T.begin(), patch.outline_T.end());
  }
  return terrain;
}

TEST(PoseCheck, JudgesMirroredPosesAlike) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(-1.5, 1.5), yaw(-3.1, 3.1), height(0.0, 0.15);
  for (const char* name : {"a1", "nao"}) {
    Terrain terrain = Walled({Wall("a", {-1.0, -0.8}, {0.1, -0.9}), Wall("b", {0.9, 0.2}, {0.7, 1.3})});
    terrain.patches.clear();
    for (double x = -2.0; x < 2.0; x += 0.25) {
      for (double y = -2.0; y < 2.0; y += 0.25) {
        if (height(random) < 0.12)
          terrain.patches.push_back(Slab("stone", {x, y}, {x + 0.22, y + 0.22}, 0.3 * height(random)));
      }
    }
    const Terrain mirrored = Mirrored(terrain);
    PoseCheck here(RobotCalled(name), terrain, {}), there(RobotCalled(name), mirrored, {});
    int free = 0, blocked = 0;
    for (int trial = 0; trial < 500; ++trial) {
      const PlanarPose at{place(random), place(random), yaw(random)};
      const bool is_free = here.IsFree(at);
      (is_free ? free : blocked) += 1;
      EXPECT_EQ(is_free, there.IsFree({at.x_m, -at.y_m, -at.yaw_rad})) << name << " trial " << trial;
    }
    EXPECT_GT(free, 20) << name;
    EXPECT_GT(blocked, 20) << name;
  }
}

TEST(PoseCheck, AnswersDoNotDependOnWhatWasAskedBefore) {
  const Terrain terrain = Walled({Wall("a", {-1.0, -0.8}, {0.1, -0.9}), Wall("b", {0.9, 0.2}, {0.7, 1.3})});
  PoseCheck once(RobotCalled("a1"), terrain, {});
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-1.5, 1.5), yaw(-3.1, 3.1);
  for (int trial = 0; trial < 100; ++trial) {
    const PlanarPose at{place(random), place(random), yaw(random)};
    PoseCheck fresh(RobotCalled("a1"), terrain, {});
    EXPECT_EQ(once.IsFree(at), fresh.IsFree(at));
    EXPECT_EQ(once.IsFree(at), !once.ReasonRefused(at).has_value());
  }
}

}  // namespace
}  // namespace gaitwright
