// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/walk_problem.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "kinematics/stability/polygon.h"
#include "planning/gait/find_gait.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright {
namespace {

/// A trot over stones and the problem of its rigid body.
struct OverStones {
  RobotModel model = *LoadNamedRobot("a1");
  Terrain terrain = *MakeTerrain("stepping-stones", ScaleOf(model));
  Gait gait = *FindGait(model, "trot", 0.5, {});
  FootstepSkeleton skeleton;
  RigidBodyProblem held, free;

  OverStones() {
    WalkCommand command;
    command.speed_m_s = 0.5;
    command.distance_m = 1.0;
    skeleton = *PlanFootsteps(model, terrain, gait, command, {});
    held = ProblemWith("held");
    free = ProblemWith("free");
  }

  RigidBodyProblem ProblemWith(const std::string& footholds) const {
    MotionOptions options;
    options.footholds = footholds;
    const BodyPath path(model, skeleton, gait.cycle_s);
    const MotionTask task{model, terrain, skeleton, options, path, gait.cycle_s};
    const FlightSwings shapes(model, skeleton.schedule, options.swing);
    return WalkProblem(task, CarriedBody(model, nullptr), nullptr, shapes);
  }
};

TEST(WalkProblem, FootholdsThatAreFreeStayOnTheirPatchesAndNearToWhereTheyWere) {
  const OverStones walk;
  ASSERT_EQ(walk.free.stances.size(), walk.held.stances.size());
  int freed = 0;
  for (std::size_t i = 0; i < walk.free.stances.size(); ++i) {
    const RigidStance &stance = walk.free.stances[i], &before = walk.held.stances[i];
    EXPECT_TRUE(before.held);
    EXPECT_EQ(stance.start_s, before.start_s);
    EXPECT_NEAR(stance.friction, before.friction, 1e-12);
    const bool at_an_end = stance.start_s <= 0.0 || stance.end_s >= walk.free.duration_s;
    if (at_an_end) {
      EXPECT_TRUE(stance.held);
      EXPECT_TRUE(stance.X_WF.isApprox(before.X_WF));
    }
    if (stance.held) continue;
    ++freed;
    const TerrainPatch& patch =
        walk.terrain.patches[static_cast<std::size_t>(walk.skeleton.footsteps.footholds[i].patch)];
    for (const Vector2& corner : stance.region_F) {
      EXPECT_LE(corner.cwiseAbs().maxCoeff(), 0.25 * walk.model.leg_length_m() + 1e-9);
      const Vector3 on_T = patch.X_WT.inverse() * (stance.X_WF * Vector3(corner.x(), corner.y(), 0.0));
      EXPECT_NEAR(on_T.z(), 0.0, 1e-9);
      if (!patch.outline_T.empty()) {
        EXPECT_GT(SignedDistance(patch.outline_T, on_T.head<2>()), 0.02) << "a rolling foot stays on";
      }
    }
  }
  EXPECT_GT(freed, 4);
}

TEST(WalkPatchRules, FeetStandOnOtherPatchesThatAreNotTooSteep) {
  const OverStones walk;
  Terrain ground{"steep",
                 {PatchThrough("level", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, 0.6),
                  PatchThrough("steep", {{1, -1, 0}, {2, -1, 1}, {2, 1, 1}, {1, 1, 0}}, 0.6)},
                 {},
                 {}};
  const MotionOptions options;
  const BodyPath path(walk.model, walk.skeleton, walk.gait.cycle_s);
  const MotionTask task{walk.model, ground, walk.skeleton, options, path, walk.gait.cycle_s};
  const PatchRules rules = WalkPatchRules(task);
  EXPECT_FALSE(rules.fits_path) << "the path is that of the walk";
  RigidStance stance;
  stance.held = true;
  EXPECT_FALSE(rules.put(1, {1.5, 0.0, 0.5}, stance)) << "45 degrees";
  EXPECT_TRUE(stance.region_F.empty()) << "nothing changes then";
  ASSERT_TRUE(rules.put(0, {1.5, 0.0, 0.5}, stance));
  EXPECT_NEAR(stance.X_WF.translation().x(), 1.0 - options.footsteps.foothold.margin_m - walk.model.feet[0].radius,
              1e-9);
  EXPECT_NEAR(stance.friction, 0.6 * options.whole_body.friction_use, 1e-12);
  EXPECT_EQ(PatchesOf(task, walk.held), std::vector<int>(walk.held.stances.size(), -1));
}

}  // namespace
}  // namespace gaitwright
