// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/plan_over_terrain.h"

#include <gtest/gtest.h>

#include "kinematics/stability/polygon.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// Level ground from one x to another, at a height.
TerrainPatch Level(double from, double to, double z) {
  return PatchThrough("level", {{from, -2.0, z}, {to, -2.0, z}, {to, 2.0, z}, {from, 2.0, z}}, 0.6);
}

TEST(PutOnPatch, IsNearestToThePlaceAndOffTheEdges) {
  Terrain ground{"step", {Level(-1.0, 1.0, 0.0), Level(1.0, 3.0, 0.2)}, {}, {}};
  RigidStance stance;
  ASSERT_TRUE(PutOnPatch(ground, 1, {0.4, 0.3, 0.0}, 0.05, stance));
  EXPECT_LT((stance.X_WF.translation() - Vector3(1.05, 0.3, 0.2)).norm(), 1e-9);
  EXPECT_EQ(stance.friction, 0.6);
  EXPECT_NEAR(SignedDistance(stance.region_F, Vector2::Zero()), 0.0, 1e-9);
  const Pose before = stance.X_WF;
  EXPECT_FALSE(PutOnPatch(ground, 0, {0.4, 0.3, 0.0}, 1.1, stance));
  EXPECT_EQ(stance.X_WF.matrix(), before.matrix());
}

TEST(PlanOverTerrain, OnGroundThatIsOnePatchThereIsNothingElseToTry) {
  const Result<PlanOverPatches> plan = PlanOverTerrain(FlatTerrain(0.6), rigid_bodies::Walker());
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  EXPECT_EQ(plan->choices, 1);
  const Result<RigidBodyPlan> alone = PlanRigidBody(plan->choice.problem);
  ASSERT_TRUE(alone.ok());
  EXPECT_EQ(plan->plan.summary.cost, alone->summary.cost);
}

TEST(PlanOverTerrain, OtherPatchesAreTriedWhereLawsStayUnmetAndTheRefusalIsOfTheBest) {
  // The distance is too long for one hop, and there is a kerb on it.
  Terrain ground{"kerb", {Level(-2.0, 0.9, 0.0), Level(0.9, 1.3, 0.05), Level(1.3, 5.0, 0.0)}, {}, {}};
  PlanOverPatches last;
  const ChooseFootholdsOptions hopeful{.infeasible_m = 10.0};
  const Result<PlanOverPatches> plan =
      PlanOverTerrain(ground, rigid_bodies::Hopper(1.2), hopeful, {}, {.near_m = 2.0}, &last);
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.failure().code, FailureCode::kUnmetLaw);
  EXPECT_GT(last.choices, 1);
  EXPECT_NE(plan.failure().message.find(last.plan.summary.worst), std::string::npos) << plan.failure().message;
  const Result<PlanOverPatches> once =
      PlanOverTerrain(ground, rigid_bodies::Hopper(1.2), hopeful, {}, {.most_steps = 1}, &last);
  EXPECT_FALSE(once.ok());
  EXPECT_EQ(last.choices, 1);
}

TEST(PlanOverTerrain, RefusesWhatHasNoFootholdsAndOptionsThatAreNone) {
  const Result<PlanOverPatches> none = PlanOverTerrain(Terrain{"nothing", {}, {}, {}}, rigid_bodies::Walker());
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.failure().code, FailureCode::kNoPatches);
  EXPECT_THROW((void)PlanOverTerrain(FlatTerrain(), rigid_bodies::Walker(), {}, {}, {.better = 2.0}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
