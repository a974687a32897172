// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/swing_guard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "kinematics/collision/shape_extent.h"
#include "kinematics/dynamics/dynamics.h"
#include "planning/paths/standing_feet.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

/// A swing of a robot's first foot forward from its standing position.
SwingTrajectory GuardedSwing(const RobotModel& model, double length_m, double lift_m, double duration_s = 0.5) {
  SwingTrajectory swing;
  swing.start_s = 1.0;
  swing.end_s = 1.0 + duration_s;
  swing.X_WF_start = swing.X_WF_end = StandingFeet(model)[0];
  swing.X_WF_end.translation().x() += length_m;
  swing.lift_m = lift_m;
  return swing;
}

/// Level ground with a beam of this height across the middle of a swing.
Terrain GroundWithBeam(const SwingTrajectory& swing, double height_m) {
  Terrain terrain = FlatTerrain();
  Obstacle beam;
  beam.name = "beam";
  beam.X_WO.translation() = 0.5 * (swing.X_WF_start.translation() + swing.X_WF_end.translation());
  beam.X_WO.translation().z() = 0.5 * height_m;
  beam.size_m = Vector3(0.01, 0.06, height_m);
  terrain.obstacles = {beam};
  return terrain;
}

FormerMotion StandingBase(const RobotModel& model) {
  FormerMotion former;
  const VectorX q = StandingConfiguration(model);
  Pose X_WB = Pose::Identity();
  X_WB.linear() = BaseRotation(q);
  X_WB.translation() = q.head<3>();
  former.base = [X_WB](double) { return X_WB; };
  return former;
}

class SwingGuardTest : public testing::TestWithParam<const char*> {};

TEST_P(SwingGuardTest, ASwingOverLevelGroundIsClear) {
  const RobotModel& model = NamedRobot(GetParam());
  const Terrain flat = FlatTerrain();
  const SwingGuard guard(model, flat, {});
  EXPECT_FALSE(guard.Check(GuardedSwing(model, 0.08, 0.06), 0.01));
  EXPECT_TRUE(guard.Check(GuardedSwing(model, 0.08, 0.06), 0.07)) << "more than its lift is asked for";
}

TEST_P(SwingGuardTest, AHitNamesTheFootTheSolidTheTimeAndTheGap) {
  const RobotModel& model = NamedRobot(GetParam());
  const SwingTrajectory swing = GuardedSwing(model, 0.3, 0.06);
  const Terrain terrain = GroundWithBeam(swing, 0.1);
  const auto hit = SwingGuard(model, terrain, {}).Check(swing, 0.01);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->part, model.feet[0].link);
  EXPECT_EQ(hit->solid, "beam");
  EXPECT_GT(hit->at_s, swing.start_s);
  EXPECT_LT(hit->at_s, 0.5 * (swing.start_s + swing.end_s) + 1e-9) << "the first place, before the middle";
  EXPECT_LT(hit->distance_m, hit->asked_m);
  EXPECT_LE(hit->asked_m, 0.01);
}

TEST_P(SwingGuardTest, ALiftAboveTheBeamClearsIt) {
  const RobotModel& model = NamedRobot(GetParam());
  const SwingTrajectory low = GuardedSwing(model, 0.3, 0.03), high = GuardedSwing(model, 0.3, 0.2);
  const Terrain terrain = GroundWithBeam(low, 0.03);
  const SwingGuard guard(model, terrain, {});
  EXPECT_TRUE(guard.Check(low, 0.01));
  EXPECT_FALSE(guard.Check(high, 0.01));
}

TEST_P(SwingGuardTest, ARollThatLiftsTheFootClearsWhatItWouldHit) {
  const RobotModel& model = NamedRobot(GetParam());
  const SwingTrajectory swing = GuardedSwing(model, 0.3, 0.06);
  const Terrain terrain = GroundWithBeam(swing, 0.1);
  FormerMotion former;
  former.roll = [](const SwingTrajectory&) { return SwingRoll({Vector3(0.0, 0.0, 0.2), Vector3(0.0, 0.0, 0.2)}); };
  EXPECT_FALSE(SwingGuard(model, terrain, former).Check(swing, 0.01));
}

TEST_P(SwingGuardTest, BesideARiserNoMoreIsAskedThanTheFootholdLeaves) {
  const RobotModel& model = NamedRobot(GetParam());
  const SwingTrajectory swing = GuardedSwing(model, 0.05, 0.08);
  Terrain terrain = FlatTerrain();
  Obstacle wall;
  wall.name = "wall";
  wall.size_m = Vector3(1.0, 0.05, 1.0);
  // Its side is 4 mm from the outermost point of the foot.
  const Foot& foot = model.feet[0];
  double half_width = foot.radius;
  for (const Vector2& corner : foot.sole_F) half_width = std::max(half_width, corner.y());
  wall.X_WO.translation() = swing.X_WF_start.translation() + Vector3(0.0, half_width + 0.004 + 0.025, 0.5);
  terrain.obstacles = {wall};
  const SwingGuard guard(model, terrain, {});
  EXPECT_FALSE(guard.Check(swing, 0.02)) << "20 mm are asked for, and the foothold has 4";
  SwingTrajectory towards = swing;
  towards.detour_W.assign(6, Vector3(0.0, 0.012, 0.06));
  const auto hit = guard.Check(towards, 0.02);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->solid, "wall");
}

TEST_P(SwingGuardTest, WithoutTheBasesMotionNothingIsSaidOfTheLeg) {
  const RobotModel& model = NamedRobot(GetParam());
  const Terrain flat = FlatTerrain();
  const SwingGuard guard(model, flat, {});
  const SwingTrajectory far = GuardedSwing(model, 5.0, 0.1, 0.01);
  EXPECT_TRUE(guard.LegFollows(far));
  EXPECT_TRUE(guard.LegHasRoom(far));
  EXPECT_EQ(guard.RollOf(far).At(0.5).norm(), 0.0);
}

TEST_P(SwingGuardTest, ALegFollowsWhatIsInReachAndSlowEnough) {
  const RobotModel& model = NamedRobot(GetParam());
  const Terrain flat = FlatTerrain();
  const SwingGuard guard(model, flat, StandingBase(model));
  EXPECT_TRUE(guard.LegFollows(GuardedSwing(model, 0.03, 0.02, 0.8)));
  EXPECT_FALSE(guard.LegFollows(GuardedSwing(model, 0.03, 0.02, 0.005))) << "faster than the motors";
  EXPECT_FALSE(guard.LegFollows(GuardedSwing(model, 3.0, 0.02, 8.0))) << "out of reach";
}

TEST_P(SwingGuardTest, ABlockInTheLegAtTheStartLeavesItNoRoom) {
  const RobotModel& model = NamedRobot(GetParam());
  const SwingTrajectory swing = GuardedSwing(model, 0.03, 0.02, 0.8);
  const FormerMotion standing = StandingBase(model);
  const Terrain flat = FlatTerrain();
  EXPECT_TRUE(SwingGuard(model, flat, standing).LegHasRoom(swing));
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  Terrain blocked = FlatTerrain();
  for (const Shape& shape : model.collision_shapes) {
    const std::vector<int>& joints = model.legs[0].joints;
    if (shape.body != model.legs[0].knee_joint + 1 || IsShapeOfAFoot(model, shape)) continue;
    ASSERT_NE(std::find(joints.begin(), joints.end(), shape.body - 1), joints.end());
    Obstacle block;
    block.name = "block";
    block.X_WO.translation() = FramePose(scratch, shape.body, shape.X_BS).translation();
    block.size_m = Vector3::Constant(0.01);
    blocked.obstacles = {block};
  }
  ASSERT_FALSE(blocked.obstacles.empty()) << "the shank has no shape";
  const SwingGuard guard(model, blocked, standing);
  EXPECT_FALSE(guard.LegHasRoom(swing));
  const auto hit = guard.Check(swing, 0.0);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->solid, "block");
  EXPECT_LT(hit->distance_m, 0.0);
  EXPECT_FALSE(guard.Check(swing, 0.0, false)) << "the foot alone is clear of it";
}

INSTANTIATE_TEST_SUITE_P(Robots, SwingGuardTest, testing::Values("a1", "nao"));

}  // namespace
}  // namespace gaitwright
