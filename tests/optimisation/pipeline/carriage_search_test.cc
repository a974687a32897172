// SPDX-License-Identifier: BSD-3-Clause
// The search for a body posture, with artificial motions whose limit violation is a function of the posture.
#include "optimisation/pipeline/carriage_search.h"

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
  std::vector<Carriage> carriages;
  Result<MotionPass> found = MotionPass{};
};

/// Runs the search over motions with the limit violation given by a function of the posture; infinite means out of
/// reach.
Tried Find(const CarriageProblem& problem, const std::function<double(const Carriage&)>& excess) {
  Tried tried;
  const auto plan = [&](const Carriage& carriage, double) -> Result<MotionPass> {
    tried.carriages.push_back(carriage);
    const double value = excess(carriage);
    if (value == kOutOfReach) return Failure{FailureKind::kInfeasible, FailureCode::kOutOfReach, "Made up", "", {}};
    MotionPass pass;
    pass.excess = value;
    return pass;
  };
  tried.found = FindCarriage(problem, {plan, [&](const Carriage& c) { return excess(c) != kOutOfReach; }});
  return tried;
}

CarriageProblem Standing() {
  CarriageProblem problem;
  problem.standing_m = 0.5;
  problem.zmp_inward = 0.1;
  return problem;
}

TEST(FindCarriage, TakesThePreferredOneWhereItKeepsLimits) {
  const Tried tried = Find(Standing(), [](const Carriage&) { return 0.0; });
  ASSERT_EQ(tried.carriages.size(), 1U);
  EXPECT_EQ(tried.carriages.front().com_height_m, 0.5);
  EXPECT_EQ(tried.carriages.front().zmp_inward, 0.1);
}

TEST(FindCarriage, LowersTheBodyUntilLimitsAreKept) {
  const Tried tried = Find(Standing(), [](const Carriage& c) { return std::max(0.0, c.com_height_m - 0.45); });
  ASSERT_TRUE(tried.found.ok());
  EXPECT_EQ(tried.found->excess, 0.0);
  EXPECT_NEAR(tried.carriages.back().com_height_m, 0.45, 1e-9);
  EXPECT_EQ(tried.carriages.size(), 6U);
}

TEST(FindCarriage, KeepsAHeightThatIsAskedFor) {
  CarriageProblem problem = Standing();
  problem.asked_m = 0.48;
  const Tried tried = Find(problem, [](const Carriage& c) { return c.com_height_m; });
  EXPECT_EQ(tried.carriages.size(), 1U);
  EXPECT_EQ(tried.found->excess, 0.48);
}

TEST(FindCarriage, GivesUpWhereLoweringCannotBeEnough) {
  const Tried tried = Find(Standing(), [](const Carriage& c) { return 1.0 + 0.01 * c.com_height_m; });
  EXPECT_EQ(tried.carriages.size(), 2U);
}

TEST(FindCarriage, GivesUpAfterHeightsWithoutGain) {
  const Tried tried = Find(Standing(), [](const Carriage& c) { return 1.0 - c.com_height_m; });
  EXPECT_LE(tried.carriages.size(), 3U);
  EXPECT_EQ(tried.found->excess, 0.5) << "the least excess is kept";
}

TEST(FindCarriage, WhatIsOutOfReachAtEveryHeightIsKnownByTheLowest) {
  const Tried tried = Find(Standing(), [](const Carriage&) { return kOutOfReach; });
  ASSERT_FALSE(tried.found.ok());
  EXPECT_EQ(tried.found.failure().code, FailureCode::kOutOfReach);
  EXPECT_EQ(tried.carriages.size(), 1U);
}

TEST(FindCarriage, LowersTheBodyToFeetThatAreOutOfReach) {
  const Tried tried = Find(Standing(), [](const Carriage& c) { return c.com_height_m > 0.46 ? kOutOfReach : 0.0; });
  ASSERT_TRUE(tried.found.ok());
  EXPECT_NEAR(tried.carriages.back().com_height_m, 0.46, 1e-9);
}

TEST(FindCarriage, OnOneSoleTheZmpRunsFartherInward) {
  CarriageProblem problem = Standing();
  problem.on_one_sole = true;
  const Tried tried = Find(problem, [](const Carriage& c) { return c.zmp_inward > 0.15 ? 0.0 : 0.02; });
  EXPECT_EQ(tried.found->excess, 0.0);
  EXPECT_EQ(tried.carriages.back().zmp_inward, 0.2);
  EXPECT_EQ(tried.carriages.size(), 2U);
}

TEST(FindCarriage, OverUnevenGroundTheBodyBendsToItsFeetBeforeItLeans) {
  CarriageProblem problem = Standing();
  problem.uneven = problem.on_one_sole = true;
  const Tried tried = Find(problem, [](const Carriage& c) { return c.in_reach && c.lean_rad > 0.0 ? 0.0 : 0.02; });
  ASSERT_EQ(tried.carriages.size(), 3U);
  EXPECT_TRUE(tried.carriages[1].in_reach);
  EXPECT_EQ(tried.carriages[1].lean_rad, 0.0);
  EXPECT_GT(tried.carriages[2].lean_rad, 0.0);
  EXPECT_EQ(tried.carriages[2].zmp_inward, 0.1);
  EXPECT_EQ(tried.found->excess, 0.0);
}

TEST(FindCarriage, AChangeThatDoesNotHelpIsGivenUp) {
  CarriageProblem problem = Standing();
  problem.uneven = problem.on_one_sole = true;
  const Tried tried = Find(problem, [](const Carriage& c) { return 0.02 + (c.in_reach ? 0.01 : 0.0); });
  ASSERT_GE(tried.carriages.size(), 4U);
  EXPECT_FALSE(tried.carriages[3].in_reach);
  EXPECT_EQ(tried.carriages[3].lean_rad, 0.0);
  EXPECT_EQ(tried.carriages[3].zmp_inward, 0.2);
}

TEST(FindCarriage, OtherFailuresEndTheSearch) {
  int tries = 0;
  const auto plan = [&](const Carriage&, double) -> Result<MotionPass> {
    ++tries;
    return Failure{FailureKind::kInfeasible, FailureCode::kNoSupport, "Made up", "", {}};
  };
  const Result<MotionPass> found = FindCarriage(Standing(), {plan, [](const Carriage&) { return true; }});
  EXPECT_EQ(found.failure().code, FailureCode::kNoSupport);
  EXPECT_EQ(tries, 1);
}

}  // namespace
}  // namespace gaitwright
