// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numbers>

#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/pipeline/turning_leap_internal.h"
#include "planning/audit/audit.h"
#include "planning/audit/audit_report.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/robot_of_plan.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

/// Contacts of one backflip: the fore feet lift off and land before the hind feet, half a metre behind.
MotionPlan BackflipContacts(const RobotModel& model) {
  constexpr double kStand = 0.8, kDelay = 0.16, kFlight = 0.36, kLanded = 1.2, kBack = 0.5;
  const double fore_s = kStand, hind_s = fore_s + kDelay, land_s = hind_s + kFlight, end_s = land_s + kDelay + kLanded;
  MotionPlan plan;
  SetRobot(model, plan);
  plan.terrain = FlatTerrain();
  std::vector<std::vector<ContactInterval>> stances;
  const std::vector<Pose> feet = StandingFeet(model);
  for (int foot = 0; foot < 4; ++foot) {
    const bool fore = foot < 2;
    const Pose& from = feet[static_cast<std::size_t>(foot)];
    Pose to = from;
    to.translation().x() -= kBack;
    const double liftoff_s = fore ? fore_s : hind_s, touchdown_s = fore ? land_s : land_s + kDelay;
    stances.push_back({{0.0, liftoff_s}, {touchdown_s, end_s}});
    plan.footsteps.footholds.push_back({foot, from, Vector3::Zero(), 0, 0.0, liftoff_s});
    plan.footsteps.footholds.push_back({foot, to, Vector3::Zero(), 0, touchdown_s, end_s});
    plan.swings.push_back({foot, liftoff_s, touchdown_s, from, to});
  }
  SortFootholds(plan.footsteps);
  plan.schedule = ScheduleFromIntervals(stances, 0.0, end_s);
  MotionPart part{{"backflip", "", 1.0, {0.0, 0.0, 0.0, 0.0}, {0.5, 0.5, 0.5, 0.5}, 0.0, -1.0}, {}, {}, 0.0, end_s};
  part.command.extent = WalkCommand::Extent::kGoal;
  part.command.goal_x_m = -kBack;
  plan.goal = part.goal = {-kBack, 0.0, 0.0};
  plan.parts = {part};
  return plan;
}

class Backflips : public testing::TestWithParam<const char*> {};

TEST_P(Backflips, FinishedPlansPassTheirAudit) {
  const RobotModel& model = NamedRobot(GetParam());
  MotionPlan plan = BackflipContacts(model);
  const Vector3 turn_W = -2.0 * std::numbers::pi * Vector3::UnitY();
  const std::optional<Failure> failure = SetTurningLeap(model, turn_W, LeapShapeOf(model), 0.005, plan);
  ASSERT_FALSE(failure.has_value()) << failure->message;
  TrajectoryOptions options;
  options.near = 0.3;
  options.effort = 1.0;
  options.max_iterations = 150;
  Result<MotionPlan> finished = FinishMotion(model, plan, options);
  ASSERT_TRUE(finished.ok()) << finished.failure().message;
  FitSwings(model, *finished);
  double upside_down = 1.0;
  for (const VectorX& q : finished->whole_body.q) upside_down = std::min(upside_down, BaseRotation(q)(2, 2));
  EXPECT_LT(upside_down, -0.9) << "the body turns over";
  const Result<AuditReport> audit = Audit(model, *finished, {});
  ASSERT_TRUE(audit.ok()) << audit.failure().message;
  EXPECT_TRUE(audit->violations.empty()) << AuditText(*audit);
}

INSTANTIATE_TEST_SUITE_P(OfQuadrupeds, Backflips, testing::Values("a1"));

}  // namespace
}  // namespace gaitwright
