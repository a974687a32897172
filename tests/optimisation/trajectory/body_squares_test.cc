// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "optimisation/trajectory/body_rows_internal.h"
#include "tests/optimisation/trajectory/trotting_problem.h"

namespace gaitwright {
namespace {

class SquaresOfBodies : public testing::TestWithParam<const char*> {
 protected:
  const AnyProblem any_{GetParam()};
};

TEST_P(SquaresOfBodies, GradientIsTheTransposeOfTheMove) {
  const BodyRows rows(any_.problem, any_.z);
  RandomState random(3);
  const VectorX along = random.Vector(rows.size()), by = random.Vector(rows.count());
  const double product = by.dot(rows.Moved(along));
  EXPECT_GT(std::abs(product), 1.0);
  EXPECT_NEAR(rows.Gradient(by).dot(along), product, 1e-10 * by.norm() * rows.Moved(along).norm());
}

TEST_P(SquaresOfBodies, FactorsSolveTheNormalEquations) {
  BodyRows rows(any_.problem, any_.z);
  RandomState random(4);
  VectorX weights = random.Vector(rows.count()).cwiseAbs2();
  constexpr double kDamping = 0.01;
  ASSERT_TRUE(rows.Factor(weights, kDamping));
  const VectorX right = random.Vector(rows.size()), solved = rows.Solved(right);
  VectorX moved = rows.Moved(solved);
  weights.head(rows.residuals()).setOnes();
  const VectorX back = rows.Gradient(weights.cwiseProduct(moved)) + kDamping * solved;
  EXPECT_LT((back - right).norm(), 1e-6 * right.norm());
}

INSTANTIATE_TEST_SUITE_P(Robots, SquaresOfBodies, testing::ValuesIn(kAnyRobots));

}  // namespace
}  // namespace gaitwright
