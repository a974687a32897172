// SPDX-License-Identifier: BSD-3-Clause
#include "examples/zmp_demonstration.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "examples/shift_picture.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "tests/named_robot.h"

namespace gaitwright::examples {
namespace {

constexpr double kPeak = 5.7735026918962575;  // 10 / sqrt(3): minimum-jerk acceleration over distance / time^2

TEST(ZmpDemonstrationExample, SlowlyTheZmpIsUnderTheCentreOfMass) {
  const ShownShift slow = ShiftBody(NamedRobot("nao"), {0.0, 0.03}, 2.0);
  EXPECT_LT(slow.lead_m, 2e-3);
  EXPECT_LT(slow.off_formula_m, 0.5e-3);
  EXPECT_NEAR(slow.margin_measured_m, slow.margin_planned_m, 1e-4);
  EXPECT_LT(slow.tilt_rad, 1e-3);
  EXPECT_FALSE(slow.fell);
  const MotionSample& end = slow.series.measured.back();
  EXPECT_NEAR(end.p_WC.y() - slow.series.measured.front().p_WC.y(), 0.03, 1e-3);
  EXPECT_NEAR(end.p_WZ.y(), end.p_WC.y(), 1e-4);
}

// Kajita's table and cart: the lead is (z / g) a, and so falls with the square of the time.
TEST(ZmpDemonstrationExample, AFastShiftMovesTheZmpWithTheAcceleration) {
  const RobotModel nao = NamedRobot("nao");
  for (const Vector2& shift_m : {Vector2(0.0, 0.03), Vector2(0.02, 0.0)}) {
    const ShownShift fast = ShiftBody(nao, shift_m, 0.4), half = ShiftBody(nao, shift_m, 0.8);
    EXPECT_NEAR(fast.lead_m / half.lead_m, 4.0, 0.1);
    const double z = fast.series.measured.front().p_WC.z();
    const double formula_m = z / kGravity * kPeak * shift_m.norm() / (0.4 * 0.4);
    EXPECT_GT(formula_m, 0.015);
    EXPECT_LT(fast.off_formula_m, 0.25 * fast.lead_m);
    EXPECT_NEAR(fast.lead_m - fast.off_formula_m, formula_m, 0.01 * formula_m);
    EXPECT_NEAR(fast.margin_measured_m, fast.margin_planned_m, 0.5e-3);
    EXPECT_LT(fast.tilt_rad, 1e-3);
  }
}

// The second road to the same point: the moment of the ground's force about C is the rate of the angular momentum L,
//   Z_y = C_y - (z C_y'' - L_x' / m) / (g + z'').
TEST(ZmpDemonstrationExample, WhatTheFormulaLeavesIsAngularMomentum) {
  const RobotModel nao = NamedRobot("nao");
  const ShownShift fast = ShiftBody(nao, {0.0, 0.03}, 0.4);
  DynamicsScratch scratch(nao);
  const auto momentum = [&](std::size_t k) {
    const WholeBodySample& row = fast.series.plan[k];
    ForwardVelocities(nao, row.q, row.v, scratch);
    return CentroidalMomentum(nao, scratch);
  };
  double off_m = 0.0;
  for (std::size_t k = 1; k < fast.series.measured.size(); ++k) {
    const MotionSample &before = fast.series.measured[k - 1], &now = fast.series.measured[k];
    const Vector6 rate = (momentum(k) - momentum(k - 1)) / (now.time_s - before.time_s);
    const Vector3 p_WC = 0.5 * (before.p_WC + now.p_WC);
    const double zmp_m = p_WC.y() - (p_WC.z() * rate[1] - rate[3]) / (nao.weight_n() + rate[2]);
    off_m = std::max(off_m, std::abs(zmp_m - now.p_WZ.y()));
  }
  EXPECT_GT(fast.off_formula_m, 5e-3);
  EXPECT_LT(off_m, 1.5e-3);
}

TEST(ZmpDemonstrationExample, AtTheEdgeOfTheSupportItTips) {
  const RobotModel nao = NamedRobot("nao");
  const ShownShift tips = ShiftBody(nao, {0.0, 0.03}, 0.25), falls = ShiftBody(nao, {0.0, 0.05}, 0.25);
  for (const ShownShift& shift : {tips, falls}) {
    EXPECT_LT(shift.margin_planned_m, -0.02);
    EXPECT_NEAR(shift.margin_measured_m, 0.0, 1e-4) << "the ground does not pull";
    EXPECT_GT(shift.tilt_rad, 3e-3);
  }
  EXPECT_FALSE(tips.fell);
  EXPECT_TRUE(falls.fell);
  EXPECT_FALSE(ShiftBody(nao, {0.0, 0.05}, 1.0).fell);
  const std::string picture = ShiftPicture({tips, falls}, 1);
  for (const std::string word : {"in 0.25 s<", "in 0.25 s: it falls<", "c - (z / g) c", "ZMP measured", "y [m]"})
    EXPECT_NE(picture.find(word), std::string::npos) << word;
  EXPECT_EQ(picture.find("nan"), std::string::npos);
}

TEST(ZmpDemonstrationExample, WhatCannotBeIsNamed) {
  EXPECT_THROW(ShiftBody(NamedRobot("nao"), {0.0, 0.03}, 0.0), InvalidArgument);
  EXPECT_THROW(ShiftBody(NamedRobot("nao"), {0.0, std::nan("")}, 1.0), InvalidArgument);
  try {
    ShiftBody(NamedRobot("nao"), {0.0, 0.2}, 2.0);
    ADD_FAILURE();
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("cannot reach"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gaitwright::examples
