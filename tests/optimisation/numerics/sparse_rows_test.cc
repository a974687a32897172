// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/sparse_rows.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "tests/optimisation/numerics/by_values.h"

namespace gaitwright {
namespace {

using by_values::Of;
using by_values::Values;
using by_values::Vec;

/// Five unknowns, and rows that depend on some of them in any order.
ConstrainedProblem Mixed() {
  ConstrainedProblem problem;
  problem.start = Vec({0.3, -0.2, 0.5, 0.1, 0.7});
  problem.residuals.emplace_back(Of([](const VectorX& x) {
                                   return Values{2.0 * x[0] - x[1], x[1]};
                                 }),
                                 std::vector<int>{3, 1});
  problem.residuals.back().affine = true;
  problem.residuals.emplace_back(Of([](const VectorX& x) { return Values{x[0] * x[1]}; }), std::vector<int>{0, 4});
  problem.constraints.push_back({"sine",
                                 Of([](const VectorX& x) {
                                   return Values{std::sin(x[0]) + x[1], x[1] * x[2]};
                                 }),
                                 Vec({0.0, 0.0}),
                                 Vec({1.0, 1.0}),
                                 {4, 2, 0}});
  return problem;
}

/// The Jacobian of all rows.
MatrixX Dense(const ConstrainedProblem& problem, const VectorX& x) {
  MatrixX J = MatrixX::Zero(5, 5);
  J(0, 3) = 2.0;
  J(0, 1) = -1.0;
  J(1, 1) = 1.0;
  J(2, 0) = x[4];
  J(2, 4) = x[0];
  J(3, 4) = std::cos(x[4]);
  J(3, 2) = 1.0;
  J(4, 2) = x[0];
  J(4, 0) = x[2];
  EXPECT_EQ(problem.start.size(), 5);
  return J;
}

TEST(SparseRows, AreThoseOfTheProblemInTurn) {
  const ConstrainedProblem problem = Mixed();
  SparseRows rows(problem);
  EXPECT_EQ(rows.count(), 5);
  EXPECT_EQ(rows.residuals(), 3);
  EXPECT_EQ(rows.ConstraintOf(2), nullptr);
  EXPECT_EQ(rows.ConstraintOf(3), &problem.constraints[0]);
  const VectorX x = Vec({-0.4, 0.6, 0.2, 0.9, 1.1});
  rows.Evaluate(x);
  rows.Differentiate();
  EXPECT_LT((rows.value() - Vec({1.2, 0.6, -0.44, std::sin(1.1) + 0.2, -0.08})).norm(), 1e-12);
  const MatrixX J = Dense(problem, x);
  const VectorX right = Vec({1.0, -2.0, 3.0, -4.0, 5.0});
  EXPECT_LT((rows.Moved(right) - J * right).norm(), 1e-8);
  EXPECT_LT((rows.Gradient(right) - J.transpose() * right).norm(), 1e-8);
}

TEST(SparseRows, TheirWeighedSquaresAreFactored) {
  const ConstrainedProblem problem = Mixed();
  SparseRows rows(problem);
  const VectorX x = Vec({-0.4, 0.6, 0.2, 0.9, 1.1}), weights = Vec({9.0, 9.0, 9.0, 2.0, 3.0});
  rows.Evaluate(x);
  rows.Differentiate();
  ASSERT_TRUE(rows.Factor(weights, 0.1));
  const MatrixX J = Dense(problem, x);
  const VectorX own = Vec({1.0, 1.0, 1.0, 2.0, 3.0});  // the weight of residuals is 1
  const MatrixX squares = J.transpose() * own.asDiagonal() * J + 0.1 * MatrixX::Identity(5, 5);
  const VectorX right = Vec({1.0, -2.0, 3.0, -4.0, 5.0});
  EXPECT_LT((squares * rows.Solved(right) - right).norm(), 1e-7);
  EXPECT_FALSE(rows.Factor(Vec({1.0, 1.0, 1.0, 0.0, 0.0}), -10.0));
}

}  // namespace
}  // namespace gaitwright
