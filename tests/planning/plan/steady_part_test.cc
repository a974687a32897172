// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/stability/polygon.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {
namespace {

const std::vector<Vector2> kSole = {{-0.08, -0.04}, {0.08, -0.04}, {0.08, 0.04}, {-0.08, 0.04}};

/// A height field around the origin, twisted: z = twist x y.
Terrain Twisted(double twist) {
  Terrain terrain;
  HeightField field;
  field.name = "twisted";
  field.resolution_m = 0.02;
  field.columns = field.rows = 21;
  field.origin_W = {-0.2, -0.2};
  for (int row = 0; row < field.rows; ++row)
    for (int column = 0; column < field.columns; ++column)
      field.height_m.push_back(twist * (field.origin_W.x() + 0.02 * column) * (field.origin_W.y() + 0.02 * row));
  terrain.height_fields.push_back(field);
  return terrain;
}

/// The pose in which the sole lies on its corners at +x +y and -x -y.
Pose OnTwoCorners(double twist) {
  Pose X_WF = Pose::Identity();
  X_WF.translation().z() = twist * 0.08 * 0.04;
  return X_WF;
}

TEST(SteadyPart, IsTheWholeSoleOnLevelGround) {
  const Polygon steady = SteadyPart(kSole, Pose::Identity(), Twisted(0.0), 0.02);
  EXPECT_NEAR(SignedDistance(steady, Vector2::Zero()), 0.04, 1e-12);
}

TEST(SteadyPart, IsAStripBetweenTwoCornersOnTwistedGround) {
  const double twist = 0.07;  // the other two corners are 0.45 mm over the ground
  const Terrain terrain = Twisted(twist);
  const Pose X_WF = OnTwoCorners(twist);
  const double steady = SignedDistance(SteadyPart(kSole, X_WF, terrain, 0.02), Vector2::Zero());
  EXPECT_LT(steady, 0.01);
  EXPECT_NEAR(SignedDistance(TouchingPart(kSole, X_WF, terrain, 0.02), Vector2::Zero()), 0.04, 1e-12);
}

TEST(SteadyPart, GrowsWhereASmallTurnIsEnough) {
  const double twist = 0.02;  // 0.13 mm over the ground, 72 mm away
  EXPECT_NEAR(SignedDistance(SteadyPart(kSole, OnTwoCorners(twist), Twisted(twist), 0.02), Vector2::Zero()), 0.04,
              1e-9);
}

}  // namespace
}  // namespace gaitwright
