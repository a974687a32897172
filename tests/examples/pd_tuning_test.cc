// SPDX-License-Identifier: BSD-3-Clause
#include "examples/pd_tuning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "examples/standing_by_pd.h"
#include "examples/step_picture.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "tests/named_robot.h"

namespace gaitwright::examples {
namespace {

TEST(PdTuningExample, TheKnownAnswerObeysItsEquation) {
  constexpr double kStep = 1e-4, w = 20.0;
  for (const double zeta : {0.0, 0.3, 0.9, 1.0, 1.7}) {
    const auto x = [&](double t) { return SecondOrderStep(w, zeta, t); };
    EXPECT_NEAR(x(0.0), 0.0, 1e-12);
    EXPECT_NEAR((x(kStep) - x(0.0)) / kStep, 0.0, w * w * kStep) << "it begins at rest";
    for (const double t : {0.01, 0.04, 0.3}) {
      const double v = (x(t + kStep) - x(t - kStep)) / (2.0 * kStep);
      const double a = (x(t + kStep) - 2.0 * x(t) + x(t - kStep)) / (kStep * kStep);
      EXPECT_GT(std::abs(a), 0.1) << zeta << " " << t;
      EXPECT_NEAR(a, w * w * (1.0 - x(t)) - 2.0 * zeta * w * v, 1e-3) << zeta << " " << t;
    }
  }
  EXPECT_NEAR(SecondOrderStep(w, 1.0 + 1e-7, 0.1), SecondOrderStep(w, 1.0, 0.1), 1e-6);
}

TEST(PdTuningExample, FiguresOfAStepAreThoseOfTheTextbook) {
  constexpr double kStep = 1e-4, w = 30.0, zeta = 0.4;
  std::vector<double> response;
  for (int k = 1; k <= 10000; ++k) response.push_back(SecondOrderStep(w, zeta, k * kStep));
  const StepShape shape = ShapeOf(response, kStep);
  const double root = std::sqrt(1.0 - zeta * zeta);
  EXPECT_NEAR(shape.overshoot, std::exp(-std::numbers::pi * zeta / root), 1e-5);
  EXPECT_LT(shape.rise_s, (std::numbers::pi - std::acos(zeta)) / (w * root)) << "from 0 % to 100 %";
  EXPECT_GT(shape.rise_s, 1.0 / w);
  EXPECT_LE(shape.settling_s, -std::log(0.02 * root) / (zeta * w)) << "of the envelope";
  EXPECT_GT(shape.settling_s, 2.0 / (zeta * w));
  const StepShape never = ShapeOf({0.2, 0.4}, 0.5);
  EXPECT_EQ(never.overshoot, 0.0);
  EXPECT_EQ(never.rise_s, 1.0);
  EXPECT_EQ(never.settling_s, 1.0);
}

/// The farthest that physics is from the formula.
double OffOf(const JointStep& step) {
  double off = 0.0;
  for (std::size_t k = 0; k < step.simulated.size(); ++k)
    off = std::max(off, std::abs(step.simulated[k] - step.formula[k]));
  return off;
}

// Two roads: Bullet's articulated bodies, and the diagonal of our mass matrix in a closed form.
TEST(PdTuningExample, AJointAnswersAsTheSecondOrderSystemOfItsInertia) {
  const RobotModel nao = NamedRobot("nao"), a1 = LoadNamedRobot("a1").value();
  const JointStep soft = StepJoint(nao, "LHipPitch", 5.0, 0.6, 0.05),
                  rings = StepJoint(nao, "LHipPitch", 20.0, 0.2, 0.05);
  const JointStep calf = StepJoint(a1, "FL_calf_joint", 10.0, 0.3, -0.1);
  for (const JointStep& step : {soft, rings, calf}) {
    EXPECT_EQ(step.simulated.size(), 10000U);
    EXPECT_LT(step.torque_use, 0.9);
    EXPECT_LT(OffOf(step), 2.0 * step.frequency_rad_s * step.step_s) << "the physics is of first order in its step";
    EXPECT_NEAR(step.frequency_rad_s * step.frequency_rad_s * step.inertia_kg_m2, step.stiffness, 1e-9);
    EXPECT_NEAR(2.0 * step.damping_ratio * step.frequency_rad_s * step.inertia_kg_m2, step.damping, 1e-9);
  }
  EXPECT_EQ(soft.inertia_kg_m2, rings.inertia_kg_m2);
  EXPECT_NEAR(rings.frequency_rad_s, 2.0 * soft.frequency_rad_s, 1e-9) << "four times the stiffness";
  EXPECT_LT(ShapeOf(soft.simulated, soft.step_s).overshoot, 0.01);
  EXPECT_GT(ShapeOf(rings.simulated, rings.step_s).overshoot, 0.5);
  const std::string picture = StepPicture({soft, rings}, 2);
  for (const std::string word : {"kp 5, kd 0.6", "kp 20, kd 0.2", "second-order system", "simulated", "time [s]"})
    EXPECT_NE(picture.find(word), std::string::npos) << word;
  EXPECT_EQ(picture.find("nan"), std::string::npos);
}

TEST(PdTuningExample, AMotorAtItsLimitIsNoSecondOrderSystem) {
  const JointStep step = StepJoint(NamedRobot("nao"), "LHipPitch", 200.0, 2.0, 0.1);
  EXPECT_EQ(step.torque_use, 1.0);
  EXPECT_GT(OffOf(step), 0.1);
  EXPECT_GT(ShapeOf(step.simulated, step.step_s).rise_s, 1.5 * ShapeOf(step.formula, step.step_s).rise_s);
}

TEST(PdTuningExample, AnklesYieldAsAnInvertedPendulumDoes) {
  const RobotModel nao = NamedRobot("nao");
  for (const double scale : {1.0, 0.15}) {
    const StoodByPd stood = StandByPd(nao, scale, true);
    EXPECT_TRUE(stood.stands);
    EXPECT_GT(stood.ankles_nm_rad, 2.0 * stood.needed_nm_rad);
    EXPECT_GT(stood.lean_rad, 2e-3);
    EXPECT_NEAR(stood.lean_rad, stood.lean_formula_rad, 0.01 * stood.lean_formula_rad);
  }
}

/// Stiffness of the ankles with which the lean just takes the weight over the toes:
///   k lean = m g toe,   h sin(lean) + x cos(lean) = toe,   all from the ankles and of all but the feet.
double LeastOf(const RobotModel& model, const StoodByPd& stood) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  double weight_n = model.weight_n(), toe_m = 0.0;
  for (const Foot& foot : model.feet) {
    weight_n -= kGravity * model.bodies[static_cast<std::size_t>(foot.body)].mass;
    for (const Vector2& corner : foot.sole_F)
      toe_m = std::max(toe_m, (foot.X_BF * Vector3(corner.x(), corner.y(), 0.0)).x());
  }
  const double h = stood.needed_nm_rad / weight_n;
  const double x = stood.lean_formula_rad * (stood.ankles_nm_rad - stood.needed_nm_rad) / weight_n;
  double lean = 0.0;
  for (int pass = 0; pass < 50; ++pass) lean = std::asin((toe_m - x * std::cos(lean)) / h);
  return weight_n * toe_m / lean;
}

TEST(PdTuningExample, TheAnklesMustBeStifferThanTheWeightTimesItsHeight) {
  const RobotModel nao = NamedRobot("nao");
  const StoodByPd whole = StandByPd(nao, 1.0, true);
  const double least = LeastScale(nao, true) * whole.ankles_nm_rad;
  EXPECT_GT(least, whole.needed_nm_rad);
  EXPECT_NEAR(least, LeastOf(nao, whole), 0.05 * least);
  EXPECT_FALSE(StandByPd(nao, 0.97 * whole.needed_nm_rad / whole.ankles_nm_rad, true).stands);
}

TEST(PdTuningExample, AllJointsTogetherSagByTheStiffnessAndNeedMoreOfIt) {
  const RobotModel nao = NamedRobot("nao");
  const StoodByPd stiff = StandByPd(nao, 4.0, false), half = StandByPd(nao, 2.0, false);
  EXPECT_TRUE(stiff.stands && half.stands);
  EXPECT_GT(half.sag_m, 5e-5);
  EXPECT_NEAR(half.sag_m / stiff.sag_m, 2.0, 0.1);
  const StoodByPd soft = StandByPd(nao, 0.1, false);
  EXPECT_GT(soft.ankles_nm_rad, 1.5 * soft.needed_nm_rad);
  EXPECT_FALSE(soft.stands);
}

TEST(PdTuningExample, WhatCannotBeIsNamed) {
  const RobotModel nao = NamedRobot("nao");
  EXPECT_THROW(StepJoint(nao, "LHipPitch", 0.0, 1.0, 0.1), InvalidArgument);
  EXPECT_THROW(StepJoint(nao, "LHipPitch", 10.0, -1.0, 0.1), InvalidArgument);
  EXPECT_THROW(StepJoint(nao, "LHipPitch", 10.0, 1.0, 0.0), InvalidArgument);
  EXPECT_THROW(StepJoint(nao, "LHipPitch", 10.0, 1.0, std::nan("")), InvalidArgument);
  EXPECT_THROW(StandByPd(nao, -1.0, false), InvalidArgument);
  for (const bool step : {true, false}) {
    try {
      if (step) StepJoint(nao, "LHipPich", 10.0, 1.0, 0.1);
      if (!step) StandByPd(LoadNamedRobot("a1").value(), 1.0, false);
      ADD_FAILURE();
    } catch (const InvalidArgument& error) {
      EXPECT_NE(std::string(error.what()).find(step ? "LHipPitch" : "FL_foot"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace gaitwright::examples
