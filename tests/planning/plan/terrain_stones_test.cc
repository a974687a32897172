// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/terrain_kinds_internal.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright {
namespace {

/// Robots of three sizes.
std::vector<TerrainScale> StoneScales() {
  TerrainScale small, large;
  small.leg_length_m = 0.15;
  small.stance_width_m = 0.1;
  large.leg_length_m = 1.1;
  large.stance_width_m = 0.6;
  large.foot_length_m = 0.3;
  return {small, {}, large};
}

TEST(StonesGround, RowsAreOddAndWiderThanTheRobotByARowOnEachSide) {
  for (const TerrainScale& scale : StoneScales()) {
    const terrain::StonesGround stones(scale);
    EXPECT_EQ(stones.rows % 2, 1);
    EXPECT_GE((stones.rows - 1) * stones.spacing_m, scale.stance_width_m);
    EXPECT_GE(stones.size_m, 1.2 * scale.foot_length_m) << "a foot finds room on a stone";
    EXPECT_NO_THROW((void)stones.Build());
  }
}

TEST(StonesGround, WithoutJitterIsALattice) {
  terrain::StonesGround stones(TerrainScale{});
  stones.jitter_m = stones.height_jitter_m = 0.0;
  stones.start_m = 1.0;
  stones.size_m = 0.2;
  stones.spacing_m = 0.3;
  stones.count = 4;
  stones.rows = 3;
  const Terrain ground = stones.Build();
  for (int column = 0; column < 4; ++column) {
    for (int row = -1; row <= 1; ++row) {
      const Vector2 middle(1.1 + 0.3 * column + 0.1, 0.3 * row);
      for (const Vector2& off : {Vector2(0.099, 0.099), Vector2(-0.099, 0.099), Vector2(0.0, -0.099)})
        EXPECT_EQ(GroundAt(ground, middle + off).height_m, 0.0);
      EXPECT_EQ(GroundAt(ground, middle + Vector2(0.0, 0.101)).patch, -1) << "nothing beside a stone";
    }
  }
  EXPECT_GE(GroundAt(ground, {0.999, 5.0}).patch, 0) << "level up to the start";
  EXPECT_EQ(GroundAt(ground, {1.001, 5.0}).patch, -1);
  EXPECT_EQ(GroundAt(ground, {2.299, 5.0}).patch, -1) << "1.1 m, three spacings, a stone and a gap";
  EXPECT_GE(GroundAt(ground, {2.301, 5.0}).patch, 0);
}

TEST(StonesGround, JitterUpToHalfTheGapIsAllThatFits) {
  terrain::StonesGround stones(TerrainScale{});
  stones.size_m = 0.2;
  stones.spacing_m = 0.3;
  stones.jitter_m = 0.0499;
  EXPECT_NO_THROW((void)stones.Build());
  stones.jitter_m = 0.051;
  EXPECT_THROW((void)stones.Build(), InvalidArgument);
}

TEST(StonesGround, HaveTheirNamesAndFrictionEachOnce) {
  terrain::StonesGround stones(TerrainScale{});
  stones.friction = 0.37;
  std::set<std::string> names;
  for (const TerrainPatch& patch : stones.Build().patches) {
    EXPECT_EQ(patch.friction, 0.37);
    EXPECT_TRUE(names.insert(patch.name).second) << patch.name;
  }
  EXPECT_TRUE(names.contains("stone 1"));
}

TEST(GapGround, HasNoGroundInItAndLevelGroundOnBothSides) {
  for (const TerrainScale& scale : StoneScales()) {
    const terrain::GapGround gap(scale);
    EXPECT_LT(gap.width_m, scale.leg_length_m) << "a step over";
    const Terrain ground = gap.Build();
    EXPECT_EQ(GroundAt(ground, {gap.start_m + 0.5 * gap.width_m, 0.0}).patch, -1);
    for (const double x : {gap.start_m - 1e-6, gap.start_m + gap.width_m + 1e-6})
      EXPECT_EQ(GroundAt(ground, {x, 1.0}).height_m, 0.0);
  }
}

TEST(BeamGround, IsWiderThanTheStanceOfItsRobot) {
  for (const TerrainScale& scale : StoneScales()) {
    const terrain::BeamGround beam(scale);
    EXPECT_GT(beam.width_m, 1.1 * scale.stance_width_m);
    const Terrain ground = beam.Build();
    const double middle = beam.start_m + 0.5 * beam.length_m;
    EXPECT_GE(GroundAt(ground, {middle, 0.49 * beam.width_m}).patch, 0);
    EXPECT_EQ(GroundAt(ground, {middle, 0.51 * beam.width_m}).patch, -1);
  }
}

TEST(CinderGround, CoversItsAreaWithoutGaps) {
  terrain::CinderGround cinder(TerrainScale{});
  const Terrain ground = cinder.Build();
  const double half = 0.5 * cinder.rows * cinder.block_m;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 20; ++j) {
      const Vector2 p(cinder.start_m + (i + 0.5) / 40.0 * cinder.count * cinder.block_m,
                      -half + (j + 0.5) / 20.0 * 2.0 * half);
      EXPECT_GT(GroundAt(ground, p).patch, 0) << p.transpose();
    }
  }
}

TEST(CinderGround, BlocksAreLevelOrTiltedByTheAngleAndNeverBelowOneLayer) {
  terrain::CinderGround cinder(TerrainScale{});
  cinder.tilt_deg = 12.0;
  cinder.count = 15;
  int level = 0, tilted = 0;
  const Terrain ground = cinder.Build();
  for (std::size_t i = 1; i < ground.patches.size(); ++i) {
    const TerrainPatch& patch = ground.patches[i];
    const double angle = std::acos(std::min(1.0, patch.X_WT.linear()(2, 2))) * 180.0 / std::numbers::pi;
    if (angle < 0.01) ++level;
    if (std::abs(angle - 12.0) < 0.01) ++tilted;
    for (const Vector2& corner : patch.outline_T)
      EXPECT_GE((patch.X_WT * Vector3(corner.x(), corner.y(), 0.0)).z(), cinder.height_m - 1e-9);
  }
  EXPECT_GT(level, 0);
  EXPECT_GT(tilted, level) << "four of five kinds are tilted";
  EXPECT_EQ(level + tilted, static_cast<int>(ground.patches.size()) - 1);
}

TEST(CinderGround, WithoutTiltHasOneOrTwoLayers) {
  terrain::CinderGround cinder(TerrainScale{});
  cinder.tilt_deg = 0.0;
  cinder.count = 12;
  std::set<long> layers;
  const Terrain ground = cinder.Build();
  for (std::size_t i = 1; i < ground.patches.size(); ++i) {
    const double height = ground.patches[i].X_WT.translation().z() / cinder.height_m;
    EXPECT_NEAR(height, std::round(height), 1e-9);
    layers.insert(std::lround(height));
  }
  EXPECT_EQ(layers, (std::set<long>{1, 2}));
}

}  // namespace
}  // namespace gaitwright
