// SPDX-License-Identifier: BSD-3-Clause
// Comparisons of rates with finite differences, and rest at the ends, are in curves_test.cc.
#include "kinematics/trajectory/swing_curve.h"

#include <gtest/gtest.h>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

SwingCurve StepForward(double lift_m = 0.05) {
  SwingCurve curve{2.0, 2.5, Pose::Identity(), Pose::Identity(), lift_m};
  curve.X_WF_start.translation() = Vector3(1.0, 2.0, 0.1);
  curve.X_WF_end.translation() = Vector3(1.3, 2.1, 0.2);
  curve.X_WF_end.linear() = RotationExp({0.1, -0.2, 0.6});
  return curve;
}

TEST(SmoothStep, HasTheMomentsOfTheMinimumJerkMove) {
  const Motion1 middle = SmoothStep(0.5);
  EXPECT_DOUBLE_EQ(middle.value, 0.5);
  EXPECT_DOUBLE_EQ(middle.rate, 15.0 / 8.0);  // Flash and Hogan 1985: the peak speed is 1.875 of the mean
  EXPECT_NEAR(middle.acceleration, 0.0, 1e-15);
  // Largest acceleration at u = (3 - sqrt(3)) / 6: 10 / sqrt(3).
  EXPECT_NEAR(SmoothStep((3.0 - std::sqrt(3.0)) / 6.0).acceleration, 10.0 / std::sqrt(3.0), 1e-12);
}

TEST(SmoothStep, IsConstantOutside) {
  for (const double cruise : {0.0, 0.4}) {
    for (const double u : {-1.0, 0.0}) EXPECT_EQ(SmoothStep(u, cruise).value, 0.0);
    for (const double u : {1.0, 3.0}) EXPECT_EQ(SmoothStep(u, cruise).value, 1.0);
    for (const double u : {-1.0, 0.0, 1.0, 3.0})
      EXPECT_EQ(SmoothStep(u, cruise).rate + SmoothStep(u, cruise).acceleration, 0.0);
  }
}

TEST(SmoothStep, NeverGoesBackAndACruiseLowersTheTopSpeed) {
  double fastest = 2.0;
  for (const double cruise : {0.0, 0.2, 0.5, 0.8}) {
    double top = 0.0, sum = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const Motion1 at = SmoothStep((i + 0.5) / 1000.0, cruise);
      EXPECT_GE(at.rate, 0.0);
      top = std::max(top, at.rate);
      sum += at.rate / 1000.0;
    }
    EXPECT_NEAR(sum, 1.0, 1e-5) << "the rate's integral is the whole step";
    EXPECT_LT(top, fastest);
    EXPECT_GE(top, 1.0);
    fastest = top;
  }
}

TEST(SmoothBump, IsEvenAboutItsMiddleAndOneThere) {
  EXPECT_DOUBLE_EQ(SmoothBump(0.5).value, 1.0);
  EXPECT_DOUBLE_EQ(SmoothBump(0.5).acceleration, -24.0);  // of 64 (1/4 - x^2)^3 about x = 0
  for (const double u : {0.0, 0.1, 0.3, 0.45}) {
    const Motion1 early = SmoothBump(u), late = SmoothBump(1.0 - u);
    EXPECT_NEAR(early.value, late.value, 1e-15);
    EXPECT_NEAR(early.rate, -late.rate, 1e-12);
    EXPECT_NEAR(early.acceleration, late.acceleration, 1e-12);
  }
  for (const double u : {-0.1, 0.0, 1.0, 1.1}) {
    const Motion1 out = SmoothBump(u);
    EXPECT_EQ(out.value, 0.0);
    EXPECT_EQ(out.rate, 0.0);
    EXPECT_EQ(out.acceleration, 0.0);
  }
}

TEST(SwingCurve, HalfwayItIsLiftedAboveTheMiddleAndTurnedByHalf) {
  for (const double cruise : {0.0, 0.3}) {
    SwingCurve curve = StepForward();
    curve.cruise = cruise;
    const FrameMotion middle = Evaluate(curve, 2.25);
    EXPECT_LT((middle.X_WF.translation() - Vector3(1.15, 2.05, 0.2)).norm(), 1e-12);
    EXPECT_LT((RotationLog(middle.X_WF.linear()) - 0.5 * Vector3(0.1, -0.2, 0.6)).norm(), 1e-12);
    EXPECT_NEAR(LiftAtHalfTime(curve), 0.05, 1e-12);
  }
}

TEST(SwingCurve, TheStraightMoveHasTheSameEndsAndNoLift) {
  SwingCurve curve{1.0, 1.5, Pose::Identity(), Pose::Identity(), 0.05};
  curve.X_WF_end.translation() = Vector3(0.3, 0.1, 0.04);
  curve.cruise = 0.4;
  curve.detour_W = {Vector3(0.01, 0.02, 0.1)};
  const SwingCurve straight = StraightMoveOf(curve);
  EXPECT_EQ(LiftAtHalfTime(straight), 0.0);
  EXPECT_GT(LiftAtHalfTime(curve), 0.02);
  EXPECT_EQ(straight.cruise, curve.cruise);
  for (const double time_s : {1.0, 1.5})
    EXPECT_TRUE(Evaluate(straight, time_s).X_WF.isApprox(Evaluate(curve, time_s).X_WF, 1e-14)) << time_s;
}

TEST(SwingCurve, StandsOnItsEndsBeforeAndAfter) {
  const SwingCurve curve = StepForward();
  for (const auto& [time, X] : {std::pair{-1.0, curve.X_WF_start}, std::pair{9.0, curve.X_WF_end}}) {
    const FrameMotion at = Evaluate(curve, time);
    EXPECT_LT((at.X_WF.matrix() - X.matrix()).norm(), 1e-12);
    EXPECT_EQ(at.v_WF.norm() + at.w_WF.norm() + at.a_WF.norm() + at.alpha_WF.norm(), 0.0);
  }
}

TEST(SwingCurve, AMovedWorldMovesTheCurve) {
  Pose X_VW = Pose::Identity();  // a rotation about z, the direction of the lift
  X_VW.linear() = YawRotation(0.7);
  X_VW.translation() = Vector3(-3.0, 0.5, 0.25);
  const SwingCurve curve = StepForward();
  SwingCurve moved = curve;
  moved.X_WF_start = X_VW * curve.X_WF_start;
  moved.X_WF_end = X_VW * curve.X_WF_end;
  for (double t = 2.0; t <= 2.5; t += 0.1) {
    const FrameMotion a = Evaluate(curve, t), b = Evaluate(moved, t);
    EXPECT_LT(((X_VW * a.X_WF).matrix() - b.X_WF.matrix()).norm(), 1e-12);
    EXPECT_LT((X_VW.linear() * a.v_WF - b.v_WF).norm(), 1e-12);
    EXPECT_LT((X_VW.linear() * a.w_WF - b.w_WF).norm(), 1e-12);
    EXPECT_LT((X_VW.linear() * a.a_WF - b.a_WF).norm(), 1e-11);
  }
}

TEST(SwingCurve, AShorterTimeScalesSpeedsAndTheirRates) {
  const SwingCurve slow = StepForward();
  SwingCurve fast = slow;
  fast.end_s = 2.25;
  const FrameMotion a = Evaluate(slow, 2.2), b = Evaluate(fast, 2.1);
  EXPECT_LT((a.X_WF.matrix() - b.X_WF.matrix()).norm(), 1e-12);
  EXPECT_LT((2.0 * a.v_WF - b.v_WF).norm(), 1e-12);
  EXPECT_LT((4.0 * a.a_WF - b.a_WF).norm(), 1e-11);
  EXPECT_LT((4.0 * a.alpha_WF - b.alpha_WF).norm(), 1e-11);
}

TEST(SwingCurve, ADetourReplacesTheBumpAndAddsToTheStraightMove) {
  const SwingCurve flat = StepForward(0.0);
  SwingCurve one = StepForward(0.5), two = one;  // the lift has no effect
  one.detour_W = {Vector3(0.0, 0.0, 0.1), Vector3(0.02, 0.0, 0.1)};
  two.detour_W = {Vector3(0.0, 0.0, 0.2), Vector3(0.04, 0.0, 0.2)};
  for (double t = 2.02; t < 2.49; t += 0.06) {
    const Vector3 straight = Evaluate(flat, t).X_WF.translation();
    const Vector3 detour = Evaluate(one, t).X_WF.translation() - straight;
    EXPECT_GT(detour.z(), 0.0) << t;
    EXPECT_LT(detour.z(), 0.1) << "a spline stays within the hull of its points";
    EXPECT_LT((Evaluate(two, t).X_WF.translation() - straight - 2.0 * detour).norm(), 1e-12) << t;
  }
  EXPECT_NEAR(LiftAtHalfTime(two), 2.0 * LiftAtHalfTime(one), 1e-15);
  EXPECT_EQ(Evaluate(one, 2.0).v_WF.norm(), 0.0);
  EXPECT_EQ(Evaluate(one, 2.5).a_WF.norm(), 0.0);
}

}  // namespace
}  // namespace gaitwright
