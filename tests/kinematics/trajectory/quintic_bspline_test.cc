// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/trajectory/quintic_bspline.h"

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
