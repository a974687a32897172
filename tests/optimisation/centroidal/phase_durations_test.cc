// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/phase_durations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace gaitwright {
namespace {

VectorX Drawn(std::mt19937& random, Eigen::Index n, double low, double high) {
  std::uniform_real_distribution<double> uniform(low, high);
  return VectorX::NullaryExpr(n, [&] { return uniform(random); });
}

/// Feasible bounds around random durations, with a fixed total for even seeds and a free one for odd seeds.
DurationBounds DrawnBounds(std::mt19937& random, Eigen::Index n, unsigned seed) {
  DurationBounds bounds{Drawn(random, n, 0.02, 0.1), Drawn(random, n, 0.3, 0.6)};
  bounds.least_total_s = 0.5 * (bounds.lower.sum() + bounds.upper.sum());
  bounds.most_total_s = (seed % 2 == 0 ? 1.0 : 1.1) * bounds.least_total_s;
  return bounds;
}

void ExpectWithin(const VectorX& durations, const DurationBounds& bounds) {
  EXPECT_TRUE((durations.array() >= bounds.lower.array()).all());
  EXPECT_TRUE((durations.array() <= bounds.upper.array()).all());
  EXPECT_GE(durations.sum(), bounds.least_total_s - 1e-12);
  EXPECT_LE(durations.sum(), bounds.most_total_s + 1e-12);
}

TEST(NearestDurations, AreWithinBoundsAndNoneIsNearer) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const Eigen::Index n = 2 + seed % 9;
    const DurationBounds bounds = DrawnBounds(random, n, seed);
    const VectorX wanted = Drawn(random, n, -0.2, 0.9), nearest = NearestDurations(wanted, bounds);
    ExpectWithin(nearest, bounds);
    EXPECT_LT((NearestDurations(nearest, bounds) - nearest).norm(), 1e-12);
    // The nearest point of a convex set: the direction to any other point of the set leads away from the wanted
    // durations.
    for (int i = 0; i < 20; ++i) {
      const VectorX other = NearestDurations(Drawn(random, n, 0.0, 0.6), bounds);
      EXPECT_LE((other - nearest).dot(wanted - nearest), 1e-9);
    }
  }
}

TEST(NearestDurations, ThoseThatAreWithinBoundsStayToTheLastDigit) {
  const VectorX durations = (VectorX(3) << 0.1, 0.7, 0.2).finished();
  const DurationBounds bounds{VectorX::Constant(3, 0.05), VectorX::Constant(3, 1.0), 1.0, 1.0};
  EXPECT_EQ(NearestDurations(durations, bounds), durations);
}

TEST(BestDurations, NoneNearbyIsBetter) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const Eigen::Index n = 2 + seed % 9;
    const DurationBounds bounds = DrawnBounds(random, n, seed);
    const VectorX at = NearestDurations(Drawn(random, n, 0.0, 0.6), bounds), slope = Drawn(random, n, -1.0, 1.0);
    const VectorX most = 0.3 * at;
    const MatrixX root = Drawn(random, n * n, -1.0, 1.0).reshaped(n, n);
    const MatrixX curvature = seed % 3 == 0 ? MatrixX::Zero(n, n) : MatrixX(10.0 * root * root.transpose());
    const VectorX best = BestDurations(at, slope, curvature, most, bounds);
    ExpectWithin(best, bounds);
    EXPECT_TRUE(((best - at).cwiseAbs().array() <= most.array() + 1e-12).all());
    const auto model = [&](const VectorX& d) { return slope.dot(d - at) + 0.5 * (d - at).dot(curvature * (d - at)); };
    EXPECT_LE(model(best), 0.0);
    DurationBounds near = bounds;
    near.lower = near.lower.cwiseMax(at - most);
    near.upper = near.upper.cwiseMin(at + most);
    for (int i = 0; i < 50; ++i) {
      const VectorX other = NearestDurations(at + Drawn(random, n, -0.2, 0.2), near);
      EXPECT_GE(model(other), model(best) - 1e-4 * std::abs(model(best))) << seed;
    }
  }
}

}  // namespace
}  // namespace gaitwright
