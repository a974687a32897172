// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/energy_margin.h"

#include <gtest/gtest.h>

#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

TEST(EnergyMargin, OfAPointMassOverARectangle) {
  MotionSample sample;
  sample.p_WC = {0.02, 0.0, 0.4};
  sample.support.points_W = {{-0.1, -0.2, 0.0}, {0.1, -0.2, 0.0}, {0.1, 0.2, 0.0}, {-0.1, 0.2, 0.0}};
  sample.support.polygon = {{-0.1, -0.2}, {0.1, -0.2}, {0.1, 0.2}, {-0.1, 0.2}};
  EXPECT_NEAR(EnergyMargin(sample), std::hypot(0.08, 0.4) - 0.4, 1e-12);
  sample.p_WC.x() = 0.15;
  EXPECT_NEAR(EnergyMargin(sample), -(std::hypot(0.05, 0.4) - 0.4), 1e-12) << "already beyond the front edge";
  sample.support.polygon = {{0.0, -0.2}, {0.0, 0.2}};
  sample.support.reference_W = Vector3::Zero();
  EXPECT_NEAR(EnergyMargin(sample), -(std::hypot(0.15, 0.4) - 0.4), 1e-12) << "a line";
}

TEST(EnergyMargin, AnInclinedEdgeIsTippedOverMoreEasily) {
  MotionSample sample;
  sample.p_WC = {0.0, 0.0, 0.4};
  const double rise = 0.1;
  sample.support.points_W = {{-0.2, -0.1, -rise}, {0.2, -0.1, rise}, {0.2, 0.1, rise}, {-0.2, 0.1, -rise}};
  sample.support.polygon = {{-0.2, -0.1}, {0.2, -0.1}, {0.2, 0.1}, {-0.2, 0.1}};
  // Messuri and Klein: R (1 - cos theta) cos psi, with psi the inclination of the long edges.
  const double cos_psi = 0.2 / std::hypot(0.2, rise), high = 0.4 * cos_psi;
  const double R = std::hypot(high, 0.1);
  EXPECT_NEAR(EnergyMargin(sample), (R - high) * cos_psi, 1e-12);
}

}  // namespace
}  // namespace gaitwright
