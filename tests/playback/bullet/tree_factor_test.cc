// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "kinematics/spatial/pose.h"
#include "playback/bullet/tree_factor_internal.h"

namespace gaitwright::bullet {
namespace {

/// A tree and a positive definite matrix over it, packed and dense.
struct RandomTree {
  RandomTree(int size, unsigned seed) : tree(Parents(size, seed)), L(MatrixX::Zero(size, size)) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal;
    for (int i = 0; i < size; ++i) {
      for (int a = 0; a < tree.depth(i); ++a) L(i, tree.path(i)[a]) = normal(engine);
      L(i, i) = 1.0 + std::abs(normal(engine));
    }
    dense = L.transpose() * L;
    for (int i = 0; i < size; ++i)
      for (int a = 0; a <= tree.depth(i); ++a) packed.push_back(dense(i, tree.path(i)[a]));
  }

  static std::vector<int> Parents(int size, unsigned seed) {
    std::mt19937 engine(seed);
    std::vector<int> parents{-1};
    for (int i = 1; i < size; ++i)
      parents.push_back(std::uniform_int_distribution<int>(std::max(0, i - 4), i - 1)(engine));
    return parents;
  }

  CoordinateTree tree;
  MatrixX L, dense;
  std::vector<double> packed;
};

bool IsOnPath(const CoordinateTree& tree, int coordinate, int of) {
  return std::find(tree.path(of), tree.path(of) + tree.depth(of) + 1, coordinate) != tree.path(of) + tree.depth(of) + 1;
}

TEST(CoordinateTree, PathsGoFromTheRootToEachCoordinate) {
  const CoordinateTree tree({-1, 0, 1, 1, 3});
  EXPECT_EQ(tree.size(), 5);
  EXPECT_EQ(std::vector<int>(tree.path(4), tree.path(4) + tree.depth(4) + 1), (std::vector<int>{0, 1, 3, 4}));
  EXPECT_EQ(std::vector<int>(tree.path(2), tree.path(2) + tree.depth(2) + 1), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(tree.entries(), std::size_t{1 + 2 + 3 + 3 + 4});
}

TEST(TreeFactor, SolvesAsADenseFactorDoes) {
  for (const int size : {1, 2, 7, 30}) {
    const RandomTree random(size, 11U + static_cast<unsigned>(size));
    TreeFactor factor(random.tree);
    factor.Compute(random.packed);
    const VectorX b = VectorX::LinSpaced(size, -1.0, 2.0);
    VectorX x = b;
    factor.SolveUpper(x.data());
    EXPECT_LT((random.L.transpose() * x - b).lpNorm<Eigen::Infinity>(), 1e-9 * (1.0 + x.lpNorm<Eigen::Infinity>()));
    factor.SolveLower(x.data());
    EXPECT_LT((random.dense * x - b).lpNorm<Eigen::Infinity>(), 1e-9 * (1.0 + x.lpNorm<Eigen::Infinity>()));
    VectorX product(size);
    Multiply(random.tree, random.packed, b.data(), product.data());
    EXPECT_LT((random.dense * b - product).lpNorm<Eigen::Infinity>(), 1e-12 * random.dense.norm());
  }
}

TEST(TreeFactor, HalvesReachTheirPathOnly) {
  const RandomTree random(30, 5);
  TreeFactor factor(random.tree);
  factor.Compute(random.packed);
  int off_path = 0;
  for (int last = 0; last < 30; ++last) {
    VectorX half = VectorX::Zero(30);
    half[last] = 1.0;
    factor.SolveUpper(half.data());
    VectorX along(random.tree.depth(last) + 1);
    along.setZero();
    along[random.tree.depth(last)] = 1.0;
    factor.SolveUpperAlong(last, along.data());
    for (int i = 0; i < 30; ++i) {
      if (IsOnPath(random.tree, i, last)) {
        EXPECT_EQ(half[i], along[random.tree.depth(i)]);
      } else {
        EXPECT_EQ(half[i], 0.0);
        ++off_path;
      }
    }
  }
  EXPECT_GT(off_path, 100);
}

}  // namespace
}  // namespace gaitwright::bullet
