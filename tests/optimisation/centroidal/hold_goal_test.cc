// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/hold_goal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimisation/centroidal/choose_footholds.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// The normal of ground that slopes down towards a heading.
Vector3 Falling(double heading, double slope) {
  return Vector3(slope * std::cos(heading), slope * std::sin(heading), 1.0).normalized();
}

TEST(LeastHoldingFriction, OnOneSlopeIsItsTangent) {
  EXPECT_NEAR(LeastHoldingFriction({Vector3::UnitZ()}), 0.0, 1e-3);
  for (const double slope : {0.2, 0.7, 3.0}) {
    EXPECT_NEAR(LeastHoldingFriction({Falling(0.5, slope)}), slope, 1e-3 * (1.0 + slope * slope));
    EXPECT_NEAR(LeastHoldingFriction({Falling(0.5, slope), Falling(0.5, 2.0 * slope)}), slope,
                1e-3 * (1.0 + slope * slope));
  }
}

TEST(LeastHoldingFriction, AstrideARidgeOrBetweenWallsNoneIsNeeded) {
  EXPECT_NEAR(LeastHoldingFriction({Falling(0.0, 0.7), Falling(M_PI, 0.7)}), 0.0, 2e-2);
  EXPECT_NEAR(LeastHoldingFriction({Falling(0.0, 0.7), Falling(2.1, 0.7), Falling(4.2, 0.7)}), 0.0, 1e-3);
  // Slopes at right angles: halfway between, both slope down by 0.7 / sqrt(2).
  const double across = LeastHoldingFriction({Falling(0.0, 0.7), Falling(0.5 * M_PI, 0.7)});
  EXPECT_GT(across, 0.3);
  EXPECT_LT(across, 0.5);
}

TEST(LeastHoldingFriction, IsInfiniteWhereThereIsNoGround) {
  EXPECT_TRUE(std::isinf(LeastHoldingFriction({})));
  EXPECT_TRUE(std::isinf(LeastHoldingFriction({Falling(0.0, 3.0)}, 2.0)));
}

/// A ridge along y at x = 0.6, its sides falling by 0.6.
Terrain Ridge() {
  Terrain ground;
  ground.name = "ridge";
  ground.patches.push_back(
      PatchThrough("near", {{-1.0, -2.0, -0.96}, {0.6, -2.0, 0.0}, {0.6, 2.0, 0.0}, {-1.0, 2.0, -0.96}}, 0.5));
  ground.patches.push_back(
      PatchThrough("far", {{0.6, -2.0, 0.0}, {2.2, -2.0, -0.96}, {2.2, 2.0, -0.96}, {0.6, 2.0, 0.0}}, 0.5));
  return ground;
}

TEST(LookAtGoal, ABodyIsHeldAstrideARidgeButNotOnItsSide) {
  RigidBodyProblem problem = rigid_bodies::Walker(0.6);
  const GoalGround astride = LookAtGoal(Ridge(), problem, 0.01, 0.005);
  EXPECT_EQ(astride.foot, -1);
  EXPECT_LT(astride.needed_friction, 0.1);
  problem.goal.p_WC += Vector3(0.8, 0.0, -0.48);
  const GoalGround beside = LookAtGoal(Ridge(), problem, 0.01, 0.005);
  EXPECT_EQ(beside.foot, -1);
  EXPECT_EQ(beside.friction, 0.5);
  EXPECT_NEAR(beside.needed_friction, 0.6, 1e-3);
  const Result<ChosenFootholds> choice = ChooseFootholds(Ridge(), problem);
  ASSERT_FALSE(choice.ok());
  EXPECT_EQ(choice.failure().code, FailureCode::kGoalNotHeld);
  EXPECT_NE(choice.failure().message.find("too steep for a friction of 0.50; 0.60 is needed"), std::string::npos)
      << choice.failure().message;
  // A single foot stands on one side only.
  problem = rigid_bodies::Hopper(0.6);
  EXPECT_NEAR(LookAtGoal(Ridge(), problem, 0.01, 0.005).needed_friction, 0.6, 1e-3);
  // A body that moves on from there need not be held.
  problem.goal.v_WC.x() = 1.0;
  EXPECT_EQ(LookAtGoal(Ridge(), problem, 0.01, 0.005).needed_friction, 0.0);
}

}  // namespace
}  // namespace gaitwright
