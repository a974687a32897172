// SPDX-License-Identifier: BSD-3-Clause
#include "examples/standing_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"

namespace gaitwright::examples {
namespace {

const Stander& Humanoid() {
  static const Stander stander = MakeStander("humanoid");
  return stander;
}

bool Stands(const std::string& strategy, double force_n, double direction_deg) {
  return StandsPush(Humanoid(), *MakeStandingStrategy(Humanoid(), strategy), force_n, direction_deg);
}

TEST(StandingControlExample, TheHumanoidStandsWithEach) {
  for (const std::string& strategy : StandingStrategies()) EXPECT_TRUE(Stands(strategy, 20.0, 30.0)) << strategy;
}

/// To the left: each strategy takes what the one before it does not.
TEST(StandingControlExample, EachStrategyTakesAPushThatThePreviousOneDoesNot) {
  EXPECT_FALSE(Stands("soft joints", 190.0, 90.0));
  EXPECT_TRUE(Stands("ankle", 190.0, 90.0));
  EXPECT_FALSE(Stands("ankle", 208.0, 90.0));
  EXPECT_TRUE(Stands("ankle and DCM", 208.0, 90.0));
  EXPECT_FALSE(Stands("ankle and DCM", 228.0, 90.0));
  EXPECT_TRUE(Stands("hip", 228.0, 90.0));
  EXPECT_FALSE(Stands("hip", 280.0, 90.0));
  EXPECT_TRUE(Stands("steps", 280.0, 90.0));
  EXPECT_FALSE(Stands("steps", 480.0, 90.0));
}

/// The whole body's strategy holds the attitude too, which the hips give up: it takes less, and steps from there take
/// more.
TEST(StandingControlExample, StepsTakeWhatTheWholeBodyDoesNot) {
  EXPECT_TRUE(Stands("whole body", 185.0, 90.0));
  EXPECT_FALSE(Stands("whole body", 208.0, 90.0));
  EXPECT_TRUE(Stands("steps", 208.0, 90.0));
}

/// How far the soles reach in front of the centre of mass [m].
double SoleReach() {
  const auto& [model, plan] = Humanoid();
  DynamicsScratch scratch(model);
  ForwardKinematics(model, plan.whole_body.q.front(), scratch);
  double toe_m = -1.0;
  for (const Vector3& p_W : ContactPoints(model, scratch, 0)) toe_m = std::max(toe_m, p_W.x());
  return toe_m - CentreOfMass(model, scratch).x();
}

/// A block on its soles is caught while its DCM is over them. With the ZMP at their edge, d forward, meanwhile
/// (xi' = w (xi - d) + F / (m w)), a push F for T takes it there by  F = m w^2 d / (1 - e^{-w T}).
TEST(StandingControlExample, StiffJointsHoldToTheEdgeOfTheSoles) {
  const double omega = Humanoid().plan.centroidal.omega_rad_s;
  const double limit_n = Humanoid().model.total_mass_kg * omega * omega * SoleReach() / (1.0 - std::exp(-0.1 * omega));
  EXPECT_NEAR(LargestPush(Humanoid(), "stiff joints", 0.0, 400.0), limit_n, 0.05 * limit_n);
}

TEST(StandingControlExample, WhatThereIsNotIsNamed) {
  EXPECT_THROW(MakeStander("a2"), InvalidArgument);
  EXPECT_THROW(MakeStandingStrategy(Humanoid(), "tail"), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright::examples
