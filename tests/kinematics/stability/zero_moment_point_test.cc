// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/stability/zero_moment_point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

TEST(ZeroMomentPoint, OfAPointMassAtOneHeightIsThePendulums) {
  constexpr double kMass = 7.0, kHeight = 0.6, kGround = 0.2;
  const Vector3 p_WC(0.3, -0.1, kGround + kHeight), a_WC(1.3, -0.7, 0.0);
  const Vector3 force_W = kMass * (a_WC + kGravity * Vector3::UnitZ());
  const Vector2 of_wrench = ZeroMomentPoint(p_WC, force_W, Vector3::Zero(), kGround);
  EXPECT_GT((of_wrench - p_WC.head<2>()).norm(), 0.05);
  EXPECT_LT((of_wrench - PendulumZmp(p_WC, a_WC, std::sqrt(kGravity / kHeight))).norm(), 1e-14);
}

TEST(ZeroMomentPoint, DoesNotDependOnThePointOfReference) {
  const Vector3 p_WP(0.3, -0.1, 0.7), arm(0.2, 0.4, -0.3), force_W(12.0, -7.0, 90.0), moment_W(3.0, -2.0, 5.0);
  const Vector2 here = ZeroMomentPoint(p_WP, force_W, moment_W, 0.1);
  const Vector2 there = ZeroMomentPoint(p_WP + arm, force_W, moment_W - arm.cross(force_W), 0.1);
  EXPECT_LT((here - there).norm(), 1e-14);
  EXPECT_THROW(static_cast<void>(ZeroMomentPoint(p_WP, -force_W, moment_W, 0.1)), InvalidArgument);
}

TEST(DivergentComponent, RunsAwayFromTheZmp) {
  constexpr double kOmega = 3.7, kStep = 1e-6;
  const Vector3 p_WC(0.3, -0.1, 0.7), v_WC(0.4, 0.2, 0.0), a_WC(1.3, -0.7, 0.0);
  const Vector2 now = DivergentComponent(p_WC, v_WC, kOmega);
  const Vector2 next = DivergentComponent(p_WC + kStep * v_WC, v_WC + kStep * a_WC, kOmega);
  EXPECT_LT(((next - now) / kStep - kOmega * (now - PendulumZmp(p_WC, a_WC, kOmega))).norm(), 1e-8);
}

}  // namespace
}  // namespace gaitwright
