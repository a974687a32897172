// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/preview_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

TEST(PreviewControl, GainsAreThePublishedOnes) {
  const PreviewGains gains = ComputePreviewGains({});
  EXPECT_NEAR(gains.integral, 618.7, 0.05);
  EXPECT_NEAR(gains.state[0], 72719.0, 1.0);
  EXPECT_NEAR(gains.state[1], 21550.0, 1.0);
  EXPECT_NEAR(gains.state[2], 177.01, 0.005);
  EXPECT_EQ(gains.preview.size(), 320U);
}

TEST(PreviewControl, AStandingReferenceIsHeld) {
  const PreviewMotion motion = FollowZmp({}, std::vector<double>(400, 0.1), 0.1);
  for (std::size_t k = 0; k < motion.com_m.size(); ++k) {
    EXPECT_NEAR(motion.com_m[k], 0.1, 1e-6);
    EXPECT_NEAR(motion.zmp_m[k], 0.1, 1e-6);
  }
}

TEST(PreviewControl, FollowsStepsToAMillimetreOnAverage) {
  std::vector<double> reference;
  for (int k = 0; k < 2400; ++k) {
    const double t = 0.005 * k;
    reference.push_back(t < 2.0 ? 0.0 : t > 8.0 ? 0.0 : 0.05 * (static_cast<int>(t / 0.8) % 2 == 0 ? 1.0 : -1.0));
  }
  const PreviewMotion motion = FollowZmp({}, reference, 0.0);
  double squares = 0.0;
  for (std::size_t k = 0; k < reference.size(); ++k) squares += std::pow(motion.zmp_m[k] - reference[k], 2);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(reference.size())), 0.01);
  EXPECT_NEAR(motion.com_m.back(), 0.0, 1e-3);
}

TEST(PreviewControl, RefusesNonsense) {
  EXPECT_THROW(ComputePreviewGains({-1.0}), InvalidArgument);
  EXPECT_THROW(FollowZmp({}, {}, 0.0), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
