// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planning/plan/terrain_kinds_internal.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright {
namespace {

double HeightAlong(const Terrain& terrain, double x_m, double y_m = 0.0) {
  return GroundAt(terrain, {x_m, y_m}).height_m;
}

TEST(StairsGroundKind, AreTheSameUpAndDown) {
  for (const int count : {1, 2, 5}) {
    terrain::StairsGround stairs(TerrainScale{});
    stairs.count = count;
    stairs.start_m = 1.0;
    const Terrain ground = stairs.Build();
    const double length = 2.0 * (count - 1) * stairs.tread_m + stairs.landing_m;
    double highest = 0.0;
    for (double u = 0.003; u < 0.5 * length; u += 0.0107) {
      EXPECT_NEAR(HeightAlong(ground, 1.0 + u), HeightAlong(ground, 1.0 + length - u), 1e-12) << u;
      highest = std::max(highest, HeightAlong(ground, 1.0 + u));
    }
    EXPECT_NEAR(highest, count * stairs.rise_m, 1e-12);
    EXPECT_EQ(HeightAlong(ground, 0.999), 0.0);
    EXPECT_EQ(HeightAlong(ground, 1.001 + length), 0.0);
    EXPECT_EQ(ground.patches.size(), static_cast<std::size_t>(2 * count)) << "the ground and 2 count - 1 treads";
  }
}

TEST(StairsGroundKind, RiseByOneStepAtATime) {
  terrain::StairsGround stairs(TerrainScale{});
  stairs.count = 6;
  const Terrain ground = stairs.Build();
  double last = 0.0, x = stairs.start_m + 0.5 * stairs.tread_m;
  for (int step = 1; step <= 6; ++step, x += stairs.tread_m) {
    EXPECT_NEAR(HeightAlong(ground, x) - last, stairs.rise_m, 1e-12) << step;
    last = HeightAlong(ground, x);
  }
}

TEST(SlopeGroundKind, ClimbsByItsAngleToAPlateauAndComesDownAlike) {
  terrain::SlopeGround slope(TerrainScale{});
  slope.angle_deg = 11.0;
  const Terrain ground = slope.Build();
  const double tangent = std::tan(11.0 * std::numbers::pi / 180.0), top = slope.start_m + slope.length_m;
  EXPECT_NEAR(HeightAlong(ground, slope.start_m + 0.3 * slope.length_m), 0.3 * slope.length_m * tangent, 1e-9);
  EXPECT_NEAR(HeightAlong(ground, top + 0.5 * slope.plateau_m), slope.length_m * tangent, 1e-9);
  EXPECT_NEAR(HeightAlong(ground, top + slope.plateau_m + 0.7 * slope.length_m), 0.3 * slope.length_m * tangent, 1e-9);
}

TEST(RampGroundKind, StaysHighForAsFarAsLevelGroundReaches) {
  terrain::RampGround ramp(TerrainScale{});
  const Terrain ground = ramp.Build();
  const double top = ramp.start_m + ramp.length_m, rise = HeightAlong(ground, top + 1e-6);
  EXPECT_NEAR(rise, ramp.length_m * std::tan(ramp.angle_deg * std::numbers::pi / 180.0), 1e-9);
  EXPECT_NEAR(HeightAlong(ground, top + terrain::kLevelReach - 1e-6), rise, 1e-9);
  EXPECT_EQ(HeightAlong(ground, top + terrain::kLevelReach + 1e-6), 0.0);
}

TEST(BlockGroundKind, IsHighWithinItsEdgesOnly) {
  terrain::BlockGround block(TerrainScale{});
  block.height_m = 0.07;
  const Terrain ground = block.Build();
  const double end = block.start_m + block.length_m, half = 0.5 * block.width_m;
  for (const double x : {block.start_m + 1e-6, end - 1e-6}) {
    EXPECT_NEAR(HeightAlong(ground, x, half - 1e-6), 0.07, 1e-12);
    EXPECT_EQ(HeightAlong(ground, x, half + 1e-6), 0.0);
  }
  EXPECT_EQ(HeightAlong(ground, block.start_m - 1e-6), 0.0);
  EXPECT_EQ(HeightAlong(ground, end + 1e-6), 0.0);
}

TEST(StepKinds, HaveOneFrictionAndRoomForTheRobotOnTop) {
  TerrainScale scale;
  scale.body_length_m = 0.9;
  terrain::StairsGround stairs(scale);
  terrain::SlopeGround slope(scale);
  terrain::BlockGround block(scale);
  stairs.friction = slope.friction = block.friction = 0.45;
  for (const Terrain& ground : {stairs.Build(), slope.Build(), block.Build()}) {
    for (const TerrainPatch& patch : ground.patches) EXPECT_EQ(patch.friction, 0.45) << patch.name;
  }
  EXPECT_GT(stairs.landing_m, scale.body_length_m);
  EXPECT_GT(slope.plateau_m, scale.body_length_m);
  EXPECT_GT(block.length_m, scale.body_length_m);
}

TEST(StepKinds, SuitTheRobotsLegs) {
  for (const double leg_m : {0.1, 0.4, 1.0}) {
    TerrainScale scale;
    scale.leg_length_m = leg_m;
    EXPECT_NEAR(terrain::StairsGround(scale).rise_m, 0.08 * leg_m, 0.005 * leg_m);
    EXPECT_NEAR(terrain::BlockGround(scale).height_m, 0.08 * leg_m, 0.005 * leg_m);
  }
}

}  // namespace
}  // namespace gaitwright
