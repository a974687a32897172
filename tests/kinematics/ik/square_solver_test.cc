// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/square_solver.h"

#include <Eigen/LU>

#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

TEST(SquareSolver, SolvesAsEigenDoes) {
  RandomState random(5);
  for (const Eigen::Index n : {1, 2, 5, 18, 40}) {
    MatrixX A(n, n);
    for (Eigen::Index c = 0; c < n; ++c) A.col(c) = random.Vector(n);
    const VectorX b = random.Vector(n);
    SquareSolver solver(n);
    solver.matrix() = A;
    solver.Factor();
    VectorX x;
    solver.Solve(b, x);
    EXPECT_LT((A * x - b).norm(), 1e-11 * b.norm() * A.norm()) << n;
    EXPECT_LT((x - A.partialPivLu().solve(b)).norm(), 1e-10 * x.norm()) << n;
  }
}

TEST(SquareSolver, ExchangesRowsForAZeroOnTheDiagonal) {
  SquareSolver solver(3);
  solver.matrix() << 0.0, 2.0, 0.0, 0.0, 0.0, 4.0, 1.0, 0.0, 0.0;
  solver.Factor();
  VectorX x;
  solver.Solve(Vector3(2.0, 8.0, 3.0), x);
  EXPECT_LT((x - Vector3(3.0, 1.0, 2.0)).norm(), 1e-15);
}

TEST(SquareSolver, OfASingularMatrixIsNotFinite) {
  SquareSolver solver(2);
  solver.matrix() << 1.0, 2.0, 2.0, 4.0;
  solver.Factor();
  VectorX x;
  solver.Solve(Eigen::Vector2d(1.0, 1.0), x);
  EXPECT_FALSE(x.allFinite());
}

}  // namespace
}  // namespace gaitwright
