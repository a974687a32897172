// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/moved_terrain.h"

#include <gtest/gtest.h>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

Pose Moved(double x_m, double y_m, double z_m, double yaw_rad) {
  Pose X(YawRotation(yaw_rad));
  X.translation() << x_m, y_m, z_m;
  return X;
}

TEST(MovedTerrain, EndlessLevelGroundIsAsHighAllOver) {
  const Terrain flat = FlatTerrain(0.7);
  const Terrain moved = MovedTerrain(Moved(1.0, 2.0, -0.3, 0.5), flat).value();
  EXPECT_TRUE(moved.patches[0].X_WT.linear().isIdentity(0.0)) << "it is not turned, which nobody would see";
  EXPECT_EQ(moved.patches[0].X_WT.translation(), Vector3(0.0, 0.0, -0.3));
}

TEST(MovedTerrain, PlacesKeepTheirHeightOverTheGroundWhereverTheyGo) {
  Terrain ground = FlatTerrain();
  TerrainPatch slope{"slope", Pose(Eigen::AngleAxisd(-0.2, Vector3::UnitY())), {}, 0.8};
  slope.X_WT.translation() << 0.5, 0.0, 0.1;
  TerrainPatch step{"step", Moved(1.0, 0.0, 0.2, 0.3), {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}, 0.8};
  ground.patches = {slope, step};
  ground.obstacles = {{"post", ShapeType::kCylinder, Moved(2.0, 1.0, 0.5, 0.0), {0.1, 1.0, 0.0}, {}}};
  ground.markers = {{"door", {0.4, 0.5}}};
  const Pose X = Moved(-0.3, 0.7, -0.4, 1.1);
  const Terrain moved = MovedTerrain(X, ground).value();
  for (const double along : {-1.0, 0.0, 2.0}) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector3 p = X * (ground.patches[k].X_WT * Vector3(along, 0.3, 0.0));
      EXPECT_NEAR((moved.patches[k].X_WT.inverse() * p).z(), 0.0, 1e-12) << ground.patches[k].name;
    }
  }
  EXPECT_LT((moved.obstacles[0].X_WO.translation() - X * Vector3(2.0, 1.0, 0.5)).norm(), 1e-12);
  EXPECT_LT((moved.markers[0].p_W - (X * Vector3(0.4, 0.5, 0.0)).head<2>()).norm(), 1e-12);
}

TEST(MovedTerrain, AFieldIsRaisedAndMovedButNotTurned) {
  Terrain ground;
  ground.height_fields = {{"rough", {0.1, 0.2}, 0.05, 2, 2, {0.0, 0.01, 0.02, 0.03}, 0.8}};
  const Terrain moved = MovedTerrain(Moved(1.0, 2.0, 0.5, 0.0), ground).value();
  EXPECT_LT((moved.height_fields[0].origin_W - Vector2(1.1, 2.2)).norm(), 1e-12);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_DOUBLE_EQ(moved.height_fields[0].height_m[k], ground.height_fields[0].height_m[k] + 0.5);
  const Result<Terrain> turned = MovedTerrain(Moved(0.0, 0.0, 0.0, 0.1), ground);
  ASSERT_FALSE(turned.ok());
  EXPECT_EQ(turned.failure().code, FailureCode::kTurnedField);
}

}  // namespace
}  // namespace gaitwright
