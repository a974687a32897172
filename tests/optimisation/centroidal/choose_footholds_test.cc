// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/choose_footholds.h"

#include <gtest/gtest.h>

#include "kinematics/stability/polygon.h"
#include "optimisation/centroidal/plan_rigid_body.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// Ground along x of level strips: from, to, height.
Terrain Strips(const std::vector<Vector3>& strips) {
  Terrain ground;
  ground.name = "strips";
  for (const Vector3& s : strips) {
    ground.patches.push_back(PatchThrough(
        "strip", {{s.x(), -2.0, s.z()}, {s.y(), -2.0, s.z()}, {s.y(), 2.0, s.z()}, {s.x(), 2.0, s.z()}}, 0.7));
  }
  return ground;
}

/// Checks that every chosen foothold and its region are on a patch, and that it has the friction of that patch.
void ExpectOnGround(const Terrain& ground, const RigidBodyProblem& problem, double margin_m) {
  for (const RigidStance& stance : problem.stances) {
    if (stance.held) continue;
    const Vector3 p = stance.X_WF.translation();
    const GroundPoint under = GroundAt(ground, p.head<2>());
    ASSERT_GE(under.patch, 0) << p.transpose();
    EXPECT_NEAR(under.height_m, p.z(), 1e-9);
    EXPECT_LT((under.normal_W - stance.X_WF.linear().col(2)).norm(), 1e-9);
    EXPECT_EQ(stance.friction, under.friction);
    EXPECT_GE(SignedDistance(stance.region_F, Vector2::Zero()), -1e-9);
    for (const Vector2& corner : stance.region_F) {
      const Vector3 q = stance.X_WF * Vector3(corner.x(), corner.y(), 0.0);
      if (q.head<2>().norm() > 50.0) continue;
      EXPECT_NEAR(GroundAt(ground, q.head<2>()).height_m, q.z(), 1e-6) << q.transpose();
      EXPECT_EQ(GroundAt(ground, q.head<2>() + 0.9 * margin_m * Vector2::UnitX()).patch, under.patch);
    }
  }
}

TEST(ChooseFootholds, OnLevelGroundFeetStandWhereTheyLikeTo) {
  const RigidBodyProblem problem = rigid_bodies::Trotter(0.4);
  const Result<ChosenFootholds> choice = ChooseFootholds(FlatTerrain(0.6), problem);
  ASSERT_TRUE(choice.ok());
  ExpectOnGround(FlatTerrain(0.6), choice->problem, 0.01);
  EXPECT_LT(choice->misfit_m, 1e-3);
  EXPECT_EQ(choice->problem.stances.size(), problem.stances.size());
  const RigidStance& last = choice->problem.stances[2];
  EXPECT_LT((last.X_WF.translation() - problem.goal.p_WC - problem.feet[0].p_CF_nominal_B).norm(), 0.03);
  // From rest to rest: feet move forward, never backward.
  for (std::size_t s = 1; s < 3; ++s)
    EXPECT_GT(choice->problem.stances[s].X_WF.translation().x(),
              choice->problem.stances[s - 1].X_WF.translation().x() + 0.05);
}

TEST(ChooseFootholds, FeetKeepOutOfAGapAndOffEdges) {
  const RigidBodyProblem problem = rigid_bodies::Walker(0.8);
  const Terrain ground = Strips({{-2.0, 0.3, 0.0}, {0.5, 3.0, 0.0}});
  const Result<ChosenFootholds> choice = ChooseFootholds(ground, problem, {.edge_margin_m = 0.02});
  ASSERT_TRUE(choice.ok());
  ExpectOnGround(ground, choice->problem, 0.02);
  EXPECT_LT(choice->misfit_m, 0.02);
}

TEST(ChooseFootholds, TheBodyAndItsFeetGoUpASill) {
  RigidBodyProblem problem = rigid_bodies::Walker(0.7);
  problem.goal.p_WC.z() += 0.12;
  const Terrain ground = Strips({{-2.0, 0.35, 0.0}, {0.35, 3.0, 0.12}});
  const Result<ChosenFootholds> choice = ChooseFootholds(ground, problem);
  ASSERT_TRUE(choice.ok());
  ExpectOnGround(ground, choice->problem, 0.01);
  EXPECT_NEAR(choice->problem.stances[2].X_WF.translation().z(), 0.12, 1e-9);
  const Result<RigidBodyPlan> plan = PlanRigidBody(choice->problem);
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  EXPECT_LT(FaultsOf(choice->problem, plan->motion, 1e-3).Largest(), 1e-3);
}

TEST(ChooseFootholds, WhatLiesBelowAnotherPatchIsNotStoodOn) {
  // A plate on infinite ground.
  Terrain ground = FlatTerrain(0.6);
  ground.patches.push_back(
      PatchThrough("plate", {{0.2, -2.0, 0.05}, {0.9, -2.0, 0.05}, {0.9, 2.0, 0.05}, {0.2, 2.0, 0.05}}, 0.5));
  const Result<ChosenFootholds> choice = ChooseFootholds(ground, rigid_bodies::Walker(0.6));
  ASSERT_TRUE(choice.ok());
  ExpectOnGround(ground, choice->problem, 0.01);
}

TEST(ChooseFootholds, RefusesUnreachableGoalsAndNamesTheFootAndTime) {
  const Terrain ground = Strips({{-2.0, 0.2, 0.0}, {1.6, 3.0, 0.0}});
  const Result<ChosenFootholds> choice = ChooseFootholds(ground, rigid_bodies::Walker(2.0));
  ASSERT_FALSE(choice.ok());
  EXPECT_EQ(choice.failure().code, FailureCode::kOutOfReach);
  for (const char* part : {"foot ", "on the ground from ", " outside its workspace at "})
    EXPECT_NE(choice.failure().message.find(part), std::string::npos) << choice.failure().message;
  EXPECT_TRUE(ChooseFootholds(ground, rigid_bodies::Walker(2.0), {.infeasible_m = 10.0}).ok());
}

TEST(ChooseFootholds, RefusesAGoalAtWhichAFootReachesNoGround) {
  RigidBodyProblem problem = rigid_bodies::Walker(0.6);
  problem.goal.p_WC.z() += 0.17;  // its workspaces are 0.15 m high
  const Result<ChosenFootholds> choice = ChooseFootholds(FlatTerrain(), problem);
  ASSERT_FALSE(choice.ok());
  EXPECT_EQ(choice.failure().message, "at the goal, foot 0 is 0.020 m outside its workspace on every patch");
}

TEST(ChooseFootholds, RefusesGroundWithoutPatches) {
  const Result<ChosenFootholds> choice = ChooseFootholds(Terrain{"nothing", {}, {}, {}}, rigid_bodies::Walker());
  ASSERT_FALSE(choice.ok());
  EXPECT_EQ(choice.failure().message, "ground 'nothing' has no patch with space for a foot 0.010 m from its edges");
  const Result<ChosenFootholds> narrow = ChooseFootholds(Strips({{-0.01, 0.008, 0.0}}), rigid_bodies::Walker());
  ASSERT_FALSE(narrow.ok());
  EXPECT_EQ(narrow.failure().code, FailureCode::kNoPatches);
}

}  // namespace
}  // namespace gaitwright
