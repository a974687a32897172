// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "optimisation/trajectory/chain_spline_internal.h"

namespace gaitwright {
namespace {

double Cubic(double t) { return 1.0 - 2.0 * t + 3.0 * t * t - 0.5 * t * t * t; }
double Rate(double t) { return -2.0 + 6.0 * t - 1.5 * t * t; }

/// The spline through a cubic polynomial and its negative.
MatrixX ThroughCubic(const ChainSpline& spline) {
  const std::vector<double>& times = spline.times_s();
  MatrixX values(2, spline.knots());
  for (int k = 0; k < spline.knots(); ++k)
    values.col(k) << Cubic(times[static_cast<std::size_t>(k)]), -Cubic(times[static_cast<std::size_t>(k)]);
  const double first = Rate(times.front()), last = Rate(times.back());
  return spline.Through(values, Vector2(first, -first), Vector2(last, -last));
}

TEST(ChainSpline, ReproducesACubicOverUnevenKnots) {
  for (const std::vector<double>& times :
       {std::vector<double>{0.0, 0.5}, {0.0, 0.1, 0.5}, {-0.2, 0.1, 0.5, 0.6}, {0.0, 0.1, 0.3, 0.35, 0.8, 1.0, 1.5}}) {
    const ChainSpline spline(times);
    const MatrixX points = ThroughCubic(spline);
    VectorJet jet;
    for (double t = times.front(); t <= times.back(); t += 0.01) {
      spline.Sample(points, t, jet);
      EXPECT_NEAR(jet.x[0], Cubic(t), 1e-12);
      EXPECT_NEAR(jet.x[1], -Cubic(t), 1e-12);
      EXPECT_NEAR(jet.rate[0], Rate(t), 1e-11);
      EXPECT_NEAR(jet.acceleration[0], 6.0 - 3.0 * t, 1e-9);
    }
  }
}

TEST(ChainSpline, AKnotIsDecidedByThreePoints) {
  const ChainSpline spline({0.0, 0.1, 0.3, 0.35, 0.8});
  const MatrixX points = ThroughCubic(spline);
  VectorJet jet;
  for (int k = 0; k < spline.knots(); ++k) {
    spline.Sample(points, spline.times_s()[static_cast<std::size_t>(k)], jet);
    double x = 0.0, rate = 0.0, acceleration = 0.0;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      x += spline.At(k).value[at] * points(0, k + i);
      rate += spline.At(k).rate[at] * points(0, k + i);
      acceleration += spline.At(k).acceleration[at] * points(0, k + i);
    }
    EXPECT_NEAR(x, jet.x[0], 1e-12);
    EXPECT_NEAR(rate, jet.rate[0], 1e-11);
    EXPECT_NEAR(acceleration, jet.acceleration[0], 1e-9);
  }
}

TEST(ChainSpline, RefusesTimesThatDoNotIncrease) {
  EXPECT_THROW(ChainSpline({0.0}), InvalidArgument);
  EXPECT_THROW(ChainSpline({0.0, 0.1, 0.1}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
