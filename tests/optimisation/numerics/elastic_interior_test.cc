// SPDX-License-Identifier: BSD-3-Clause
// Known answers: Hock and Schittkowski, Test Examples for Nonlinear Programming Codes, Springer 1981; others in closed
// form, or from Solve.
#include "optimisation/numerics/elastic_interior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "kinematics/base/non_finite.h"
#include "tests/optimisation/numerics/by_values.h"

namespace gaitwright {
namespace {

using by_values::Of;
using by_values::Values;
using by_values::Vec;

/// The squared distance from a point: |x - wanted|^2.
Residual To(const Values& wanted) {
  return Of([wanted](const VectorX& x) {
    Values off;
    for (std::size_t i = 0; i < wanted.size(); ++i) off.push_back(x[static_cast<Eigen::Index>(i)] - wanted[i]);
    return off;
  });
}

ConstrainedSolution Solved(const ConstrainedProblem& problem, const ElasticOptions& options = {}) {
  const Result<ConstrainedSolution> solution = SolveElastic(problem, options);
  EXPECT_TRUE(solution.ok()) << solution.failure().message;
  return solution.ok() ? *solution : ConstrainedSolution{};
}

TEST(SolveElastic, ThePointOfASquareNearestToOneOutside) {
  ConstrainedProblem problem{Vec({0.0, 0.0}), {To({2.0, 0.3})}, {}, {}, {}};
  problem.constraints.push_back({"square", Of([](const VectorX& x) {
                                   return Values{x[0], x[1]};
                                 }),
                                 Vec({-1.0, -1.0}), Vec({1.0, 1.0})});
  const ConstrainedSolution at = Solved(problem);
  EXPECT_NEAR(at.x[0], 1.0, 1e-5);
  EXPECT_NEAR(at.x[1], 0.3, 1e-3);
  EXPECT_NEAR(at.cost, 1.0, 1e-4);
  EXPECT_LE(at.violation, 1e-8);
}

/// An equality in small units has a large multiplier. With a large `give` the multiplier grows over many steps, each of
/// which takes only a third off the equality's error; the line search must not count on more.
TEST(SolveElastic, EqualitiesThatYieldDoNotStopTheLineSearch) {
  ConstrainedProblem problem{Vec({-1.2, 1.0}), {To({1.5, 1.0})}, {}, {}, {}};
  constexpr double kUnit = 5e-3;
  problem.constraints.push_back(
      {"line", Of([](const VectorX& x) { return Values{kUnit * (x[0] + x[1])}; }), Vec({0.0}), Vec({0.0})});
  ElasticOptions options;
  options.give = 1e-4;
  options.tolerance = 1e-5;
  const ConstrainedSolution at = Solved(problem, options);
  EXPECT_NEAR(at.x[0], 0.25, 2e-3);
  EXPECT_NEAR(at.x[1], -0.25, 2e-3);
  EXPECT_LT(at.iterations, 40);
}

TEST(SolveElastic, KnownAnswersOfProblemsThatAreNotConvex) {
  ConstrainedProblem hs14{Vec({2.0, 2.0}), {To({2.0, 1.0})}, {}, {}, {}};
  hs14.constraints.push_back(
      {"line", Of([](const VectorX& x) { return Values{x[0] - 2.0 * x[1] + 1.0}; }), Vec({0.0}), Vec({0.0})});
  hs14.constraints.push_back({"ellipse", Of([](const VectorX& x) { return Values{0.25 * x[0] * x[0] + x[1] * x[1]}; }),
                              Vec({-kInfinity}), Vec({1.0})});
  EXPECT_NEAR(Solved(hs14).cost, 9.0 - 2.875 * std::sqrt(7.0), 1e-4);
  ConstrainedProblem hs6{Vec({-1.2, 1.0}), {Of([](const VectorX& x) { return Values{1.0 - x[0]}; })}, {}, {}, {}};
  hs6.constraints.push_back(
      {"parabola", Of([](const VectorX& x) { return Values{10.0 * (x[1] - x[0] * x[0])}; }), Vec({0.0}), Vec({0.0})});
  EXPECT_NEAR(Solved(hs6).x[0], 1.0, 1e-3);
}

TEST(SolveElastic, IsWhereSolveIs) {
  // A chain from (0, 0) to (1, 0) with pulling links, above a bump.
  constexpr int kLinks = 40;
  ConstrainedProblem problem;
  problem.start = VectorX::Constant(kLinks - 1, 0.6);
  for (int i = 0; i < kLinks; ++i) {
    std::vector<int> seen;
    if (i > 0) seen.push_back(i - 1);
    if (i + 1 < kLinks) seen.push_back(i);
    const bool inside = seen.size() == 2;
    problem.residuals.emplace_back(Of([inside](const VectorX& x) { return Values{inside ? x[1] - x[0] : x[0]}; }),
                                   seen);
    problem.residuals.back().affine = true;
    if (!inside) continue;
    const double u = static_cast<double>(i) / kLinks, least = 0.5 - 4.0 * (u - 0.4) * (u - 0.4);
    problem.constraints.push_back(
        {"bump", Of([](const VectorX& x) { return Values{x[0]}; }), Vec({least}), Vec({kInfinity}), {i - 1}, true});
  }
  const ConstrainedSolution at = Solved(problem, {.cost_tolerance = 1e-8});
  const Result<ConstrainedSolution> other = Solve(problem, {.tolerance = 1e-7});
  ASSERT_TRUE(other.ok());
  EXPECT_GT(other->cost, 0.01);
  EXPECT_NEAR(at.cost, other->cost, 1e-5 * other->cost);
  EXPECT_LT((at.x - other->x).lpNorm<Eigen::Infinity>(), 1e-3);
  EXPECT_LT(at.iterations, 20);
}

/// Compares multipliers with the change of the cost when bounds move, for either solver.
void ExpectMultipliersByMovedEnds(const std::function<ConstrainedSolution(const ConstrainedProblem&)>& solve) {
  // The point nearest to (2, 3, -1) on a plane, below an upper bound and above a lower one; one row is inactive.
  const auto solved = [&](double plane, double upper, double lower) {
    ConstrainedProblem problem{Vec({0.0, 0.0, 0.0}), {To({2.0, 3.0, -1.0})}, {}, {}, {}};
    problem.constraints.push_back(
        {"plane", Of([](const VectorX& x) { return Values{x[0] + x[1] * x[2]}; }), Vec({plane}), Vec({plane})});
    problem.constraints.push_back({"ends", Of([](const VectorX& x) {
                                     return Values{x[1], x[2], x[0]};
                                   }),
                                   Vec({-kInfinity, lower, -kInfinity}), Vec({upper, kInfinity, 50.0})});
    return solve(problem);
  };
  const ConstrainedSolution at = solved(0.5, 2.0, -0.5);
  ASSERT_EQ(at.multipliers.size(), 4);
  constexpr double kStep = 1e-3;
  const double by_plane = solved(0.5 + kStep, 2.0, -0.5).cost - solved(0.5 - kStep, 2.0, -0.5).cost;
  const double by_upper = solved(0.5, 2.0 + kStep, -0.5).cost - solved(0.5, 2.0 - kStep, -0.5).cost;
  const double by_lower = solved(0.5, 2.0, -0.5 + kStep).cost - solved(0.5, 2.0, -0.5 - kStep).cost;
  EXPECT_GT(std::abs(by_plane), 1e-4);
  EXPECT_LT(by_upper, -1e-4);
  EXPECT_GT(by_lower, 1e-4);
  EXPECT_NEAR(at.multipliers[0], -by_plane / (2.0 * kStep), 1e-3);
  EXPECT_NEAR(at.multipliers[1], -by_upper / (2.0 * kStep), 1e-3);
  EXPECT_NEAR(at.multipliers[2], -by_lower / (2.0 * kStep), 1e-3);
  EXPECT_NEAR(at.multipliers[3], 0.0, 1e-6);
}

TEST(SolveElastic, MultipliersAreWhatTheCostFallsByAsEndsAreMoved) {
  ExpectMultipliersByMovedEnds(
      [](const ConstrainedProblem& problem) { return Solved(problem, {.cost_tolerance = 1e-10}); });
}

TEST(Solve, MultipliersAreWhatTheCostFallsByAsEndsAreMoved) {
  ExpectMultipliersByMovedEnds([](const ConstrainedProblem& problem) {
    const Result<ConstrainedSolution> solution = Solve(problem);
    EXPECT_TRUE(solution.ok()) << solution.failure().message;
    return solution.ok() ? *solution : ConstrainedSolution{};
  });
}

TEST(SolveElastic, PaysWhatAConstraintIsWorth) {
  // The multiplier at x = 0 is 1000, more than the initial penalty weight.
  ConstrainedProblem problem{
      Vec({0.5}), {Of([](const VectorX& x) { return Values{30.0 * (x[0] - 1.0)}; })}, {}, {}, {}};
  problem.constraints.push_back(
      {"at most", Of([](const VectorX& x) { return Values{x[0]}; }), Vec({-kInfinity}), Vec({0.0})});
  const ConstrainedSolution at = Solved(problem, {.penalty = 1.0, .max_penalty = 1e4});
  EXPECT_NEAR(at.x[0], 0.0, 1e-6);
  EXPECT_GT(at.outer, 1);
  ConstrainedSolution last;
  const Result<ConstrainedSolution> poor = SolveElastic(problem, {.penalty = 1.0, .max_penalty = 90.0}, &last);
  ASSERT_FALSE(poor.ok());
  EXPECT_NEAR(last.x[0], 0.9, 1e-3);  // 900 (1 - x) = 90
}

TEST(SolveElastic, WhereThereIsNoSolutionViolationsAreLeast) {
  // 0.1 (x - 5)^2 with x <= 0, y <= 0 and x + y = 3: the sum of violations is 3, however it is divided.
  ConstrainedProblem problem{
      Vec({1.0, 1.0}), {Of([](const VectorX& x) { return Values{0.3 * (x[0] - 5.0)}; })}, {}, {}, {}};
  problem.constraints.push_back(
      {"sum", Of([](const VectorX& x) { return Values{x[0] + x[1]}; }), Vec({3.0}), Vec({3.0})});
  problem.constraints.push_back(
      {"x", Of([](const VectorX& x) { return Values{x[0]}; }), Vec({-kInfinity}), Vec({0.0})});
  problem.constraints.push_back(
      {"y", Of([](const VectorX& x) { return Values{x[1]}; }), Vec({-kInfinity}), Vec({0.0})});
  ConstrainedSolution last;
  const Result<ConstrainedSolution> solution = SolveElastic(problem, {}, &last);
  ASSERT_FALSE(solution.ok());
  EXPECT_EQ(solution.failure().code, FailureCode::kUnmetConstraint);
  EXPECT_NE(solution.failure().message.find("constraint 'x' stays violated by"), std::string::npos)
      << solution.failure().message;
  EXPECT_TRUE(last.least);
  EXPECT_NEAR(last.violations, 3.0, 1e-4);
  ASSERT_FALSE(last.unmet.empty());
  EXPECT_EQ(last.unmet.front().first, last.worst_constraint);
  EXPECT_EQ(last.unmet.front().second, last.violation);
  EXPECT_NEAR(std::max(last.x[0], 0.0) + std::max(last.x[1], 0.0), 3.0, 1e-4);
  EXPECT_NEAR(last.x[0] + last.x[1], 3.0, 1e-6);
}

/// Both sides of a box are active, so that multipliers of both signs are known.
TEST(SolveElastic, TheSignsOfKnownMultipliersCount) {
  constexpr std::size_t kSize = 30;
  Values wanted;
  for (std::size_t i = 0; i < kSize; ++i) wanted.push_back((i % 2 == 0 ? 1.0 : -1.0) * 0.2 * static_cast<double>(i));
  ConstrainedProblem problem{VectorX::Zero(kSize), {To(wanted)}, {}, {}, {}};
  problem.constraints.push_back({"box", Of([](const VectorX& x) { return Values(x.data(), x.data() + x.size()); }),
                                 VectorX::Constant(kSize, -1.0), VectorX::Constant(kSize, 1.0)});
  const ConstrainedSolution before = Solved(problem);
  problem.start = before.x;
  problem.start_multipliers = before.multipliers;
  const int right = Solved(problem).iterations;
  problem.start_multipliers = -before.multipliers;
  EXPECT_LT(right, Solved(problem).iterations);
}

TEST(SolveElastic, GivesUpEarlyWhereItIsHopeless) {
  // No point is near to both ends of a long arc; reaching the minimum of the violations takes some steps.
  ConstrainedProblem problem{Vec({3.0}), {To({0.0})}, {}, {}, {}};
  problem.constraints.push_back({"bow", Of([](const VectorX& x) {
                                   return Values{std::exp(x[0]), -x[0] * x[0] * x[0]};
                                 }),
                                 Vec({-kInfinity, -kInfinity}), Vec({0.5, -9.0})});
  ConstrainedSolution whole, short_one;
  EXPECT_FALSE(SolveElastic(problem, {}, &whole).ok());
  EXPECT_FALSE(SolveElastic(problem, {.early_check = 3, .infeasible = 0.1}, &short_one).ok());
  EXPECT_EQ(short_one.iterations, 3);
  EXPECT_GT(whole.iterations, 3);
  EXPECT_FALSE(SolveElastic(problem, {.early_check = 6, .infeasible = 1e-3}, &short_one).ok());
  EXPECT_EQ(short_one.iterations, 3) << "violations of more than a hundred times as much end it halfway";
}

/// The bound at 0 has the multiplier 900, more than the first penalty weight.
TEST(SolveElastic, FromTheMultipliersOfASimilarProblemItTakesFewSteps) {
  const auto problem = [](double nearest) {
    ConstrainedProblem p{
        Vec({0.5}), {Of([nearest](const VectorX& x) { return Values{30.0 * (x[0] - nearest)}; })}, {}, {}, {}};
    p.constraints.push_back(
        {"at most", Of([](const VectorX& x) { return Values{x[0]}; }), Vec({-kInfinity}), Vec({0.0})});
    return p;
  };
  const ElasticOptions options{.penalty = 1.0, .max_penalty = 1e4};
  const ConstrainedSolution before = Solved(problem(1.0), options);
  ConstrainedProblem similar = problem(1.01);
  const ConstrainedSolution cold = Solved(similar, options);
  similar.start = before.x;
  similar.start_multipliers = before.multipliers;
  const ConstrainedSolution warm = Solved(similar, options);
  EXPECT_NEAR(warm.x[0], 0.0, 1e-6);
  EXPECT_NEAR(warm.multipliers[0], cold.multipliers[0], 1e-3 * cold.multipliers[0]);
  EXPECT_LT(warm.outer, cold.outer);
  EXPECT_LT(2 * warm.iterations, cold.iterations);
  similar.start_multipliers = Vec({1.0, 2.0});  // of other rows
  EXPECT_NEAR(Solved(similar, options).x[0], 0.0, 1e-6);
}

TEST(SolveElastic, SaysWhatIsNotFiniteAndRefusesBounds) {
  ConstrainedProblem problem{
      Vec({0.0}), {Of([](const VectorX& x) { return Values{std::log(x[0] - 1.0)}; })}, {}, {}, {}};
  EXPECT_THROW((void)SolveElastic(problem), InvalidArgument);
  problem.residuals = {To({1.0})};
  EXPECT_NO_THROW((void)SolveElastic(problem));
  problem.lower = problem.upper = Vec({0.0});
  EXPECT_THROW((void)SolveElastic(problem), InvalidArgument);
  EXPECT_THROW((void)SolveElastic(problem, {.penalty = -1.0}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
