// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/halton.h"

#include <gtest/gtest.h>

#include <set>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

TEST(Halton, RadicalInversesAreThoseOfTheBook) {
  const double in_two[] = {0.0, 0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875};
  for (std::uint64_t i = 0; i < 8; ++i) EXPECT_DOUBLE_EQ(RadicalInverse(i, 2), in_two[i]) << i;
  EXPECT_DOUBLE_EQ(RadicalInverse(1, 3), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(RadicalInverse(2, 3), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(RadicalInverse(3, 3), 1.0 / 9.0);
  EXPECT_DOUBLE_EQ(RadicalInverse(8, 3), 8.0 / 9.0);
  EXPECT_DOUBLE_EQ(RadicalInverse(1234, 10), 0.4321);
}

TEST(Halton, PlainPointsBeginAsHaltonWroteThem) {
  const double expected[4][3] = {{1.0 / 2, 1.0 / 3, 1.0 / 5},
                                 {1.0 / 4, 2.0 / 3, 2.0 / 5},
                                 {3.0 / 4, 1.0 / 9, 3.0 / 5},
                                 {1.0 / 8, 4.0 / 9, 4.0 / 5}};
  for (std::uint64_t i = 0; i < 4; ++i) {
    const VectorX point = HaltonPoint(i, 3);
    for (Eigen::Index k = 0; k < 3; ++k) EXPECT_NEAR(point[k], expected[i][k], 1e-15) << i << " " << k;
  }
}

TEST(Halton, EachPartOfTheSquareGetsItsShareWhateverTheSeed) {
  for (const std::uint64_t seed : {0U, 1U, 77U}) {
    int counts[6][6] = {};
    for (std::uint64_t i = 0; i < 36 * 36; ++i) {
      const VectorX point = HaltonPoint(i, 2, seed);
      ASSERT_TRUE((point.array() >= 0.0).all() && (point.array() < 1.0).all());
      ++counts[static_cast<int>(6.0 * point[0])][static_cast<int>(6.0 * point[1])];
    }
    for (const auto& row : counts) {
      for (const int count : row) EXPECT_NEAR(count, 36, 5) << seed;
    }
  }
}

TEST(Halton, SeedsGiveOtherPointsAndTheSameAgain) {
  std::set<double> first;
  for (std::uint64_t seed = 0; seed < 20; ++seed) first.insert(HaltonPoint(0, 4, seed)[3]);
  EXPECT_EQ(first.size(), 20U);
  EXPECT_EQ(HaltonPoint(5, 4, 3), HaltonPoint(5, 4, 3));
}

TEST(Halton, TooManyCoordinatesAndABaseOfOneAreRefused) {
  EXPECT_THROW(HaltonPoint(0, 0), InvalidArgument);
  EXPECT_NO_THROW(HaltonPoint(0, kMostHaltonCoordinates));
  EXPECT_THROW(HaltonPoint(0, kMostHaltonCoordinates + 1), InvalidArgument);
  EXPECT_THROW(RadicalInverse(3, 1), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
