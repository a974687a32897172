// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/value_noise.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gaitwright {
namespace {

TEST(UniformAt, SpreadsEvenly) {
  int low = 0;
  double sum = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double value = UniformAt(i % 80 - 40, i / 80, 7);
    ASSERT_LE(std::abs(value), 1.0);
    sum += value;
    low += value < -0.5 ? 1 : 0;
  }
  EXPECT_LT(std::abs(sum / 4000.0), 0.03);
  EXPECT_NEAR(low / 4000.0, 0.25, 0.03);
}

TEST(ValueNoise, HasTheGridsOwnValuesAtItsNodesAndIsLevelThere) {
  const double wavelength = 0.4;
  for (int i = -3; i < 4; ++i) {
    const Vector2 node = 0.5 * wavelength * Vector2(i, 2 - i);
    EXPECT_NEAR(ValueNoise(node, wavelength, 3), UniformAt(i, 2 - i, 3), 1e-12);
    for (const Vector2& by : {Vector2(1e-4, 0.0), Vector2(0.0, -1e-4)})
      EXPECT_LT(std::abs(ValueNoise(node + by, wavelength, 3) - ValueNoise(node, wavelength, 3)), 1e-8);
  }
}

TEST(ValueNoise, ChangesWithTheSeed) { EXPECT_NE(ValueNoise({0.1, 0.1}, 0.4, 1), ValueNoise({0.1, 0.1}, 0.4, 2)); }

}  // namespace
}  // namespace gaitwright
