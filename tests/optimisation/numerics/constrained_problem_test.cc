// SPDX-License-Identifier: BSD-3-Clause
// Known answers: Hock and Schittkowski, Test Examples for Nonlinear Programming Codes, Springer 1981.
#include "optimisation/numerics/constrained_problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "kinematics/base/non_finite.h"
#include "tests/optimisation/numerics/by_values.h"

namespace gaitwright {
namespace {

using by_values::Function;
using by_values::Of;
using by_values::Values;
using by_values::Vec;

Constraint Equal(const Function& function, Eigen::Index rows) {
  return {"equal", Of(function), VectorX::Zero(rows), VectorX::Zero(rows)};
}
Constraint NotNegative(const Function& function, Eigen::Index rows) {
  return {"not negative", Of(function), VectorX::Zero(rows), VectorX::Constant(rows, kInfinity)};
}

/// A problem with its optimal cost; `shift` is the constant that is left out of the cost after completing squares.
struct Known {
  const char* name;
  ConstrainedProblem problem;
  double cost, shift;
};

double S(double x) { return x * x; }
const double kRoot2 = std::sqrt(2.0);

std::vector<Known> Small() {
  std::vector<Known> list;
  list.push_back({"HS6",
                  {Vec({-1.2, 1.0}),
                   {Of([](const VectorX& x) { return Values{1.0 - x[0]}; })},
                   {Equal([](const VectorX& x) { return Values{10.0 * (x[1] - S(x[0]))}; }, 1)},
                   {},
                   {}},
                  0.0,
                  0.0});
  list.push_back({"HS14",
                  {Vec({2.0, 2.0}),
                   {Of([](const VectorX& x) {
                     return Values{x[0] - 2.0, x[1] - 1.0};
                   })},
                   {Equal([](const VectorX& x) { return Values{x[0] - 2.0 * x[1] + 1.0}; }, 1),
                    NotNegative([](const VectorX& x) { return Values{1.0 - 0.25 * S(x[0]) - S(x[1])}; }, 1)},
                   {},
                   {}},
                  9.0 - 2.875 * std::sqrt(7.0),
                  0.0});
  list.push_back({"HS26",
                  {Vec({-2.6, 2.0, 2.0}),
                   {Of([](const VectorX& x) {
                     return Values{x[0] - x[1], S(x[1] - x[2])};
                   })},
                   {Equal([](const VectorX& x) { return Values{(1.0 + S(x[1])) * x[0] + S(S(x[2])) - 3.0}; }, 1)},
                   {},
                   {}},
                  0.0,
                  0.0});
  list.push_back({"HS43",
                  {Vec({0.0, 0.0, 0.0, 0.0}),
                   {Of([](const VectorX& x) {
                     return Values{x[0] - 2.5, x[1] - 2.5, kRoot2 * (x[2] - 5.25), x[3] + 3.5};
                   })},
                   {NotNegative(
                       [](const VectorX& x) {
                         return Values{8.0 - S(x[0]) - S(x[1]) - S(x[2]) - S(x[3]) - x[0] + x[1] - x[2] + x[3],
                                       10.0 - S(x[0]) - 2.0 * S(x[1]) - S(x[2]) - 2.0 * S(x[3]) + x[0] + x[3],
                                       5.0 - 2.0 * S(x[0]) - S(x[1]) - S(x[2]) - 2.0 * x[0] + x[1] + x[3]};
                       },
                       3)},
                   {},
                   {}},
                  -44.0,
                  -79.875});
  list.push_back(
      {"HS60",
       {Vec({2.0, 2.0, 2.0}),
        {Of([](const VectorX& x) {
          return Values{x[0] - 1.0, x[0] - x[1], S(x[1] - x[2])};
        })},
        {Equal([](const VectorX& x) { return Values{x[0] * (1.0 + S(x[1])) + S(S(x[2])) - 4.0 - 3.0 * kRoot2}; }, 1)},
        VectorX::Constant(3, -10.0),
        VectorX::Constant(3, 10.0)},
       0.03256820025,
       0.0});
  list.push_back({"HS65",
                  {Vec({-4.5, 4.5, 0.0}),
                   {Of([](const VectorX& x) {
                     return Values{x[0] - x[1], (x[0] + x[1] - 10.0) / 3.0, x[2] - 5.0};
                   })},
                   {NotNegative([](const VectorX& x) { return Values{48.0 - S(x[0]) - S(x[1]) - S(x[2])}; }, 1)},
                   Vec({-4.5, -4.5, -5.0}),
                   Vec({4.5, 4.5, 5.0})},
                  0.9535288567,
                  0.0});
  return list;
}

std::vector<Known> Larger() {
  std::vector<Known> list;
  list.push_back({"HS71",
                  {Vec({1.0, 5.0, 5.0, 1.0}),
                   {Of([](const VectorX& x) { return Values{std::sqrt(x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2])}; })},
                   {NotNegative([](const VectorX& x) { return Values{x[0] * x[1] * x[2] * x[3] - 25.0}; }, 1),
                    Equal([](const VectorX& x) { return Values{x.squaredNorm() - 40.0}; }, 1)},
                   VectorX::Constant(4, 1.0),
                   VectorX::Constant(4, 5.0)},
                  17.0140173,
                  0.0});
  list.push_back({"HS77",
                  {VectorX::Constant(5, 2.0),
                   {Of([](const VectorX& x) {
                     return Values{x[0] - 1.0, x[0] - x[1], x[2] - 1.0, S(x[3] - 1.0), std::pow(x[4] - 1.0, 3)};
                   })},
                   {Equal(
                       [](const VectorX& x) {
                         return Values{S(x[0]) * x[3] + std::sin(x[3] - x[4]) - 2.0 * kRoot2,
                                       x[1] + S(S(x[2])) * S(x[3]) - 8.0 - kRoot2};
                       },
                       2)},
                   {},
                   {}},
                  0.24150513,
                  0.0});
  list.push_back({"HS79",
                  {VectorX::Constant(5, 2.0),
                   {Of([](const VectorX& x) {
                     return Values{x[0] - 1.0, x[0] - x[1], x[1] - x[2], S(x[2] - x[3]), S(x[3] - x[4])};
                   })},
                   {Equal(
                       [](const VectorX& x) {
                         return Values{x[0] + S(x[1]) + std::pow(x[2], 3) - 2.0 - 3.0 * kRoot2,
                                       x[1] - S(x[2]) + x[3] + 2.0 - 2.0 * kRoot2, x[0] * x[4] - 2.0};
                       },
                       3)},
                   {},
                   {}},
                  0.0787768209,
                  0.0});
  list.push_back({"HS113",
                  {Vec({2, 3, 5, 5, 1, 2, 7, 3, 6, 10}),
                   {Of([](const VectorX& x) {
                     return Values{x[0] + 0.5 * x[1] - 7.0,
                                   std::sqrt(0.75) * (x[1] - 6.0),
                                   x[2] - 10.0,
                                   2.0 * (x[3] - 5.0),
                                   x[4] - 3.0,
                                   kRoot2 * (x[5] - 1.0),
                                   std::sqrt(5.0) * x[6],
                                   std::sqrt(7.0) * (x[7] - 11.0),
                                   kRoot2 * (x[8] - 10.0),
                                   x[9] - 7.0};
                   })},
                   {NotNegative(
                       [](const VectorX& x) {
                         return Values{105.0 - 4.0 * x[0] - 5.0 * x[1] + 3.0 * x[6] - 9.0 * x[7],
                                       -10.0 * x[0] + 8.0 * x[1] + 17.0 * x[6] - 2.0 * x[7],
                                       8.0 * x[0] - 2.0 * x[1] - 5.0 * x[8] + 2.0 * x[9] + 12.0,
                                       -3.0 * S(x[0] - 2.0) - 4.0 * S(x[1] - 3.0) - 2.0 * S(x[2]) + 7.0 * x[3] + 120.0,
                                       -5.0 * S(x[0]) - 8.0 * x[1] - S(x[2] - 6.0) + 2.0 * x[3] + 40.0,
                                       -0.5 * S(x[0] - 8.0) - 2.0 * S(x[1] - 4.0) - 3.0 * S(x[4]) + x[5] + 30.0,
                                       -S(x[0]) - 2.0 * S(x[1] - 2.0) + 2.0 * x[0] * x[1] - 14.0 * x[4] + 6.0 * x[5],
                                       3.0 * x[0] - 6.0 * x[1] - 12.0 * S(x[8] - 8.0) + 7.0 * x[9]};
                       },
                       8)},
                   {},
                   {}},
                  24.3062091,
                  -31.0});
  list.push_back({"Rosenbrock on the unit disk",
                  {Vec({0.0, 0.0}),
                   {Of([](const VectorX& x) {
                     return Values{1.0 - x[0], 10.0 * (x[1] - S(x[0]))};
                   })},
                   {NotNegative([](const VectorX& x) { return Values{1.0 - x.squaredNorm()}; }, 1)},
                   {},
                   {}},
                  0.0456748087,
                  0.0});
  return list;
}

/// HS100 with squares completed; the part that depends on x7 only is h - h_min, the square of its root.
Known Hs100() {
  const auto h = [](double x) { return S(S(x)) - 8.0 * x - S(4.0 * x + 10.0) / 28.0; };
  double least = 1.4;
  for (int i = 0; i < 20; ++i) {
    least -= (4.0 * std::pow(least, 3) - 8.0 - (4.0 * least + 10.0) * 8.0 / 28.0) / (12.0 * S(least) - 32.0 / 28.0);
  }
  const double h_min = h(least);
  const auto residual = [h, h_min](const VectorX& x) {
    return Values{x[0] - 10.0,
                  std::sqrt(5.0) * (x[1] - 12.0),
                  S(x[2]),
                  std::sqrt(3.0) * (x[3] - 11.0),
                  std::sqrt(10.0) * std::pow(x[4], 3),
                  std::sqrt(7.0) * (x[5] - (4.0 * x[6] + 10.0) / 14.0),
                  std::sqrt(std::max(h(x[6]) - h_min, 1e-12))};
  };
  const auto constraint = [](const VectorX& x) {
    return Values{127.0 - 2.0 * S(x[0]) - 3.0 * S(S(x[1])) - x[2] - 4.0 * S(x[3]) - 5.0 * x[4],
                  282.0 - 7.0 * x[0] - 3.0 * x[1] - 10.0 * S(x[2]) - x[3] + x[4],
                  196.0 - 23.0 * x[0] - S(x[1]) - 6.0 * S(x[5]) + 8.0 * x[6],
                  -4.0 * S(x[0]) - S(x[1]) + 3.0 * x[0] * x[1] - 2.0 * S(x[2]) - 5.0 * x[5] + 11.0 * x[6]};
  };
  return {
      "HS100", {Vec({1, 2, 0, 4, 0, 1, 1}), {Of(residual)}, {NotNegative(constraint, 4)}, {}, {}}, 680.6300573, h_min};
}

void ExpectKnown(const Known& known, ConstrainedOptions options = {}) {
  options.tolerance = 1e-9;
  const Result<ConstrainedSolution> solution = Solve(known.problem, options);
  ASSERT_TRUE(solution.ok()) << known.name << ": " << solution.failure().message;
  EXPECT_LT(solution->violation, 1e-7) << known.name;
  // Published answers have nine or ten digits.
  EXPECT_NEAR(solution->cost + known.shift, known.cost, 1e-7) << known.name << ": " << solution->brief;
}

TEST(ConstrainedProblem, SmallKnownAnswers) {
  for (const Known& known : Small()) ExpectKnown(known);
}

TEST(ConstrainedProblem, PatienceFindsTheSame) {
  for (const Known& known : Small()) ExpectKnown(known, {.inner_tolerance = 1e-4, .patience = 5});
}

TEST(ConstrainedProblem, LargerKnownAnswers) {
  for (const Known& known : Larger()) ExpectKnown(known);
  ExpectKnown(Hs100());
}

TEST(ConstrainedProblem, InfeasibleNamesTheConstraint) {
  ConstrainedProblem problem;
  problem.start = Vec({0.5, 0.5});
  problem.residuals = {Of([](const VectorX& x) { return Values{x[0], x[1]}; })};
  problem.constraints = {
      {"inside the disk", Of([](const VectorX& x) { return Values{x.squaredNorm()}; }), Vec({-kInfinity}), Vec({1.0})},
      {"beyond the line", Of([](const VectorX& x) { return Values{x[0] + x[1]}; }), Vec({3.0}), Vec({kInfinity})}};
  const Result<ConstrainedSolution> solution = Solve(problem);
  ASSERT_FALSE(solution.ok());
  EXPECT_EQ(solution.failure().kind, FailureKind::kInfeasible);
  EXPECT_NE(solution.failure().message.find("stays violated by"), std::string::npos);
}

TEST(ConstrainedProblem, TheScaleOfTheCostDoesNotMatter) {
  for (const double scale : {0.1, 10.0}) {
    ConstrainedProblem problem = Small()[1].problem;
    problem.residuals = {Of([scale](const VectorX& x) { return Values{scale * (x[0] - 2.0), scale * (x[1] - 1.0)}; })};
    const Result<ConstrainedSolution> solution = Solve(problem);
    ASSERT_TRUE(solution.ok()) << solution.failure().message;
    EXPECT_NEAR(solution->cost / (scale * scale), 9.0 - 2.875 * std::sqrt(7.0), 1e-6);
  }
}

TEST(ConstrainedProblem, DifferencesAreDerivatives) {
  const VectorFunction function = Of([](const VectorX& x) { return Values{std::sin(x[0]) * x[1], x[0] * x[0]}; });
  VectorX value(2);
  MatrixX J = MatrixX::Zero(2, 2);
  function(Vec({0.7, 2.0}), value, &J);
  EXPECT_NEAR(J(0, 0), 2.0 * std::cos(0.7), 1e-9);
  EXPECT_NEAR(J(0, 1), std::sin(0.7), 1e-9);
  EXPECT_NEAR(J(1, 0), 1.4, 1e-9);
  EXPECT_NEAR(J(1, 1), 0.0, 1e-12);
}

/// A string of `count` points, each pulled to its neighbours, from 0 to 1 over a nail at 2. Taut, it is straight from
/// one end to the nail and from there to the other end. Each residual names its two variables (sparse) or all of them.
ConstrainedProblem String(int count, int nail, bool sparse) {
  ConstrainedProblem problem;
  problem.start = VectorX::Zero(count);
  const auto pick = [sparse](int a, int b) { return sparse ? std::vector<int>{b, a} : std::vector<int>{}; };
  for (int i = 0; i + 1 < count; ++i) {
    const int left = sparse ? 1 : i, right = sparse ? 0 : i + 1;  // the order of the list differs on purpose
    problem.residuals.push_back({[left, right](const VectorX& x, VectorX& value, MatrixX* J) {
                                   value = VectorX::Constant(1, x[right] - x[left]);
                                   if (J == nullptr) return;
                                   (*J)(0, left) = -1.0;
                                   (*J)(0, right) = 1.0;
                                 },
                                 pick(i, i + 1)});
  }
  const auto at = [&](const std::string& name, int i, double low, double high) {
    const int local = sparse ? 0 : i;
    problem.constraints.push_back({name,
                                   [local](const VectorX& x, VectorX& value, MatrixX* J) {
                                     value = VectorX::Constant(1, x[local]);
                                     if (J != nullptr) (*J)(0, local) = 1.0;
                                   },
                                   Vec({low}), Vec({high}), sparse ? std::vector<int>{i} : std::vector<int>{}});
  };
  at("the one end", 0, 0.0, 0.0);
  at("the other end", count - 1, 1.0, 1.0);
  at("the nail", nail, 2.0, kInfinity);
  return problem;
}

TEST(ConstrainedProblem, AStringOverANailIsTaut) {
  // The factorisation is dense up to 60 variables and sparse beyond. The answer is the same, with few or all variables
  // named.
  for (const int count : {3, 30, 60, 61, 300}) {
    const int nail = count / 3;
    const double answer = 4.0 / nail + 1.0 / (count - 1 - nail);
    for (const bool sparse : {true, false}) {
      if (count > 100 && !sparse) continue;
      ConstrainedOptions options;
      options.trust_radius = 1e8;
      const Result<ConstrainedSolution> solution = Solve(String(count, nail, sparse), options);
      ASSERT_TRUE(solution.ok()) << count << ": " << solution.failure().message;
      EXPECT_NEAR(solution->cost, answer, 1e-7) << count << (sparse ? " of few" : " of all");
      const int half = nail / 2;
      EXPECT_NEAR(solution->x[half], 2.0 * half / nail, 1e-6) << count;
      EXPECT_LT(solution->violation, 1e-8);
    }
  }
}

TEST(ConstrainedProblem, BoundsHoldInEveryBlock) {
  ConstrainedProblem problem = String(100, 50, true);
  problem.lower = VectorX::Constant(100, -kInfinity);
  problem.upper = VectorX::Constant(100, kInfinity);
  problem.upper[75] = 0.25;  // a ceiling lower than the taut string
  const Result<ConstrainedSolution> solution = Solve(problem);
  ASSERT_TRUE(solution.ok()) << solution.failure().message;
  EXPECT_LE(solution->x[75], 0.25);
  EXPECT_NEAR(solution->cost, 4.0 / 50.0 + 1.75 * 1.75 / 25.0 + 0.75 * 0.75 / 24.0, 1e-7);
}

TEST(ConstrainedProblem, FewVariablesAreSeenInTheOrderGiven) {
  ConstrainedProblem problem;
  problem.start = Vec({0.0, 0.0, 0.0});
  problem.residuals = {{Of([](const VectorX& x) {
                          EXPECT_EQ(x.size(), 2);
                          return Values{x[0] - 5.0, x[1] - 7.0};
                        }),
                        {2, 0}},
                       {Of([](const VectorX& x) { return Values{x[0] - 1.0}; }), {1}}};
  const Result<ConstrainedSolution> solution = Solve(problem);
  ASSERT_TRUE(solution.ok());
  EXPECT_LT((solution->x - Vec({7.0, 1.0, 5.0})).norm(), 1e-6);
}

}  // namespace
}  // namespace gaitwright
