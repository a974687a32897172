// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/resting_plane.h"

#include <gtest/gtest.h>

#include <random>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

std::vector<Vector3> Corners(double z = 0.0) {
  return {{-1.0, -0.5, z}, {1.0, -0.5, z}, {1.0, 0.5, z}, {-1.0, 0.5, z}};
}

double On(const Vector3& plane, const Vector3& p) { return plane.dot(Vector3(p.x(), p.y(), 1.0)); }

TEST(RestingPlane, LiesOnLevelGround) {
  const Vector3 plane = RestingPlane(Corners(0.2), {0.1, 0.1});
  EXPECT_LT((plane - Vector3(0.0, 0.0, 0.2)).norm(), 1e-12);
}

TEST(RestingPlane, TipsOverABumpToTheSideOfTheLoad) {
  std::vector<Vector3> ground = Corners();
  ground.emplace_back(0.0, 0.0, 0.1);
  const Vector3 forward = RestingPlane(ground, {0.3, 0.0}), behind = RestingPlane(ground, {-0.3, 0.0});
  EXPECT_NEAR(forward.x(), -0.1, 1e-9);  // on the bump and both front corners
  EXPECT_NEAR(behind.x(), 0.1, 1e-9);
}

TEST(RestingPlane, IsOnTopOfAllAndTouchesThreeAroundTheLoad) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> along(-1.0, 1.0), across(-0.5, 0.5), height(0.0, 0.1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Vector3> ground = Corners();
    for (Vector3& corner : ground) corner.z() = height(engine);
    for (int i = 0; i < 100; ++i) ground.emplace_back(along(engine), across(engine), height(engine));
    const Vector2 load(0.5 * along(engine), 0.5 * across(engine));
    const Vector3 plane = RestingPlane(ground, load);
    std::vector<Vector2> touching;
    for (const Vector3& p : ground) {
      EXPECT_GT(On(plane, p), p.z() - 2e-9);
      if (On(plane, p) < p.z() + 1e-7) touching.emplace_back(p.head<2>());
    }
    ASSERT_GE(touching.size(), 3U);
    Matrix3 places;
    for (int i = 0; i < 3; ++i) places.col(i) << touching[static_cast<std::size_t>(i)], 1.0;
    EXPECT_GE((places.inverse() * Vector3(load.x(), load.y(), 1.0)).minCoeff(), -1e-6);
  }
}

TEST(RestingPlane, RefusesALoadBesideTheGround) { EXPECT_THROW(RestingPlane(Corners(), {2.0, 0.0}), InvalidArgument); }

}  // namespace
}  // namespace gaitwright
