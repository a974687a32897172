// SPDX-License-Identifier: BSD-3-Clause
// Candidates of real walks: each is planned once, traced, and refused after the budget.
#include "optimisation/search/walk_evaluator.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "planning/terrain/load_terrain.h"

namespace gaitwright {
namespace {

class WalkEvaluatorTest : public ::testing::Test {
 protected:
  WalkEvaluatorTest() : a1_(*LoadNamedRobot("a1")), terrain_(*LoadTerrain("flat", ScaleOf(a1_))) {
    request_.gait = "trot";
    request_.command.speed_m_s = 0.4;
    request_.command.distance_m = 0.3;
  }

  const RobotModel a1_;
  const Terrain terrain_;
  WalkRequest request_;
  SearchTrace trace_;
};

TEST_F(WalkEvaluatorTest, PlansEachCandidateOnce) {
  WalkEvaluator evaluator(a1_, terrain_, request_, &trace_);
  const Evaluation first = evaluator.Evaluate({0.4}, Effort::kWhole);
  ASSERT_TRUE(first.sound());
  ASSERT_NE(first.planned, nullptr);
  EXPECT_TRUE(first.planned->audit.pass());
  EXPECT_TRUE(evaluator.Evaluate({0.4}, Effort::kWhole).sound());
  EXPECT_EQ(trace_.size(), 1U);
  EXPECT_TRUE(evaluator.Evaluate({0.4}, Effort::kStart).sound());
  ASSERT_EQ(trace_.size(), 2U);
  EXPECT_EQ(trace_.back().effort, Effort::kStart);
}

/// A walk of 0.3 m is little longer than its start: with the whole body optimised, only the whole walk is planned.
TEST_F(WalkEvaluatorTest, AShortWalkWithItsWholeBodyIsPlannedWhole) {
  WalkEvaluator evaluator(a1_, terrain_, request_, &trace_);
  const Candidate finished{0.4, 0, 1.0, false, true};
  EXPECT_TRUE(evaluator.Evaluate(finished, Effort::kStart).sound());
  const Evaluation whole = evaluator.Evaluate(finished, Effort::kWhole);
  ASSERT_TRUE(whole.sound());
  EXPECT_NE(whole.planned, nullptr);
  ASSERT_EQ(trace_.size(), 1U);
  EXPECT_EQ(trace_.back().effort, Effort::kWhole);
  request_.command.distance_m = 3.0;
  WalkEvaluator longer(a1_, terrain_, request_, &trace_);
  EXPECT_TRUE(longer.Evaluate(finished, Effort::kStart).sound());
  EXPECT_EQ(trace_.back().effort, Effort::kStart);
}

TEST_F(WalkEvaluatorTest, ACandidateIsTheRequestWithItsPaceCycleAndFlight) {
  const WalkEvaluator evaluator(a1_, terrain_, request_, nullptr);
  EXPECT_EQ(evaluator.CommandOf({0.4}), request_.command);
  EXPECT_EQ(evaluator.CommandOf({0.2}).speed_m_s, 0.2);
  const Result<GaitCycles> cycles = evaluator.CyclesOf({0.4});
  ASSERT_TRUE(cycles.ok());
  EXPECT_EQ(evaluator.GaitOf({0.4}, *cycles), cycles->fitted);
  EXPECT_LT(evaluator.GaitOf({0.4, 2}, *cycles).cycle_s, cycles->fitted.cycle_s);
  EXPECT_GT(evaluator.GaitOf({0.4, -2}, *cycles).cycle_s, cycles->fitted.cycle_s);
  const double duty = cycles->fitted.duty_factor.front();
  EXPECT_NEAR(1.0 - evaluator.GaitOf({0.4, 0, 0.5}, *cycles).duty_factor.front(), 0.5 * (1.0 - duty), 1e-12);
}

TEST_F(WalkEvaluatorTest, RefusesWhatIsPastTheBudget) {
  request_.search.max_plans = 1;
  WalkEvaluator evaluator(a1_, terrain_, request_, &trace_);
  EXPECT_TRUE(evaluator.Evaluate({0.4}, Effort::kWhole).sound());
  const Evaluation refused = evaluator.Evaluate({0.2}, Effort::kWhole);
  ASSERT_FALSE(refused.sound());
  EXPECT_EQ(refused.refusal->code, FailureCode::kSearchBudget);
  EXPECT_TRUE(refused.at_every_pace);
  EXPECT_TRUE(evaluator.Evaluate({0.4}, Effort::kWhole).sound()) << "it is known";
  EXPECT_EQ(trace_.size(), 1U);
}

TEST_F(WalkEvaluatorTest, OnlyFastGaitsOrAskedForBodiesAreThoseOfARigidBody) {
  WalkEvaluator slow(a1_, terrain_, request_, nullptr);
  EXPECT_FALSE(slow.Flies({0.4}));
  request_.motion.centre_of_mass.method = "rigid-body";
  WalkEvaluator rigid(a1_, terrain_, request_, nullptr);
  EXPECT_TRUE(rigid.Flies({0.4}));
  request_.motion.centre_of_mass.method = "optimised";
  request_.gait = "bound";
  WalkEvaluator bound(a1_, terrain_, request_, nullptr);
  EXPECT_TRUE(bound.Flies({0.4}));
}

}  // namespace
}  // namespace gaitwright
