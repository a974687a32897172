// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/stability/polygon.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {
namespace {

Foot Sole(double length, double width) {
  Foot foot;
  foot.type = FootType::kSole;
  foot.sole_F = {{-0.5 * length, -0.5 * width},
                 {0.5 * length, -0.5 * width},
                 {0.5 * length, 0.5 * width},
                 {-0.5 * length, 0.5 * width}};
  return foot;
}

Terrain OnePatch(double half, const Pose& X_WT) {
  TerrainPatch patch;
  patch.X_WT = X_WT;
  patch.outline_T = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  return {"one", {patch}, {}, {}};
}

TEST(OverhangingSole, AnOverhangingSoleIsHeldByThePartThatIsOn) {
  const Terrain terrain = OnePatch(1.0, Pose::Identity());
  Foothold foothold;
  foothold.X_WF.translation() = Vector3(1.0, 0.0, 0.0);  // its middle over the edge
  const Polygon part = SupportOf(Sole(0.2, 0.1), foothold, terrain, 0.01);
  EXPECT_NEAR(Area(part), 0.09 * 0.1, 1e-12);
  EXPECT_NEAR(Centroid(part).x(), -0.055, 1e-12);
}

TEST(OverhangingSole, TurnsWithTheFootAndTheGround) {
  Pose X_WT = Pose::Identity();
  X_WT.linear() = (Eigen::AngleAxisd(0.3, Vector3::UnitX()) * Eigen::AngleAxisd(0.8, Vector3::UnitZ())).matrix();
  X_WT.translation() = Vector3(3.0, -2.0, 1.0);
  const Terrain terrain = OnePatch(0.5, X_WT);
  Foothold foothold;
  // In the plane of the patch, rotated by 90 degrees: the side of the sole overhangs, not its toes.
  foothold.X_WF =
      X_WT * Eigen::Translation3d(0.5, 0.0, 0.0) * Eigen::AngleAxisd(0.5 * 3.14159265358979, Vector3::UnitZ());
  const Polygon part = SupportOf(Sole(0.2, 0.1), foothold, terrain, 0.0);
  EXPECT_NEAR(Area(part), 0.2 * 0.05, 1e-9);
  EXPECT_NEAR(Centroid(part).y(), 0.025, 1e-9);
}

TEST(OverhangingSole, IsTheWholeSoleInsideAndOnGroundWithoutEnd) {
  const Foot foot = Sole(0.2, 0.1);
  Foothold foothold;
  EXPECT_NEAR(Area(SupportOf(foot, foothold, OnePatch(1.0, Pose::Identity()))), 0.02, 1e-12);
  EXPECT_NEAR(Area(SupportOf(foot, foothold, FlatTerrain())), 0.02, 1e-12);
}

TEST(OverhangingSole, OfALineIsCutToASegment) {
  Foot line;
  line.type = FootType::kLine;
  line.sole_F = {{-0.1, 0.0}, {0.1, 0.0}};
  Foothold foothold;
  foothold.X_WF.translation() = Vector3(1.0, 0.0, 0.0);
  const Terrain terrain = OnePatch(1.0, Pose::Identity());
  const Polygon part = SupportOf(line, foothold, terrain, 0.02);
  ASSERT_EQ(part.size(), 2U);
  EXPECT_NEAR((part[0] - part[1]).norm(), 0.08, 1e-12);
}

TEST(OverhangingSole, IsNothingBesideThePatch) {
  Foothold foothold;
  foothold.X_WF.translation() = Vector3(2.0, 0.0, 0.0);
  EXPECT_TRUE(SupportOf(Sole(0.2, 0.1), foothold, OnePatch(1.0, Pose::Identity())).empty());
}

}  // namespace
}  // namespace gaitwright
