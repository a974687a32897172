// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/cubic_spline.h"
#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {
namespace {

SwingCurve Curve(double cruise = 0.0) {
  SwingCurve curve{1.0, 1.4, Pose::Identity(), Pose::Identity(), 0.05};
  curve.cruise = cruise;
  curve.X_WF_end.translation() = Vector3(0.2, 0.05, 0.1);
  curve.X_WF_end.linear() = YawRotation(0.4);
  return curve;
}

TEST(SwingCurve, IsAtRestOnItsEnds) {
  for (const SwingCurve& curve : {Curve(), Curve(0.5)}) {
    for (const double t : {1.0, 1.4}) {
      const FrameMotion motion = Evaluate(curve, t);
      EXPECT_LT(motion.v_WF.norm() + motion.a_WF.norm() + motion.w_WF.norm() + motion.alpha_WF.norm(), 1e-9);
    }
    EXPECT_TRUE(Evaluate(curve, 1.0).X_WF.isApprox(curve.X_WF_start, 1e-12));
    EXPECT_TRUE(Evaluate(curve, 1.4).X_WF.isApprox(curve.X_WF_end, 1e-12));
  }
}

TEST(SwingCurve, CruisesAtConstantSpeedInTheMiddle) {
  for (const double cruise : {0.1, 0.5, 0.9}) {
    const double rate = 1.0 / (cruise + (1.0 - cruise) / 1.875);
    for (const double share : {-0.49, -0.2, 0.0, 0.3, 0.49}) {
      const Motion1 middle = SmoothStep(0.5 + share * cruise, cruise);
      EXPECT_NEAR(middle.value, 0.5 + rate * share * cruise, 1e-12);
      EXPECT_NEAR(middle.rate, rate, 1e-12);
      EXPECT_EQ(middle.acceleration, 0.0);
    }
    for (const double u : {0.01, 0.05, 0.3}) {
      const Motion1 early = SmoothStep(u, cruise), late = SmoothStep(1.0 - u, cruise);
      EXPECT_NEAR(early.value + late.value, 1.0, 1e-12);
      EXPECT_NEAR(early.rate, late.rate, 1e-12);
      EXPECT_LE(early.rate, rate + 1e-12);
      EXPECT_NEAR(early.acceleration, -late.acceleration, 1e-9);
    }
  }
}

TEST(SwingCurve, WithoutCruiseTheStepIsPlain) {
  for (const double u : {0.1, 0.4, 0.5, 0.8}) {
    const Motion1 plain = SmoothStep(u), hardly = SmoothStep(u, 1e-9);
    EXPECT_NEAR(plain.value, hardly.value, 1e-8);
    EXPECT_NEAR(plain.rate, hardly.rate, 1e-7);
    EXPECT_NEAR(plain.acceleration, hardly.acceleration, 1e-6);
  }
}

TEST(SwingCurve, RatesAreDerivatives) {
  constexpr double kStep = 1e-5;
  for (const SwingCurve& curve : {Curve(), Curve(0.3)}) {
    for (double t = 1.05; t < 1.4; t += 0.05) {
      const FrameMotion now = Evaluate(curve, t), before = Evaluate(curve, t - kStep),
                        after = Evaluate(curve, t + kStep);
      const Vector3 v = (after.X_WF.translation() - before.X_WF.translation()) / (2.0 * kStep);
      const Vector3 w = RotationLog(after.X_WF.linear() * before.X_WF.linear().transpose()) / (2.0 * kStep);
      ASSERT_GT(v.norm(), 1e-3);
      EXPECT_LT((v - now.v_WF).norm(), 1e-6);
      EXPECT_LT((w - now.w_WF).norm(), 1e-6);
      EXPECT_LT(((after.v_WF - before.v_WF) / (2.0 * kStep) - now.a_WF).norm(), 1e-4);
      EXPECT_LT(((after.w_WF - before.w_WF) / (2.0 * kStep) - now.alpha_WF).norm(), 1e-4);
    }
    EXPECT_NEAR(LiftAtHalfTime(curve), curve.lift_m, 1e-15);
  }
}

TEST(CubicSpline, InterpolatesAndIsSmooth) {
  const CubicSpline spline(1.0, 0.5, {0.0, 1.0, -1.0, 2.0});
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(spline.At(1.0 + 0.5 * i).value, (std::vector<double>{0.0, 1.0, -1.0, 2.0})[static_cast<std::size_t>(i)],
                1e-12);
  for (const double knot : {1.5, 2.0}) {
    EXPECT_NEAR(spline.At(knot - 1e-9).rate, spline.At(knot + 1e-9).rate, 1e-6);
    EXPECT_NEAR(spline.At(knot - 1e-9).acceleration, spline.At(knot + 1e-9).acceleration, 1e-5);
  }
  EXPECT_NEAR(spline.At(1.0 + 1e-9).rate, 0.0, 1e-6);
  EXPECT_THROW(CubicSpline(0.0, 0.1, {1.0}), InvalidArgument);
}

TEST(Rotation, LogUndoesExp) {
  for (const double angle : {0.0, 1e-9, 1e-4, 0.5, 3.0, 3.14159}) {
    const Vector3 vector = angle * Vector3(1.0, -2.0, 0.5).normalized();
    EXPECT_LT((RotationLog(RotationExp(vector)) - vector).norm(), 1e-7) << angle;
  }
  EXPECT_NEAR(WrapAngle(7.0), 7.0 - 2.0 * 3.14159265358979, 1e-12);
}

}  // namespace
}  // namespace gaitwright
