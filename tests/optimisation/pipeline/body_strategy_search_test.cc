// SPDX-License-Identifier: BSD-3-Clause
// The search for a body posture, with artificial motions whose limit violation is a function of the posture.
#include "optimisation/pipeline/body_strategy_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace gaitwright {
namespace {

constexpr double kOutOfReach = std::numeric_limits<double>::infinity();

struct Tried {
  std::vector<BodyStrategy> strategies;
  Result<MotionPass> found = MotionPass{};
};

/// Runs the search over motions with the limit violation given by a function of the posture; infinite means out of
/// reach. Motions with at most `mended` are mended.
Tried Find(const BodyStrategyProblem& problem, const std::function<double(const BodyStrategy&)>& violation,
           double mended = 0.0) {
  Tried tried;
  const auto plan = [&](const BodyStrategy& strategy, double) -> Result<MotionPass> {
    tried.strategies.push_back(strategy);
    const double value = violation(strategy);
    if (value == kOutOfReach) return Failure{FailureKind::kInfeasible, FailureCode::kOutOfReach, "Made up", "", {}};
    MotionPass pass;
    pass.violation = value;
    return pass;
  };
  tried.found = FindBodyStrategy(problem, {plan, [&](const BodyStrategy& c) { return violation(c) != kOutOfReach; },
                                           [&](const MotionPass& pass) { return pass.violation <= mended; }});
  return tried;
}

BodyStrategyProblem Standing() {
  BodyStrategyProblem problem;
  problem.standing_m = 0.5;
  problem.zmp_inward = 0.1;
  return problem;
}

TEST(FindBodyStrategy, TakesThePreferredOneWhereItKeepsLimits) {
  const Tried tried = Find(Standing(), [](const BodyStrategy&) { return 0.0; });
  ASSERT_EQ(tried.strategies.size(), 1U);
  EXPECT_EQ(tried.strategies.front().com_height_m, 0.5);
  EXPECT_EQ(tried.strategies.front().zmp_inward, 0.1);
}

TEST(FindBodyStrategy, EndsWhereThePreferredOneIsMended) {
  const auto violation = [](const BodyStrategy& c) { return std::max(0.0, c.com_height_m - 0.45); };
  const Tried mended = Find(Standing(), violation, 0.1), not_mended = Find(Standing(), violation, 0.01);
  EXPECT_EQ(mended.strategies.size(), 1U);
  EXPECT_EQ(not_mended.strategies.size(), 6U);
}

TEST(FindBodyStrategy, LowersTheBodyUntilLimitsAreKept) {
  const Tried tried = Find(Standing(), [](const BodyStrategy& c) { return std::max(0.0, c.com_height_m - 0.45); });
  ASSERT_TRUE(tried.found.ok());
  EXPECT_EQ(tried.found->violation, 0.0);
  EXPECT_NEAR(tried.strategies.back().com_height_m, 0.45, 1e-9);
  EXPECT_EQ(tried.strategies.size(), 6U);
}

TEST(FindBodyStrategy, KeepsAHeightThatIsAskedFor) {
  BodyStrategyProblem problem = Standing();
  problem.asked_m = 0.48;
  const Tried tried = Find(problem, [](const BodyStrategy& c) { return c.com_height_m; });
  EXPECT_EQ(tried.strategies.size(), 1U);
  EXPECT_EQ(tried.found->violation, 0.48);
}

TEST(FindBodyStrategy, WhatDidNotHelpTheHigherBodyIsTriedWithTheLowerOne) {
  BodyStrategyProblem problem = Standing();
  problem.on_one_sole = true;
  // The ZMP farther inward helps a body that is low, and no other.
  const auto violation = [](const BodyStrategy& c) {
    const double high = std::max(0.01, c.com_height_m - 0.45);
    return c.zmp_inward > 0.15 ? (c.com_height_m < 0.47 ? 0.0 : 0.2) : high;
  };
  const Tried tried = Find(problem, violation);
  ASSERT_TRUE(tried.found.ok());
  EXPECT_EQ(tried.found->violation, 0.0);
  EXPECT_EQ(tried.strategies.back().zmp_inward, 0.2);
  EXPECT_LT(tried.strategies.back().com_height_m, 0.47);
}

TEST(FindBodyStrategy, TheZmpIsNotMovedInwardTwice) {
  BodyStrategyProblem problem = Standing();
  problem.on_one_sole = true;
  const Tried tried = Find(
      problem, [](const BodyStrategy& c) { return 0.02 + 0.1 * c.com_height_m - (c.zmp_inward > 0.15 ? 0.01 : 0.0); });
  for (const BodyStrategy& strategy : tried.strategies) EXPECT_LE(strategy.zmp_inward, 0.2);
}

TEST(FindBodyStrategy, GivesUpWhereLoweringCannotBeEnough) {
  const Tried tried = Find(Standing(), [](const BodyStrategy& c) { return 1.0 + 0.01 * c.com_height_m; });
  EXPECT_EQ(tried.strategies.size(), 2U);
}

TEST(FindBodyStrategy, GivesUpAfterHeightsWithoutGain) {
  const Tried tried = Find(Standing(), [](const BodyStrategy& c) { return 1.0 - c.com_height_m; });
  EXPECT_LE(tried.strategies.size(), 3U);
  EXPECT_EQ(tried.found->violation, 0.5) << "the least excess is kept";
}

TEST(FindBodyStrategy, WhatIsOutOfReachAtEveryHeightIsKnownByTheLowest) {
  const Tried tried = Find(Standing(), [](const BodyStrategy&) { return kOutOfReach; });
  ASSERT_FALSE(tried.found.ok());
  EXPECT_EQ(tried.found.failure().code, FailureCode::kOutOfReach);
  EXPECT_EQ(tried.strategies.size(), 1U);
}

TEST(FindBodyStrategy, LowersTheBodyToFeetThatAreOutOfReach) {
  const Tried tried = Find(Standing(), [](const BodyStrategy& c) { return c.com_height_m > 0.46 ? kOutOfReach : 0.0; });
  ASSERT_TRUE(tried.found.ok());
  EXPECT_NEAR(tried.strategies.back().com_height_m, 0.46, 1e-9);
}

TEST(FindBodyStrategy, OnOneSoleTheZmpRunsFartherInward) {
  BodyStrategyProblem problem = Standing();
  problem.on_one_sole = true;
  const Tried tried = Find(problem, [](const BodyStrategy& c) { return c.zmp_inward > 0.15 ? 0.0 : 0.02; });
  EXPECT_EQ(tried.found->violation, 0.0);
  EXPECT_EQ(tried.strategies.back().zmp_inward, 0.2);
  EXPECT_EQ(tried.strategies.size(), 2U);
}

TEST(FindBodyStrategy, OverUnevenGroundTheBodyBendsToItsFeetBeforeItLeans) {
  BodyStrategyProblem problem = Standing();
  problem.uneven = problem.on_one_sole = true;
  const Tried tried = Find(problem, [](const BodyStrategy& c) { return c.in_reach && c.lean_rad > 0.0 ? 0.0 : 0.02; });
  ASSERT_EQ(tried.strategies.size(), 3U);
  EXPECT_TRUE(tried.strategies[1].in_reach);
  EXPECT_EQ(tried.strategies[1].lean_rad, 0.0);
  EXPECT_GT(tried.strategies[2].lean_rad, 0.0);
  EXPECT_EQ(tried.strategies[2].zmp_inward, 0.1);
  EXPECT_EQ(tried.found->violation, 0.0);
}

TEST(FindBodyStrategy, AChangeThatDoesNotHelpIsGivenUp) {
  BodyStrategyProblem problem = Standing();
  problem.uneven = problem.on_one_sole = true;
  const Tried tried = Find(problem, [](const BodyStrategy& c) { return 0.02 + (c.in_reach ? 0.01 : 0.0); });
  ASSERT_GE(tried.strategies.size(), 4U);
  EXPECT_FALSE(tried.strategies[3].in_reach);
  EXPECT_EQ(tried.strategies[3].lean_rad, 0.0);
  EXPECT_EQ(tried.strategies[3].zmp_inward, 0.2);
}

TEST(FindBodyStrategy, OtherFailuresEndTheSearch) {
  int tries = 0;
  const auto plan = [&](const BodyStrategy&, double) -> Result<MotionPass> {
    ++tries;
    return Failure{FailureKind::kInfeasible, FailureCode::kNoSupport, "Made up", "", {}};
  };
  const Result<MotionPass> found = FindBodyStrategy(
      Standing(), {plan, [](const BodyStrategy&) { return true; }, [](const MotionPass&) { return false; }});
  EXPECT_EQ(found.failure().code, FailureCode::kNoSupport);
  EXPECT_EQ(tries, 1);
}

}  // namespace
}  // namespace gaitwright
