// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/response_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/random.h"
#include "kinematics/base/result.h"
#include "optimisation/numerics/halton.h"

namespace gaitwright {
namespace {

QuadraticSurface AnySurface(int n, SplitMix& random) {
  QuadraticSurface surface{random.Normal(), VectorX(n), MatrixX(n, n)};
  for (double& number : surface.slope) number = random.Normal();
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k <= i; ++k) surface.curvature(i, k) = surface.curvature(k, i) = 2.0 * random.Normal();
  }
  return surface;
}

std::vector<VectorX> Points(int count, int n) {
  std::vector<VectorX> points;
  for (int i = 0; i < count; ++i) points.push_back(HaltonPoint(static_cast<std::uint64_t>(i), n));
  return points;
}

std::vector<double> ValuesOf(const QuadraticSurface& surface, const std::vector<VectorX>& points) {
  std::vector<double> values;
  for (const VectorX& point : points) values.push_back(surface.At(point));
  return values;
}

TEST(ResponseSurface, FitsQuadraticsExactly) {
  SplitMix random(1);
  for (int n = 1; n <= 5; ++n) {
    const QuadraticSurface truth = AnySurface(n, random);
    const std::vector<VectorX> points = Points(CoefficientsOfQuadratic(n) + 10, n);
    const FittedSurface fitted = FitQuadratic(points, ValuesOf(truth, points));
    EXPECT_NEAR(fitted.surface.constant, truth.constant, 1e-9);
    EXPECT_LT((fitted.surface.slope - truth.slope).norm(), 1e-8) << n;
    EXPECT_LT((fitted.surface.curvature - truth.curvature).norm(), 1e-8) << n;
    EXPECT_NEAR(fitted.predicted, 1.0, 1e-9);
  }
}

TEST(ResponseSurface, WhatIsForetoldIsWhatFitsToTheOthersSay) {
  SplitMix random(2);
  const std::vector<VectorX> points = Points(12, 2);
  std::vector<double> values;
  for (const VectorX& point : points) values.push_back(std::sin(5.0 * point[0]) + random.Normal() * 0.1);
  double mean = 0.0, squares = 0.0, spread = 0.0;
  for (const double value : values) mean += value / 12.0;
  for (std::size_t left_out = 0; left_out < 12; ++left_out) {
    std::vector<VectorX> others = points;
    std::vector<double> theirs = values;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
    theirs.erase(theirs.begin() + static_cast<std::ptrdiff_t>(left_out));
    squares += std::pow(FitQuadratic(others, theirs).surface.At(points[left_out]) - values[left_out], 2);
    spread += std::pow(values[left_out] - mean, 2);
  }
  EXPECT_NEAR(FitQuadratic(points, values).predicted, 1.0 - squares / spread, 1e-9);
}

TEST(ResponseSurface, NoiseIsNotForetold) {
  SplitMix random(3);
  const std::vector<VectorX> points = Points(60, 3);
  std::vector<double> values;
  for (std::size_t i = 0; i < points.size(); ++i) values.push_back(random.Normal());
  EXPECT_LT(FitQuadratic(points, values).predicted, 0.1);
}

TEST(ResponseSurface, TheHighestPointIsThatOfTheSurfaceItself) {
  QuadraticSurface hill{3.0, VectorX(2), MatrixX(2, 2)};
  hill.curvature << -4.0, 1.0, 1.0, -2.0;
  const VectorX top = (VectorX(2) << 0.3, 0.7).finished();
  hill.slope = -hill.curvature * top;
  EXPECT_LT((HighestOf(hill, VectorX::Zero(2), VectorX::Ones(2)) - top).norm(), 1e-6);
}

TEST(ResponseSurface, NothingInTheBoxIsHigher) {
  SplitMix random(4);
  for (int problem = 0; problem < 60; ++problem) {
    const int n = 1 + problem % 4;
    const QuadraticSurface surface = AnySurface(n, random);
    const VectorX low = VectorX::Constant(n, -0.5), high = VectorX::Constant(n, 1.0);
    const VectorX best = HighestOf(surface, low, high);
    ASSERT_TRUE((best.array() >= -0.5).all() && (best.array() <= 1.0).all());
    double highest = -1e300;
    for (const VectorX& point : Points(3000, n)) highest = std::max(highest, surface.At(low + 1.5 * point));
    EXPECT_GE(surface.At(best), highest - 1e-6) << problem;
  }
}

TEST(ResponseSurface, APlaneIsHighestInACorner) {
  QuadraticSurface plane{0.0, VectorX(3), MatrixX::Zero(3, 3)};
  plane.slope << 1.0, -2.0, 0.5;
  const VectorX corner = (VectorX(3) << 1.0, 0.0, 1.0).finished();
  EXPECT_LT((HighestOf(plane, VectorX::Zero(3), VectorX::Ones(3)) - corner).norm(), 1e-6);
}

TEST(ResponseSurface, WhatDoesNotFitIsRefused) {
  EXPECT_EQ(CoefficientsOfQuadratic(2), 6);
  EXPECT_THROW(FitQuadratic(Points(5, 2), std::vector<double>(5, 1.0)), InvalidArgument);
  EXPECT_THROW(FitQuadratic(Points(7, 2), std::vector<double>(6, 1.0)), InvalidArgument);
  EXPECT_THROW(FitQuadratic({}, {}), InvalidArgument);
  std::vector<double> values(7, 1.0);
  EXPECT_EQ(FitQuadratic(Points(7, 2), values).predicted, 0.0) << "all equal";
  values[3] = std::nan("");
  EXPECT_THROW(FitQuadratic(Points(7, 2), values), InvalidArgument);
  const QuadraticSurface plane{0.0, VectorX::Ones(2), MatrixX::Zero(2, 2)};
  EXPECT_THROW(HighestOf(plane, VectorX::Ones(2), VectorX::Ones(2)), InvalidArgument);
  EXPECT_THROW(HighestOf(plane, VectorX::Zero(3), VectorX::Ones(3)), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
