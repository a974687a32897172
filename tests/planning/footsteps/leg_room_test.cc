// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/leg_room.h"

#include <gtest/gtest.h>

#include "grounds.h"
#include "kinematics/model/load_robot.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

constexpr double kMargin = 0.005;  // [m]

/// A front left leg in the standing posture at the origin; its knee is behind its foot.
struct StandingLeg {
  StandingLeg() : model(LoadNamedRobot("a1").value()), workspace(model, 0, 0.0), X_WF(StandingFeet(model)[0]) {
    X_WB.translation().z() = model.standing_base_height_m;
  }

  bool IsClearOn(const Terrain& terrain) {
    const GroundIndex ground(terrain, 0.1);
    return LegRoom(model, ground, kMargin).IsClear(workspace, model.feet[0], X_WF, X_WB);
  }
  bool MayMeetOn(const Terrain& terrain) {
    const GroundIndex ground(terrain, 0.1);
    return LegRoom(model, ground, kMargin).MayMeet(X_WF);
  }
  /// A block that ends (behind) or begins (in front) at a distance along x from the foot; level ground elsewhere.
  Terrain Block(double from_foot_m, double height_m, bool behind) const {
    Terrain terrain = FlatTerrain();
    TerrainPatch block;
    block.name = "block";
    const double x = X_WF.translation().x() + from_foot_m, length = behind ? -1.0 : 1.0;
    block.X_WT.translation() = Vector3(std::min(x, x + length), -1.0, height_m);
    block.outline_T = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 2.0}, {0.0, 2.0}};
    terrain.patches.push_back(block);
    return terrain;
  }

  RobotModel model;
  LegWorkspace workspace;
  Pose X_WF, X_WB = Pose::Identity();
};

TEST(LegRoom, IsThereOnLevelGround) {
  StandingLeg leg;
  EXPECT_TRUE(leg.IsClearOn(FlatTerrain()));
  EXPECT_FALSE(leg.MayMeetOn(FlatTerrain()));
}

TEST(LegRoom, EndsWhereAShankLeansBackOverAStair) {
  StandingLeg leg;
  const double half = 0.5 * leg.model.leg_length_m();
  EXPECT_FALSE(leg.IsClearOn(leg.Block(-0.03, half, true)));
  EXPECT_TRUE(leg.IsClearOn(leg.Block(-0.5, half, true)));   // behind the knee
  EXPECT_TRUE(leg.IsClearOn(leg.Block(0.05, half, false)));  // in front of the shank
  EXPECT_TRUE(leg.MayMeetOn(leg.Block(-0.03, half, true)));
}

TEST(LegRoom, ShrinksAsTheStairGrows) {
  StandingLeg leg;
  bool clear = true;
  for (double height = 0.0; height < 0.3; height += 0.01) {
    const bool now = leg.IsClearOn(leg.Block(-0.04, height, true));
    EXPECT_TRUE(clear || !now) << height;
    clear = now;
  }
  EXPECT_FALSE(clear);
}

TEST(LegRoom, AHeightFieldIsGroundAsAPatchIs) {
  StandingLeg leg;
  const double half = 0.5 * leg.model.leg_length_m();
  Terrain terrain = FlatTerrain();
  HeightField field;
  field.name = "block";
  field.resolution_m = 0.01;
  field.columns = field.rows = 100;
  field.origin_W = {leg.X_WF.translation().x() - 0.03 - 0.99, -0.5};
  field.height_m.assign(10000, half);
  terrain.height_fields.push_back(field);
  EXPECT_FALSE(leg.IsClearOn(terrain));
}

}  // namespace
}  // namespace gaitwright
