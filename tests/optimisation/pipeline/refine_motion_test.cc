// SPDX-License-Identifier: BSD-3-Clause
// Refinement with made-up judges: what is planned again after which verdict.
#include "optimisation/pipeline/refine_motion.h"

#include <gtest/gtest.h>

#include "optimisation/swing/free_swings.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// A hop on level ground.
const PlanOverPatches& Hop() {
  static const PlanOverPatches hop = *PlanOverTerrain(FlatTerrain(0.6), rigid_bodies::Hopper());
  return hop;
}

RefineRules RulesOnLevelGround(const Terrain& ground) {
  RefineRules rules;
  rules.patches = RulesOf(ground, 0.01);
  return rules;
}

/// The hop's swing with a lift, as an unknown.
std::vector<RigidSwing> LiftedSwing(const Terrain& ground, const PlanOverPatches& motion) {
  SwingTrajectory swing;
  swing.start_s = 0.5;
  swing.end_s = 0.75;
  swing.X_WF_start = motion.plan.motion.X_WF[0];
  swing.X_WF_end = motion.plan.motion.X_WF[1];
  swing.lift_m = 0.05;
  return FreeSwingsOf(ground, motion.choice.problem, {swing}, {0});
}

TEST(RefineMotion, LeavesWhatPassesAsItIs) {
  const Terrain ground = FlatTerrain(0.6);
  int judged = 0;
  const Result<RefinedMotion> refined =
      RefineMotion(ground, Hop(), {}, RulesOnLevelGround(ground), [&](const PlanOverPatches&) {
        ++judged;
        return Result<MotionVerdict>(MotionVerdict{true});
      });
  ASSERT_TRUE(refined.ok());
  EXPECT_TRUE(refined->passes);
  EXPECT_EQ(judged, 1);
  EXPECT_EQ(refined->motion.plan.numbers.x, Hop().plan.numbers.x);
}

TEST(RefineMotion, HalvesTheNodeSpacingTwiceAndThenSaysThatThisDoesNotHelp) {
  const Terrain ground = FlatTerrain(0.6);
  std::vector<std::size_t> nodes;
  const auto judge = [&](const PlanOverPatches& motion) {
    nodes.push_back(motion.plan.numbers.nodes_s.size());
    return Result<MotionVerdict>(MotionVerdict{false});
  };
  const Result<RefinedMotion> refined = RefineMotion(ground, Hop(), {}, RulesOnLevelGround(ground), judge);
  ASSERT_TRUE(refined.ok());
  EXPECT_FALSE(refined->passes);
  EXPECT_EQ(refined->halvings, 2);
  EXPECT_EQ(refined->swings_planned, 0) << "no swing is out of reach";
  EXPECT_NE(refined->refusal, "");
  ASSERT_EQ(nodes.size(), 3U);
  EXPECT_LT(nodes[0], nodes[1]);
  EXPECT_LT(nodes[1], nodes[2]);
}

TEST(RefineMotion, PlansSwingsOutOfReachTogetherWithTheBody) {
  const Terrain ground = FlatTerrain(0.6);
  RefineRules rules = RulesOnLevelGround(ground);
  rules.most_halvings = 0;
  const auto judge = [&](const PlanOverPatches& motion) {
    const bool along = !motion.choice.problem.swings.empty();
    return Result<MotionVerdict>(MotionVerdict{along, along ? 0.0 : 0.01, LiftedSwing(ground, motion)});
  };
  const Result<RefinedMotion> refined = RefineMotion(ground, Hop(), {}, rules, judge);
  ASSERT_TRUE(refined.ok());
  EXPECT_TRUE(refined->passes) << refined->refusal;
  EXPECT_EQ(refined->swings_planned, 1);
  EXPECT_EQ(refined->halvings, 0);
  ASSERT_EQ(refined->motion.plan.motion.detours_W.size(), 1U);
  EXPECT_EQ(refined->motion.plan.motion.detours_W[0].size(), 8U);
}

TEST(RefineMotion, OnlyChecksInNoRoundsAndHandsOnFailures) {
  const Terrain ground = FlatTerrain(0.6);
  RefineRules rules = RulesOnLevelGround(ground);
  rules.most_rounds = 0;
  const Result<RefinedMotion> checked = RefineMotion(
      ground, Hop(), {}, rules, [](const PlanOverPatches&) { return Result<MotionVerdict>(MotionVerdict{}); });
  ASSERT_TRUE(checked.ok());
  EXPECT_FALSE(checked->passes);
  EXPECT_EQ(checked->halvings, 0);
  const Result<RefinedMotion> failed =
      RefineMotion(ground, Hop(), {}, rules, [](const PlanOverPatches&) -> Result<MotionVerdict> {
        return Failure{FailureKind::kInfeasible, FailureCode::kNoClearance, "made up", "", {}};
      });
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.failure().code, FailureCode::kNoClearance);
}

}  // namespace
}  // namespace gaitwright
