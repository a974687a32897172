// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/wilson.h"

#include <gtest/gtest.h>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

TEST(WilsonTest, KnownAnswers) {
  // Newcombe, Statistics in Medicine 17, 1998, table I, method 3: 81/263, 15/148, 0/20, 1/29.
  const ShareInterval a = WilsonInterval(81, 263), b = WilsonInterval(15, 148), c = WilsonInterval(0, 20);
  EXPECT_NEAR(a.low, 0.2553, 5e-5);
  EXPECT_NEAR(a.high, 0.3662, 5e-5);
  EXPECT_NEAR(b.low, 0.0624, 5e-5);
  EXPECT_NEAR(b.high, 0.1605, 5e-5);
  EXPECT_EQ(c.low, 0.0);
  EXPECT_NEAR(c.high, 0.1611, 5e-5);
  const ShareInterval d = WilsonInterval(1, 29);
  EXPECT_NEAR(d.low, 0.0061, 5e-5);
  EXPECT_NEAR(d.high, 0.1718, 5e-5);
}

TEST(WilsonTest, MirrorsAndEnds) {
  for (int k = 0; k <= 50; ++k) {
    const ShareInterval one = WilsonInterval(k, 50), other = WilsonInterval(50 - k, 50);
    EXPECT_NEAR(one.low, 1.0 - other.high, 1e-12);
    EXPECT_LE(one.low, one.share);
    EXPECT_GE(one.high, one.share);
  }
  EXPECT_EQ(WilsonInterval(0, 0), (ShareInterval{0.0, 0.0, 1.0}));
  EXPECT_EQ(WilsonInterval(7, 7).high, 1.0);
  EXPECT_LT(WilsonInterval(400, 500).width(), WilsonInterval(40, 50).width());
  EXPECT_THROW(WilsonInterval(3, 2), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
