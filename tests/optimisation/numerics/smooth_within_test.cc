// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/smooth_within.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

constexpr double kStiff = 6.0, kFirm = 4.0 * kStiff * kStiff;

std::vector<Bounds> Free(std::size_t count) { return std::vector<Bounds>(count, Bounds{-1e9, 1e9}); }

double SharpestBend(const std::vector<double>& z) {
  double sharpest = 0.0;
  for (std::size_t k = 1; k + 1 < z.size(); ++k)
    sharpest = std::max(sharpest, std::abs(z[k - 1] - 2.0 * z[k] + z[k + 1]));
  return sharpest;
}

TEST(SmoothWithin, WhatIsLevelAndFreeStays) {
  const std::vector<double> wanted(50, 0.3);
  const std::vector<double> z = SmoothWithin(wanted, Free(50), kStiff, kFirm);
  for (const double value : z) EXPECT_NEAR(value, 0.3, 1e-12);
}

TEST(SmoothWithin, GoesUnderARoofInGoodTimeAndNoFarther) {
  const std::vector<double> wanted(101, 0.0);
  std::vector<Bounds> bounds = Free(101);
  for (std::size_t k = 45; k <= 55; ++k) bounds[k].high = -0.03;
  const std::vector<double> z = SmoothWithin(wanted, bounds, kStiff, kFirm);
  for (std::size_t k = 45; k <= 55; ++k) EXPECT_NEAR(z[k], -0.03, 0.003) << k;
  EXPECT_LT(z[42], -0.015) << "before it has to";
  EXPECT_NEAR(z[0], 0.0, 1e-3);
  EXPECT_NEAR(z[100], 0.0, 1e-3);
  for (std::size_t k = 0; k < 50; ++k) EXPECT_NEAR(z[k], z[100 - k], 1e-12);
  EXPECT_LT(SharpestBend(z), 2.0 * 0.03 / (kStiff * kStiff));
}

TEST(SmoothWithin, BoundsThatContradictThemselvesAreHalved) {
  const std::vector<double> wanted(101, 0.0);
  std::vector<Bounds> bounds = Free(101);
  for (std::size_t k = 20; k <= 80; ++k) bounds[k] = {0.06, 0.02};
  EXPECT_NEAR(SmoothWithin(wanted, bounds, kStiff, kFirm)[50], 0.04, 1e-3);
}

TEST(SmoothWithin, AnOddOneOutIsNotWorthABlow) {
  const std::vector<double> wanted(101, 0.0);
  std::vector<Bounds> bounds = Free(101);
  bounds[50] = {0.1, 0.1};
  const std::vector<double> z = SmoothWithin(wanted, bounds, kStiff, kFirm);
  EXPECT_GT(z[50], 0.05);
  EXPECT_LT(SharpestBend(z), 0.1 / 10.0);
}

TEST(SmoothWithin, NoOtherNumbersCostLess) {
  std::vector<double> wanted;
  std::vector<Bounds> bounds;
  for (int k = 0; k < 40; ++k) {
    wanted.push_back(0.1 * std::sin(0.4 * k));
    bounds.push_back({-0.03, 0.05});
  }
  const auto cost = [&](const std::vector<double>& z) {
    double sum = 0.0;
    for (std::size_t k = 0; k < z.size(); ++k) {
      const double before = z[k > 0 ? k - 1 : 0], after = z[std::min(k + 1, z.size() - 1)];
      const double beyond = std::max({bounds[k].low - z[k], z[k] - bounds[k].high, 0.0});
      sum += std::pow(z[k] - wanted[k], 2) + std::pow(kStiff, 4) * std::pow(before - 2.0 * z[k] + after, 2) +
             kFirm * beyond * beyond;
    }
    return sum;
  };
  const std::vector<double> z = SmoothWithin(wanted, bounds, kStiff, kFirm);
  for (std::size_t k = 0; k < z.size(); ++k) {
    for (const double change : {-1e-4, 1e-4}) {
      std::vector<double> other = z;
      other[k] += change;
      EXPECT_GT(cost(other), cost(z)) << k;
    }
  }
}

TEST(SmoothWithin, RefusesWhatDoesNotBelongTogether) {
  EXPECT_THROW(SmoothWithin({0.0, 0.0, 0.0}, Free(2), kStiff, kFirm), InvalidArgument);
  EXPECT_THROW(SmoothWithin({0.0, 0.0}, Free(2), kStiff, kFirm), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
