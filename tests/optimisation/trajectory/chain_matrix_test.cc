// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "optimisation/trajectory/chain_matrix_internal.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

constexpr int kSize = 4;

MatrixX RandomSquare(RandomState& random) {
  const MatrixX root = Eigen::Map<const MatrixX>(random.Vector(9 * kSize * kSize).eval().data(), 3 * kSize, 3 * kSize);
  return root * root.transpose();
}

TEST(ChainMatrix, SolvesAsADenseFactorisationDoes) {
  RandomState random(3);
  for (const int blocks : {3, 4, 9}) {
    ChainMatrix chain(kSize, blocks);
    MatrixX dense = 0.5 * MatrixX::Identity(kSize * blocks, kSize * blocks);
    chain.SetDiagonal(0.5);
    for (int k = 0; k + 2 < blocks; ++k) {
      const MatrixX square = RandomSquare(random);
      dense.block(k * kSize, k * kSize, 3 * kSize, 3 * kSize) += square;
      chain.Add(k, square);
    }
    const VectorX right = random.Vector(kSize * blocks);
    VectorX solved = right;
    ASSERT_TRUE(chain.Factor());
    chain.Solve(solved);
    EXPECT_LT((solved - dense.llt().solve(right)).norm(), 1e-9 * solved.norm());
  }
}

/// Of rows that meet four blocks.
TEST(ChainMatrix, HasTheGivenBandwidth) {
  RandomState random(4);
  constexpr int kBlocks = 7;
  ChainMatrix chain(kSize, kBlocks, 3);
  MatrixX dense = MatrixX::Identity(kSize * kBlocks, kSize * kBlocks);
  chain.SetDiagonal(1.0);
  for (int k = 0; k + 3 < kBlocks; ++k) {
    const VectorX row = random.Vector(4);
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        dense((k + a) * kSize + 1, (k + b) * kSize + 1) += row[a] * row[b];
        if (b <= a) chain.AddTo(k + a, k + b, 1, row[a] * row[b]);
      }
    }
    const MatrixX square = RandomSquare(random);
    dense.block(k * kSize, k * kSize, 3 * kSize, 3 * kSize) += square;
    chain.Add(k, square);
  }
  const VectorX right = random.Vector(kSize * kBlocks);
  VectorX solved = right;
  ASSERT_TRUE(chain.Factor());
  chain.Solve(solved);
  EXPECT_LT((solved - dense.llt().solve(right)).norm(), 1e-9 * solved.norm());
}

TEST(ChainMatrix, SolvesAllColumnsAsItSolvesEach) {
  RandomState random(5);
  ChainMatrix chain(kSize, 6);
  chain.SetDiagonal(0.5);
  for (int k = 0; k < 4; ++k) chain.Add(k, RandomSquare(random));
  ASSERT_TRUE(chain.Factor());
  MatrixX columns(6 * kSize, 3);
  for (int j = 0; j < 3; ++j) columns.col(j) = random.Vector(6 * kSize);
  MatrixX solved = columns;
  chain.SolveAll(solved);
  for (int j = 0; j < 3; ++j) {
    VectorX alone = columns.col(j);
    chain.Solve(alone);
    EXPECT_LT((alone - solved.col(j)).norm(), 1e-12 * alone.norm());
  }
}

TEST(ChainMatrix, SaysWhereItIsNotPositiveDefinite) {
  ChainMatrix chain(kSize, 3);
  chain.SetDiagonal(1.0);
  chain.Add(0, -2.0 * MatrixX::Identity(3 * kSize, 3 * kSize));
  EXPECT_FALSE(chain.Factor());
}

}  // namespace
}  // namespace gaitwright
