// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/terrain_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

Shape Ball(double radius_m) {
  Shape ball;
  ball.type = ShapeType::kSphere;
  ball.size.x() = radius_m;
  return ball;
}

Pose At(double x, double y, double z) {
  Pose X_WS = Pose::Identity();
  X_WS.translation() = Vector3(x, y, z);
  return X_WS;
}

/// Treads of 0.25 m by 1 m that rise by 0.07 m, the second without a name.
Terrain Stairs() {
  Terrain terrain;
  for (int i = 0; i < 3; ++i) {
    TerrainPatch tread;
    if (i != 1) tread.name = i == 0 ? "first" : "last";
    tread.X_WT.translation() = Vector3(0.25 * i, 0.0, 0.07 * i);
    tread.outline_T = {{0.0, -0.5}, {0.25, -0.5}, {0.25, 0.5}, {0.0, 0.5}};
    terrain.patches.push_back(tread);
  }
  return terrain;
}

TEST(SolidsOf, ABallIsAsFarFromTreadsAndRisersAsItIs) {
  const ShapeScene solids = SolidsOf(Stairs());
  const PreparedShape ball(Ball(0.02));
  const NearestSolid over = solids.Nearest(ball, At(0.1, 0.0, 0.03), 0.1);
  EXPECT_NEAR(over.distance_m, 0.01, 2e-5);
  EXPECT_EQ(solids.SolidName(over.solid), "first");
  const NearestSolid before = solids.Nearest(ball, At(0.222, 0.0, 0.04), 0.1);
  EXPECT_NEAR(before.distance_m, 0.008, 2e-5) << "the riser, though no ground under it is near";
  EXPECT_EQ(solids.SolidName(before.solid), "patch 1");
  EXPECT_TRUE(solids.Touches(ball, At(0.24, 0.0, 0.03)));
  EXPECT_NEAR(solids.Distance(ball, At(0.24, 0.0, 0.03), 0.1), -0.01, 2e-4);
  EXPECT_TRUE(solids.Touches(ball, At(0.6, 0.0, -0.3))) << "inside";
  EXPECT_FALSE(solids.Touches(ball, At(0.1, 0.0, -kSolidDepth - 0.03))) << "below";
}

TEST(SolidsOf, PlanesWithoutEndAreSolidBelow) {
  Terrain slope = FlatTerrain();
  slope.patches[0].X_WT.linear() = RotationExp(Vector3(0.0, -0.3, 0.0));
  slope.patches[0].X_WT.translation() = Vector3(1.0, 0.0, 0.2);
  const ShapeScene solids = SolidsOf(slope);
  const Pose over = slope.patches[0].X_WT * At(0.7, -0.4, 0.05);
  EXPECT_NEAR(solids.Distance(Ball(0.02), over, 1.0), 0.03, 1e-12);
  EXPECT_TRUE(solids.Touches(Ball(0.02), At(0.0, 0.0, -50.0)));
}

TEST(SolidsOf, FieldsAndObstaclesAreThereToo) {
  Terrain terrain;
  HeightField field;
  field.columns = field.rows = 21;
  field.resolution_m = 0.05;
  field.height_m.assign(21 * 21, 0.3);
  terrain.height_fields = {field};
  Obstacle post;
  post.name = "post";
  post.type = ShapeType::kCylinder;
  post.size_m = Vector3(0.05, 0.4, 0.0);
  post.X_WO.translation() = Vector3(0.5, 0.5, 0.5);
  terrain.obstacles = {post};
  const ShapeScene solids = SolidsOf(terrain);
  const PreparedShape ball(Ball(0.02));
  const NearestSolid beside = solids.Nearest(ball, At(0.4, 0.5, 0.5), 0.1);
  EXPECT_NEAR(beside.distance_m, 0.03, 2e-5);
  EXPECT_EQ(solids.SolidName(beside.solid), "post");
  const NearestSolid over = solids.Nearest(ball, At(0.1, 0.1, 0.36), 0.1);
  EXPECT_NEAR(over.distance_m, 0.04, 2e-5);
  EXPECT_EQ(solids.SolidName(over.solid), "height field 0");
  EXPECT_TRUE(solids.Touches(ball, At(0.1, 0.1, 0.0))) << "wholly under the surface";
}

}  // namespace
}  // namespace gaitwright
