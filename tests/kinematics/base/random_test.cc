// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gaitwright {
namespace {

TEST(SplitMix, GivesTheNumbersOfTheReferenceCode) {
  SplitMix stream(1234567);
  for (const std::uint64_t expected : {6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL,
                                       4593380528125082431ULL, 16408922859458223821ULL}) {
    EXPECT_EQ(stream.Bits(), expected);
  }
}

TEST(SplitMix, MomentsAreThoseOfItsDistributions) {
  constexpr int kNumbers = 200000;
  SplitMix stream(5);
  double mean = 0.0, normal[5] = {};
  for (int i = 0; i < kNumbers; ++i) {
    const double uniform = stream.Uniform(), z = stream.Normal();
    ASSERT_TRUE(uniform >= 0.0 && uniform < 1.0 && std::isfinite(z));
    mean += uniform / kNumbers;
    for (int power = 1; power < 5; ++power) normal[power] += std::pow(z, power) / kNumbers;
  }
  EXPECT_NEAR(mean, 0.5, 0.003);
  EXPECT_NEAR(normal[1], 0.0, 0.01);
  EXPECT_NEAR(normal[2], 1.0, 0.015);
  EXPECT_NEAR(normal[3], 0.0, 0.04);
  EXPECT_NEAR(normal[4], 3.0, 0.12);
}

}  // namespace
}  // namespace gaitwright
