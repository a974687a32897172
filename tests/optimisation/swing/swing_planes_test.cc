// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/swing_planes.h"

#include <gtest/gtest.h>

#include <random>

namespace gaitwright {
namespace {

TerrainPatch Block() {
  return PatchThrough("block", {{0.7, -1.0, 0.5}, {4.2, -1.0, 0.5}, {4.2, 1.0, 0.5}, {0.7, 1.0, 0.5}}, 0.5);
}

TerrainPatch RampUp() {
  return PatchThrough("ramp", {{1.0, -1.0, 0.0}, {2.0, -1.0, 0.7}, {2.0, 1.0, 0.7}, {1.0, 1.0, 0.0}}, 0.5);
}

TEST(SwingPlanes, AreTheTopTheSideOrTheEdgeOfABlock) {
  const PartingPlane top = PlaneBefore(Block(), Vector3(1.5, 0.2, 0.6));
  EXPECT_LT((top.normal_W - Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(top.Beyond({1.5, 0.2, 0.6}), 0.1, 1e-12);
  const PartingPlane side = PlaneBefore(Block(), Vector3(0.65, 0.2, 0.1));
  EXPECT_LT((side.normal_W + Vector3::UnitX()).norm(), 1e-12);
  EXPECT_NEAR(side.Beyond({0.65, 0.2, 0.1}), 0.05, 1e-12);
  const PartingPlane edge = PlaneBefore(Block(), Vector3(0.67, 0.2, 0.54));
  EXPECT_LT((edge.normal_W - Vector3(-0.6, 0.0, 0.8)).norm(), 1e-9);
  EXPECT_NEAR(edge.Beyond({0.67, 0.2, 0.54}), 0.05, 1e-9);
  // Inside: the nearest side.
  EXPECT_NEAR(PlaneBefore(Block(), Vector3(0.72, 0.0, 0.1)).Beyond({0.72, 0.0, 0.1}), -0.02, 1e-12);
}

TEST(SwingPlanes, PartAnyPointFromAllThatIsSolid) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> draw(-1.5, 1.5);
  int outside = 0;
  for (const TerrainPatch& patch : {Block(), RampUp()}) {
    for (int i = 0; i < 2000; ++i) {
      const Vector3 p_W = Vector3(1.2, 0.0, 0.4) + Vector3(draw(random), draw(random), 0.6 * draw(random));
      const PartingPlane plane = PlaneBefore(patch, p_W);
      EXPECT_NEAR(plane.normal_W.norm(), 1.0, 1e-9);
      for (const Vector3& corner_W : SolidUnder(patch)) EXPECT_LT(plane.Beyond(corner_W), 1e-8);
      if (plane.Beyond(p_W) > 0.0) ++outside;
    }
  }
  EXPECT_GT(outside, 2000);
}

TEST(SwingPlanes, OfAPathPartAllOfIt) {
  // Up and over the edge: neither the top nor the side has both ends of the path on its outer side.
  const std::vector<Vector3> path_W = {{0.66, 0.0, 0.49}, {0.68, 0.0, 0.515}, {0.71, 0.0, 0.54}};
  const PartingPlane plane = PlaneBefore(Block(), path_W);
  for (const Vector3& p_W : path_W) EXPECT_GT(plane.Beyond(p_W), 0.0);
  EXPECT_GT(plane.normal_W.z(), 0.1);
  EXPECT_LT(plane.normal_W.x(), -0.1);
}

TEST(SwingPlanes, APatchWithoutEndHasItsTopAlone) {
  TerrainPatch floor;
  const PartingPlane plane = PlaneBefore(floor, Vector3(3.0, -2.0, -0.1));
  EXPECT_LT((plane.normal_W - Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(plane.Beyond({3.0, -2.0, -0.1}), -0.1, 1e-12);
}

}  // namespace
}  // namespace gaitwright
