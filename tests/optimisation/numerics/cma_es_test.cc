// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/cma_es.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

using Cost = std::function<std::optional<double>(const VectorX&)>;

struct Found {
  VectorX at;
  double value = 1e300;
  int evaluations = 0;
  double spread = 0.0;
};

/// Searches until `enough` evaluations, and checks every point against the bounds.
Found Search(const Cost& cost, const VectorX& start, int enough, std::uint64_t seed, const CmaEsOptions& options = {}) {
  CmaEs search(start, seed, options);
  Found found;
  while (found.evaluations < enough) {
    std::vector<std::optional<double>> values;
    for (const VectorX& point : search.Ask()) {
      EXPECT_TRUE((point.array() >= 0.0).all() && (point.array() <= 1.0).all()) << point.transpose();
      values.push_back(cost(point));
      ++found.evaluations;
      if (values.back() && *values.back() < found.value) {
        found.value = *values.back();
        found.at = point;
      }
    }
    search.Tell(values);
  }
  found.spread = search.spread();
  return found;
}

VectorX All(Eigen::Index n, double value) { return VectorX::Constant(n, value); }

TEST(CmaEs, FindsTheMiddleOfASphereToManyDigits) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Found found =
        Search([](const VectorX& x) { return (x - All(5, 0.3)).squaredNorm(); }, All(5, 0.8), 1500, seed);
    EXPECT_LT(found.value, 1e-12) << seed;
    EXPECT_LT(found.spread, 1e-4);
  }
}

TEST(CmaEs, LearnsTheAxesOfAnEllipsoidThatIsTurned) {
  MatrixX turn = MatrixX::Identity(4, 4);
  for (Eigen::Index i = 0; i + 1 < 4; ++i) {
    MatrixX plane = MatrixX::Identity(4, 4);
    plane.block<2, 2>(i, i) << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
    turn = turn * plane;
  }
  const VectorX scales = (VectorX(4) << 1.0, 1e2, 1e4, 1e6).finished();
  const Cost cost = [&](const VectorX& x) { return scales.dot((turn * (x - All(4, 0.6))).cwiseAbs2()); };
  EXPECT_LT(Search(cost, All(4, 0.2), 5000, 4).value, 1e-8);
}

TEST(CmaEs, FollowsTheValleyOfRosenbrock) {
  const Cost cost = [](const VectorX& x) {
    const VectorX z = 4.0 * x - All(3, 2.0);  // the minimum is at z = 1
    double sum = 0.0;
    for (Eigen::Index i = 0; i + 1 < 3; ++i)
      sum += 100.0 * std::pow(z[i + 1] - z[i] * z[i], 2) + std::pow(1.0 - z[i], 2);
    return sum;
  };
  const Found found = Search(cost, All(3, 0.2), 6000, 5);
  EXPECT_LT(found.value, 1e-8);
  EXPECT_LT((found.at - All(3, 0.75)).norm(), 1e-3);
}

TEST(CmaEs, FindsALeastValueOnItsBounds) {
  const Cost cost = [](const VectorX& x) {
    return std::pow(x[0] + 0.5, 2) + std::pow(x[1] - 1.7, 2) + std::pow(x[2] - 0.4, 2);
  };
  const Found found = Search(cost, All(3, 0.5), 3000, 6);
  EXPECT_NEAR(found.at[0], 0.0, 1e-3);
  EXPECT_NEAR(found.at[1], 1.0, 1e-3);
  EXPECT_NEAR(found.at[2], 0.4, 1e-2);
}

TEST(CmaEs, OnlyTheOrderOfValuesCounts) {
  const Cost plain = [](const VectorX& x) { return (x - All(2, 0.3)).squaredNorm(); };
  const Cost bent = [&](const VectorX& x) { return std::log(1e-300 + *plain(x)); };
  EXPECT_EQ(Search(plain, All(2, 0.7), 300, 7).at, Search(bent, All(2, 0.7), 300, 7).at);
}

TEST(CmaEs, ASeedRepeatsToTheBitAndAnotherDoesNot) {
  const Cost cost = [](const VectorX& x) { return (x - All(3, 0.3)).squaredNorm(); };
  EXPECT_EQ(Search(cost, All(3, 0.5), 400, 8).at, Search(cost, All(3, 0.5), 400, 8).at);
  EXPECT_NE(Search(cost, All(3, 0.5), 400, 8).at, Search(cost, All(3, 0.5), 400, 9).at);
}

TEST(CmaEs, PointsWithoutAValueKeepItFromWhereTheyAre) {
  const Cost cost = [](const VectorX& x) -> std::optional<double> {
    if (x[0] + x[1] < 0.8) return std::nullopt;
    return x.squaredNorm();
  };
  const Found found = Search(cost, All(2, 0.9), 1500, 10);
  EXPECT_NEAR(found.value, 0.32, 2e-3) << "least where the line is nearest to the origin";
}

TEST(CmaEs, AGenerationWithoutAnyValueDrawsNearer) {
  CmaEs search(All(2, 0.4), 11);
  const double before = search.spread();
  search.Tell(std::vector<std::optional<double>>(search.Ask().size()));
  EXPECT_EQ(search.spread(), 0.5 * before);
  EXPECT_EQ(search.mean(), All(2, 0.4));
}

TEST(CmaEs, WhatCannotBeIsRefused) {
  EXPECT_THROW(CmaEs(VectorX(), 1), InvalidArgument);
  EXPECT_THROW(CmaEs(All(2, 1.1), 1), InvalidArgument);
  EXPECT_THROW(CmaEs(All(2, 0.5), 1, {.population = 0, .spread = 2.0}), InvalidArgument);
  CmaEs search(All(2, 0.5), 1);
  EXPECT_THROW(search.Tell({1.0}), InvalidArgument) << "nothing was asked for";
  EXPECT_EQ(search.Ask().size(), 6U) << "4 + 3 ln 2";
  EXPECT_THROW(search.Tell({1.0}), InvalidArgument);
  EXPECT_THROW(search.Tell(std::vector<std::optional<double>>(6, std::nan(""))), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
