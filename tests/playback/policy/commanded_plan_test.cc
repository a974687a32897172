// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kinematics/dynamics/foot_contact.h"
#include "planning/plan/check_motion.h"
#include "planning/plan/plans_contacts_internal.h"
#include "playback/policy/commanded_plan_internal.h"
#include "tests/playback/policy/written_contract.h"

namespace gaitwright {
namespace {

using written::A1;

FittedPolicy CommandedPolicy(const written::ContractText& text, const TimedCommand& command = {}) {
  VelocityCommands commands;
  commands.rows = {command};
  const PolicySource source = written::SourceOf(written::ConstantNetwork(45, Eigen::VectorXf::Zero(12)));
  return FitPolicy(A1(), text.Read(), source, commands).value();
}

TEST(CommandedPlanTest, StandsOnTheGroundInTheDefaultPosture) {
  const written::ContractText text(A1());
  const MotionPlan plan = CommandedPlan(A1(), CommandedPolicy(text), FlatTerrain(), 1.0);
  EXPECT_NO_THROW(CheckMotion(A1(), plan.whole_body));
  EXPECT_FALSE(PlansContacts(plan));
  EXPECT_NEAR(plan.duration_s(), 1.0, 1e-12);
  DynamicsScratch scratch(A1());
  ForwardKinematics(A1(), plan.whole_body.q.front(), scratch);
  for (int foot = 0; foot < 4; ++foot)
    EXPECT_NEAR(ContactFrame(A1(), scratch, foot).translation().z(), 0.0, 2e-3) << foot;
}

TEST(CommandedPlanTest, LevelsFeetOfDifferentHeights) {
  written::ContractText text(A1());
  for (const std::size_t thigh : {7U, 10U}) text.default_position[thigh] += 0.2;  // of the rear legs
  const FittedPolicy policy = CommandedPolicy(text);
  const VectorX q = StartOfPolicy(A1(), policy);
  EXPECT_GT(std::abs(q[4]), 0.005);  // pitch
  EXPECT_LT(UnevenFeet(A1(), policy), 2e-3);
}

TEST(CommandedPlanTest, TheBaseFollowsTheCommand) {
  TimedCommand circle;
  circle.speed_m_s = 0.5;
  circle.yaw_rate_rad_s = std::numbers::pi / 4.0;
  const MotionPlan plan = CommandedPlan(A1(), CommandedPolicy(written::ContractText(A1()), circle), FlatTerrain(), 4.0);
  const double radius = 0.5 / circle.yaw_rate_rad_s;
  EXPECT_NEAR(plan.goal.x_m, 0.0, 1e-9);
  EXPECT_NEAR(plan.goal.y_m, 2.0 * radius, 1e-9);
  EXPECT_NEAR(plan.goal.yaw_rad, std::numbers::pi, 1e-9);
  for (const VectorX& v : plan.whole_body.v) EXPECT_NEAR(v.head<2>().norm(), 0.5, 1e-12);
}

TEST(CommandedPlanTest, DurationsOutOfRangeAreRefused) {
  const FittedPolicy policy = CommandedPolicy(written::ContractText(A1()));
  EXPECT_THROW(CommandedPlan(A1(), policy, FlatTerrain(), 0.0), InvalidArgument);
  EXPECT_THROW(CommandedPlan(A1(), policy, FlatTerrain(), 4000.0), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
