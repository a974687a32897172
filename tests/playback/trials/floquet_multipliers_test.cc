// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "kinematics/base/result.h"
#include "playback/trials/floquet_multipliers_internal.h"

namespace gaitwright {
namespace {

MatrixX RandomEntries(Eigen::Index rows, Eigen::Index columns, std::mt19937& draw) {
  std::normal_distribution<double> normal;
  return MatrixX::NullaryExpr(rows, columns, [&] { return normal(draw); });
}

VectorX RandomDeviation(Eigen::Index size, std::mt19937& draw) { return RandomEntries(size, 1, draw).col(0); }

/// A map with the multipliers 0.8 and 0.5 +- 0.3i, in other coordinates, within `size` dimensions.
MatrixX MapOfThree(Eigen::Index size, std::mt19937& draw) {
  MatrixX map = MatrixX::Zero(size, size);
  map.topLeftCorner<3, 3>() << 0.8, 0.0, 0.0, 0.0, 0.5, -0.3, 0.0, 0.3, 0.5;
  const MatrixX turn = RandomEntries(size, size, draw);
  return turn * map * turn.inverse();
}

std::vector<CycleDeviations> Follow(const MatrixX& map, int sequences, int cycles, double noise, std::mt19937& draw) {
  std::vector<CycleDeviations> all;
  for (int i = 0; i < sequences; ++i) {
    CycleDeviations one = {map * RandomDeviation(map.rows(), draw)};
    for (int k = 0; k < cycles; ++k) one.emplace_back(map * one.back() + noise * RandomDeviation(map.rows(), draw));
    all.push_back(std::move(one));
  }
  return all;
}

TEST(FloquetMultipliers, OfALinearMapAreItsEigenvalues) {
  std::mt19937 draw(1);
  for (const Eigen::Index size : {3, 7}) {
    const FloquetMultipliers found = EstimateMultipliers(Follow(MapOfThree(size, draw), 6, 4, 0.0, draw));
    ASSERT_EQ(found.values.size(), 3U) << size;
    EXPECT_NEAR(std::abs(found.values[0] - 0.8), 0.0, 1e-9);
    EXPECT_NEAR(std::abs(found.values[1] - std::complex<double>(0.5, 0.3)), 0.0, 1e-9);
    EXPECT_NEAR(std::abs(found.values[2] - std::complex<double>(0.5, -0.3)), 0.0, 1e-9);
    EXPECT_LT(found.unexplained, 1e-9);
  }
}

TEST(FloquetMultipliers, WhatIsNotLinearIsUnexplained) {
  std::mt19937 draw(2);
  const MatrixX map = MapOfThree(3, draw);
  const double little = EstimateMultipliers(Follow(map, 30, 4, 0.01, draw)).unexplained;
  const double much = EstimateMultipliers(Follow(map, 30, 4, 0.3, draw)).unexplained;
  EXPECT_LT(little, 0.1);
  EXPECT_GT(much, 3.0 * little);
}

TEST(FloquetMultipliers, GrowthIsAMultiplierAboveOne) {
  std::mt19937 draw(3);
  const FloquetMultipliers found = EstimateMultipliers(Follow(1.6 * MapOfThree(5, draw), 6, 4, 0.0, draw));
  EXPECT_NEAR(found.largest(), 1.28, 1e-9);
}

TEST(FloquetMultipliers, NeedDeviationsOfOneSize) {
  EXPECT_TRUE(EstimateMultipliers({}).values.empty());
  EXPECT_TRUE(EstimateMultipliers({{VectorX::Zero(2), VectorX::Zero(2)}}).values.empty());
  EXPECT_THROW(EstimateMultipliers({{VectorX::Ones(2), VectorX::Ones(3)}}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
