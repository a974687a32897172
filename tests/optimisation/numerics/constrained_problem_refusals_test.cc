// SPDX-License-Identifier: BSD-3-Clause
// Problems that Solve refuses, and results that are not solutions.
#include <gtest/gtest.h>

#include <cmath>

#include "optimisation/numerics/constrained_problem.h"
#include "tests/optimisation/numerics/by_values.h"

namespace gaitwright {
namespace {

using by_values::Of;
using by_values::Values;
using by_values::Vec;

TEST(ConstrainedProblem, RefusesVariablesNamedTwiceOrNotThere) {
  ConstrainedProblem problem;
  problem.start = Vec({0.0, 0.0});
  const auto message = [&](std::vector<int> variables) -> std::string {
    problem.residuals = {{Of([](const VectorX& x) { return Values{x[0]}; }), std::move(variables)}};
    try {
      (void)Solve(problem);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message({1, 1}), "Solve: a list of variables names 1 twice");
  EXPECT_EQ(message({0, 2}), "Solve: a list of variables names 2; accepted: 0 to 1");
  EXPECT_EQ(message({0, 1}), "");
}

std::string ReasonRefused(const ConstrainedProblem& problem) {
  try {
    (void)Solve(problem);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(ConstrainedProblem, RefusesWhatIsNotFiniteAtTheStart) {
  ConstrainedProblem problem;
  problem.start = Vec({1.0});
  problem.residuals = {{Of([](const VectorX& x) { return Values{x[0]}; })}};
  problem.constraints = {
      {"a logarithm", Of([](const VectorX& x) { return Values{std::log(x[0] - 2.0)}; }), Vec({0.0}), Vec({0.0})}};
  EXPECT_EQ(ReasonRefused(problem), "Solve: constraint 'a logarithm' is not finite at the start");
  problem.start = Vec({2.5});
  const Result<ConstrainedSolution> solution = Solve(problem);
  ASSERT_TRUE(solution.ok()) << solution.failure().message;
  EXPECT_NEAR(solution->x[0], 3.0, 1e-7);
  problem.residuals = {{Of([](const VectorX& x) { return Values{std::sqrt(x[0] - 3.0)}; })}};
  EXPECT_EQ(ReasonRefused(problem), "Solve: a residual is not finite at the start");
}

TEST(ConstrainedProblem, RefusesIntervalsThatAreNone) {
  ConstrainedProblem problem;
  problem.start = Vec({1.0});
  problem.residuals = {{Of([](const VectorX& x) { return Values{x[0]}; })}};
  problem.lower = Vec({2.0});
  problem.upper = Vec({1.0});
  EXPECT_NE(ReasonRefused(problem).find("the bounds: bounds 0 are 2 (lower) and 1 (upper)"), std::string::npos);
  problem.upper = Vec({3.0, 3.0});
  EXPECT_NE(ReasonRefused(problem).find("the bounds: 1 lower and 2 upper"), std::string::npos);
  problem.lower = problem.upper = VectorX();
  problem.constraints = {{"c", Of([](const VectorX& x) { return Values{x[0]}; }), Vec({0.0}), VectorX()}};
  EXPECT_NE(ReasonRefused(problem).find("constraint 'c': 1 lower and 0 upper"), std::string::npos);
}

TEST(ConstrainedProblem, ACostThatHasNotSettledIsNoSolution) {
  ConstrainedProblem problem;  // Rosenbrock's valley
  problem.start = Vec({-1.2, 1.0});
  problem.residuals = {{Of([](const VectorX& x) { return Values{10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]}; })}};
  ConstrainedOptions options;
  options.max_inner = 1;
  options.max_outer = 3;
  const Result<ConstrainedSolution> hasty = Solve(problem, options);
  ASSERT_FALSE(hasty.ok());
  EXPECT_EQ(hasty.failure().code, FailureCode::kUnsettledCost);
  EXPECT_NE(hasty.failure().message.find("after 3 updates"), std::string::npos) << hasty.failure().message;
  EXPECT_EQ(hasty.failure().message.find("unmet"), std::string::npos);
  const Result<ConstrainedSolution> patient = Solve(problem);
  ASSERT_TRUE(patient.ok()) << patient.failure().message;
  EXPECT_LT((patient->x - Vec({1.0, 1.0})).norm(), 1e-6);
}

}  // namespace
}  // namespace gaitwright
