// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/trajectory/bspline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "kinematics/base/result.h"
#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {
namespace {

TEST(QuinticBasis, SumsToOneAndItsDerivativesToZero) {
  for (const int points : {6, 7, 9, 14}) {
    for (double u = 0.0; u <= 1.0; u += 0.01) {
      const QuinticBasis basis = EvaluateQuinticBasis(points, u);
      EXPECT_NEAR(std::accumulate(basis.value.begin(), basis.value.end(), 0.0), 1.0, 1e-12);
      EXPECT_NEAR(std::accumulate(basis.rate.begin(), basis.rate.end(), 0.0), 0.0, 1e-9);
      EXPECT_NEAR(std::accumulate(basis.acceleration.begin(), basis.acceleration.end(), 0.0), 0.0, 1e-7);
      for (const double value : basis.value) EXPECT_GE(value, 0.0);
      EXPECT_GE(basis.first, 0);
      EXPECT_LE(basis.first + 6, points);
    }
  }
}

TEST(QuinticBasis, SixPointsAreBernsteinPolynomials) {
  for (double u = 0.0; u <= 1.0; u += 0.1) {
    const QuinticBasis basis = EvaluateQuinticBasis(6, u);
    const double binomial[6] = {1, 5, 10, 10, 5, 1};
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(basis.value[static_cast<std::size_t>(i)], binomial[i] * std::pow(u, i) * std::pow(1.0 - u, 5 - i),
                  1e-12);
  }
}

TEST(QuinticBasis, RatesAreDerivatives) {
  constexpr double kStep = 1e-6;
  for (double u = 0.03; u < 1.0; u += 0.05) {
    const QuinticBasis now = EvaluateQuinticBasis(11, u), before = EvaluateQuinticBasis(11, u - kStep),
                       after = EvaluateQuinticBasis(11, u + kStep);
    ASSERT_EQ(before.first, after.first);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR((after.value[i] - before.value[i]) / (2.0 * kStep), now.rate[i], 1e-6);
      EXPECT_NEAR((after.rate[i] - before.rate[i]) / (2.0 * kStep), now.acceleration[i], 1e-4);
    }
  }
}

/// A spline of the basis with its derivatives, for given control points.
Motion1 SplineAt(const std::vector<double>& knots, const std::vector<double>& points, double t) {
  const CubicBasis basis = EvaluateCubicBasis(knots, t);
  Motion1 at;
  for (std::size_t i = 0; i < 4; ++i) {
    const double p = points[static_cast<std::size_t>(basis.first) + i];
    at.value += basis.value[i] * p;
    at.rate += basis.rate[i] * p;
    at.acceleration += basis.acceleration[i] * p;
  }
  return at;
}

const std::vector<double> kUnevenKnots = {-0.3, 0.0, 0.02, 0.5, 0.55, 1.4};

TEST(CubicBasis, SumsToOneAndItsDerivativesToZero) {
  for (double t = -0.3; t <= 1.4; t += 0.01) {
    const CubicBasis basis = EvaluateCubicBasis(kUnevenKnots, t);
    EXPECT_NEAR(std::accumulate(basis.value.begin(), basis.value.end(), 0.0), 1.0, 1e-12);
    EXPECT_NEAR(std::accumulate(basis.rate.begin(), basis.rate.end(), 0.0), 0.0, 1e-9);
    EXPECT_NEAR(std::accumulate(basis.acceleration.begin(), basis.acceleration.end(), 0.0), 0.0, 1e-7);
    for (const double value : basis.value) EXPECT_GE(value, 0.0);
    EXPECT_GE(basis.first, 0);
    EXPECT_LE(basis.first + 4, static_cast<int>(kUnevenKnots.size()) + 2);
  }
}

TEST(CubicBasis, OneIntervalIsBernsteinPolynomials) {
  for (double t = 2.0; t <= 4.0; t += 0.2) {
    const CubicBasis basis = EvaluateCubicBasis({2.0, 4.0}, t);
    const double binomial[4] = {1, 3, 3, 1}, u = (t - 2.0) / 2.0;
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(basis.value[static_cast<std::size_t>(i)], binomial[i] * std::pow(u, i) * std::pow(1.0 - u, 3 - i),
                  1e-12);
  }
}

TEST(CubicBasis, MakesSplinesThatAreTwiceDifferentiableWithTheirRates) {
  const std::vector<double> points = {0.3, -1.0, 2.0, 0.7, -0.4, 1.1, 0.2, 3.0};
  constexpr double kStep = 1e-7;
  for (const double t : {-0.2, 0.0, 0.01, 0.02, 0.3, 0.5, 0.52, 0.55, 1.0}) {
    const Motion1 now = SplineAt(kUnevenKnots, points, t), before = SplineAt(kUnevenKnots, points, t - kStep),
                  after = SplineAt(kUnevenKnots, points, t + kStep);
    EXPECT_GT(std::abs(now.rate), 0.01) << t;
    EXPECT_NEAR((after.value - before.value) / (2.0 * kStep), now.rate, 1e-4 * std::abs(now.rate)) << t;
    EXPECT_NEAR((after.rate - before.rate) / (2.0 * kStep), now.acceleration, 1e-2 * std::abs(now.acceleration)) << t;
    EXPECT_NEAR(before.acceleration, after.acceleration, 0.01) << t;
  }
}

TEST(CubicBasis, TwoControlPointsDecideValueAndRateAtAnEnd) {
  const std::vector<double> points = {0.3, -1.0, 2.0, 0.7, -0.4, 1.1, 0.2, 3.0};
  const Motion1 start = SplineAt(kUnevenKnots, points, -0.3), end = SplineAt(kUnevenKnots, points, 1.4);
  EXPECT_NEAR(start.value, 0.3, 1e-12);
  EXPECT_NEAR(start.rate, 3.0 * (-1.0 - 0.3) / 0.3, 1e-9);
  EXPECT_NEAR(end.value, 3.0, 1e-12);
  EXPECT_NEAR(end.rate, 3.0 * (3.0 - 0.2) / 0.85, 1e-9);
}

TEST(CubicBasis, AtABreakThreeFunctionsAreLeft) {
  for (std::size_t k = 0; k + 1 < kUnevenKnots.size(); ++k) {
    const CubicBasis basis = EvaluateCubicBasis(kUnevenKnots, kUnevenKnots[k]);
    EXPECT_EQ(basis.first, static_cast<int>(k));
    EXPECT_EQ(basis.value[3], 0.0);
    EXPECT_EQ(basis.rate[3], 0.0);
    EXPECT_NEAR(basis.acceleration[3], 0.0, 1e-12);
  }
}

TEST(CubicBasis, RefusesKnotsThatDoNotIncrease) {
  EXPECT_THROW(EvaluateCubicBasis({}, 0.5), InvalidArgument);
  EXPECT_THROW(EvaluateCubicBasis({1.0}, 0.5), InvalidArgument);
  EXPECT_THROW(EvaluateCubicBasis({0.0, 1.0, 1.0}, 0.5), InvalidArgument);
}

TEST(QuinticBasis, RefusesFewerThanSixPoints) { EXPECT_THROW(EvaluateQuinticBasis(5, 0.5), InvalidArgument); }

TEST(SwingCurve, ADetourIsAtRestOnItsEndsAndHasItsRates) {
  SwingCurve curve{1.0, 1.5, Pose::Identity(), Pose::Identity(), 0.05};
  curve.X_WF_end.translation() = Vector3(0.3, 0.1, 0.05);
  curve.detour_W = {{0.01, 0.0, 0.1}, {-0.02, 0.01, 0.2}, {0.0, 0.0, 0.15}, {0.0, 0.0, 0.05}};
  for (const double t : {0.9, 1.0, 1.0 + 1e-9, 1.5 - 1e-9, 1.5, 1.6}) {
    const FrameMotion motion = Evaluate(curve, t);
    EXPECT_LT(motion.v_WF.norm(), 1e-6) << t;
    EXPECT_LT(motion.a_WF.norm(), 1e-4) << t;
  }
  constexpr double kStep = 1e-5;
  for (double t = 1.02; t < 1.5; t += 0.04) {
    const FrameMotion now = Evaluate(curve, t), before = Evaluate(curve, t - kStep), after = Evaluate(curve, t + kStep);
    ASSERT_GT(now.v_WF.norm(), 1e-3);
    const Vector3 v = (after.X_WF.translation() - before.X_WF.translation()) / (2.0 * kStep);
    EXPECT_LT((v - now.v_WF).norm(), 1e-6);
    EXPECT_LT(((after.v_WF - before.v_WF) / (2.0 * kStep) - now.a_WF).norm(), 1e-3);
  }
  EXPECT_GT(LiftAtHalfTime(curve), 0.1);
}

}  // namespace
}  // namespace gaitwright
