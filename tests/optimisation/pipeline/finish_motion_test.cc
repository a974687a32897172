// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "kinematics/model/upper_body.h"
#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/pipeline/plan_motion.h"
#include "planning/audit/audit.h"
#include "planning/footsteps/ways_to_standing_internal.h"
#include "planning/gait/find_gait.h"
#include "planning/plan/built_in_terrain.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

MotionPlan Planned(const RobotModel& model, const std::string& gait, double speed_m_s, double distance_m) {
  WalkCommand command;
  command.speed_m_s = speed_m_s;
  command.distance_m = distance_m;
  const Result<Gait> found = FindGait(model, gait, speed_m_s, {});
  EXPECT_TRUE(found.ok());
  const Result<PlannedMotion> planned = PlanMotion(model, FlatTerrain(0.8), *found, command, {});
  EXPECT_TRUE(planned.ok()) << (planned.ok() ? "" : planned.failure().message);
  return planned->plan;
}

const MotionPlan& Trot() {
  static const MotionPlan plan = Planned(NamedRobot("a1"), "trot", 0.5, 0.3);
  return plan;
}

void ExpectSound(const RobotModel& model, const MotionPlan& plan) {
  const Result<AuditReport> audit = Audit(model, plan, {});
  ASSERT_TRUE(audit.ok());
  for (const Violation& v : audit->violations)
    ADD_FAILURE() << LawName(v.law) << " at " << v.at_s << ", " << v.where << ": " << v.value << " over " << v.limit;
}

TEST(FinishMotion, BalancesATrotBetweenKnots) {
  const RobotModel& model = NamedRobot("a1");
  FinishReport report;
  const Result<MotionPlan> finished = FinishMotion(model, Trot(), {}, 0.9, &report);
  ASSERT_TRUE(finished.ok()) << finished.failure().message;
  ExpectSound(model, *finished);
  EXPECT_LE(report.residual_force, 1e-3);
  EXPECT_LE(report.residual_moment, 1e-3);
  EXPECT_GT(report.knots, 100);
  EXPECT_GT(report.solves, 1);
  EXPECT_LT((finished->whole_body.q.front() - Trot().whole_body.q.front()).norm(), 1e-6);
  for (std::size_t i = 0; i < Trot().footsteps.footholds.size(); ++i) {
    const Pose &before = Trot().footsteps.footholds[i].X_WF, &after = finished->footsteps.footholds[i].X_WF;
    EXPECT_LT((before.translation() - after.translation()).norm(), 5e-3);
  }
}

TEST(FinishMotion, FeetThatRollLandWhereTheyStandAtTheEndIfAsked) {
  const RobotModel& model = NamedRobot("a1");
  MotionPlan shifted = Trot();
  constexpr double kShift = 0.008;  // [m] of the last landing of a foot
  const auto last_of = [](auto& of_feet) {
    return std::find_if(of_feet.rbegin(), of_feet.rend(), [](const auto& of_foot) { return of_foot.foot == 0; });
  };
  last_of(shifted.footsteps.footholds)->X_WF.translation().y() += kShift;
  last_of(shifted.swings)->X_WF_end.translation().y() += kShift;
  const auto beside_m = [&](bool end_as_standing) {
    const Result<MotionPlan> finished = FinishMotion(model, shifted, {}, 0.9, nullptr, end_as_standing);
    EXPECT_TRUE(finished.ok()) << finished.failure().message;
    ExpectSound(model, *finished);
    return FindOffsetsToStanding(model, finished->whole_body.q.back()).largest_m();
  };
  EXPECT_GT(beside_m(false), 0.5 * kShift);
  EXPECT_LT(beside_m(true), 3e-4);
}

/// The largest violation of a law in a plan, over its limit; 0 for none.
double WorstOf(const RobotModel& model, const MotionPlan& plan, Law law) {
  double worst = 0.0;
  const AuditReport audit = Audit(model, plan, {}).value();
  for (const Violation& v : audit.violations) {
    if (v.law == law) worst = std::max(worst, v.value / v.limit);
  }
  return worst;
}

TEST(FinishMotion, KeepsLimitsOfJerk) {
  RobotModel limited = NamedRobot("a1");
  for (Motor& motor : limited.motors) motor.jerk_limit = 8000.0;  // [rad/s^3], half of what the plan takes
  const MotionPlan plan = Planned(limited, "trot", 0.5, 0.3);
  EXPECT_GT(WorstOf(limited, plan, Law::kJointJerk), 1.5);
  const Result<MotionPlan> finished = FinishMotion(limited, plan, {});
  ASSERT_TRUE(finished.ok()) << finished.failure().message;
  ExpectSound(limited, *finished);
}

/// The root mean square is over the whole plan, and no knot alone can hold it.
TEST(FinishMotion, CoolsMotorsThatPassTheirContinuousLimit) {
  RobotModel limited = NamedRobot("a1");
  Motor& knee = limited.motors[2];
  knee.continuous_effort = 0.01;
  const Result<MotionPlan> usual = FinishMotion(NamedRobot("a1"), Trot(), {});
  ASSERT_TRUE(usual.ok()) << usual.failure().message;
  knee.continuous_effort *= 0.95 * WorstOf(limited, *usual, Law::kContinuousTorque);
  EXPECT_GT(WorstOf(limited, *usual, Law::kContinuousTorque), 1.04);
  const Result<MotionPlan> cooled = FinishMotion(limited, Trot(), {});
  ASSERT_TRUE(cooled.ok()) << cooled.failure().message;
  ExpectSound(limited, *cooled);
}

/// As grippers do: the slightest motion would need all of the dry friction.
TEST(FinishMotion, JointsThatStickDoNotMove) {
  RobotModel model = NamedRobot("nao");
  const int dof = 0;
  for (Joint& joint : model.joints) {
    if (joint.dof == dof) joint.friction = 0.98 * joint.effort_limit;
  }
  const Result<MotionPlan> finished =
      FinishMotion(model, Planned(NamedRobot("nao"), "walk", 0.05, 0.04), {.knot_step_s = 0.02});
  ASSERT_TRUE(finished.ok()) << finished.failure().message;
  for (std::size_t row = 0; row < finished->whole_body.q.size(); ++row) {
    EXPECT_EQ(finished->whole_body.q[row][7 + dof], finished->whole_body.q.front()[7 + dof]);
    EXPECT_EQ(finished->whole_body.v[row][6 + dof], 0.0);
    EXPECT_EQ(finished->whole_body.a[row][6 + dof], 0.0);
  }
}

TEST(FinishMotion, MendsAMotionThatDoesNotBalance) {
  const RobotModel& model = NamedRobot("a1");
  MotionPlan plan = Trot();
  const double length = plan.duration_s();
  for (int row = 0; row < plan.whole_body.size(); ++row) {
    const auto k = static_cast<std::size_t>(row);
    const double share = row * plan.whole_body.step_s / length;
    plan.whole_body.q[k].y() += 0.02 * std::pow(std::sin(3.14159265 * share), 4.0);
    for (ContactWrench& wrench : plan.whole_body.wrenches[k]) wrench = {};
  }
  const Result<AuditReport> broken = Audit(model, plan, {});
  ASSERT_TRUE(broken.ok());
  EXPECT_FALSE(broken->violations.empty());
  const Result<MotionPlan> finished = FinishMotion(model, plan, {});
  ASSERT_TRUE(finished.ok()) << finished.failure().message;
  ExpectSound(model, *finished);
}

TEST(FinishMotion, GivesTheSameBytesEachTime) {
  const RobotModel& model = NamedRobot("a1");
  const TrajectoryOptions one_solve{.max_solves = 1};
  const Result<MotionPlan> first = FinishMotion(model, Trot(), one_solve),
                           second = FinishMotion(model, Trot(), one_solve);
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ(first->whole_body.q, second->whole_body.q);
  EXPECT_EQ(first->whole_body.tau, second->whole_body.tau);
}

TEST(FinishMotion, KeepsSolesOnTheirFootholds) {
  const RobotModel& model = NamedRobot("nao");
  const Result<MotionPlan> finished = FinishMotion(model, Planned(model, "walk", 0.05, 0.04), {.knot_step_s = 0.02});
  ASSERT_TRUE(finished.ok()) << finished.failure().message;
  ExpectSound(model, *finished);
}

/// Largest horizontal over vertical force of all feet together, while they carry some of the weight.
double LargestSlope(const RobotModel& model, const MotionPlan& plan) {
  double largest = 0.0;
  for (const std::vector<ContactWrench>& wrenches : plan.whole_body.wrenches) {
    Vector3 sum_W = Vector3::Zero();
    for (const ContactWrench& wrench : wrenches) sum_W += wrench.force_W;
    if (sum_W.z() > 0.3 * model.weight_n()) largest = std::max(largest, sum_W.head<2>().norm() / sum_W.z());
  }
  return largest;
}

TEST(FinishMotion, SolesUseAQuarterOfTheirFrictionIfThatIsEnough) {
  constexpr double kUse = 0.9, kQuarter = 0.25;
  const RobotModel& model = NamedRobot("nao");
  MotionPlan plan = Planned(model, "walk", 0.05, 0.04);
  const double before = LargestSlope(model, plan);
  // A quarter is a little less than the plan takes now.
  plan.terrain = FlatTerrain(0.9 * before / (kQuarter * kUse));
  const Result<MotionPlan> spared = FinishMotion(model, plan, {.knot_step_s = 0.02}, kUse);
  ASSERT_TRUE(spared.ok()) << spared.failure().message;
  EXPECT_LE(LargestSlope(model, *spared), 0.91 * before);
  // A quarter is far too little.
  plan.terrain = FlatTerrain(1.3 * before / kUse);
  const Result<MotionPlan> slippery = FinishMotion(model, plan, {.knot_step_s = 0.02}, kUse);
  ASSERT_TRUE(slippery.ok()) << slippery.failure().message;
  EXPECT_GT(LargestSlope(model, *slippery), 1.3 * kQuarter * before);
  ExpectSound(model, *slippery);
}

TEST(FinishMotion, TakesAnArmOutOfTheTrunk) {
  const RobotModel& model = NamedRobot("nao");
  MotionPlan plan = Planned(model, "walk", 0.05, 0.04);
  const int dof = FindUpperBody(model).left_arm->dofs[1];  // of the shoulder, about the forward axis
  const double length = plan.duration_s();
  for (int row = 0; row < plan.whole_body.size(); ++row) {
    const double share = row * plan.whole_body.step_s / length;
    plan.whole_body.q[static_cast<std::size_t>(row)][7 + dof] -= 0.5 * std::pow(std::sin(3.14159265 * share), 2.0);
  }
  const Result<AuditReport> broken = Audit(model, plan, {});
  ASSERT_TRUE(broken.ok());
  EXPECT_TRUE(std::ranges::any_of(broken->violations,
                                  [](const Violation& v) { return v.law == Law::kSelfCollision && v.value > 5e-3; }));
  FinishReport report;
  const Result<MotionPlan> finished = FinishMotion(model, plan, {.knot_step_s = 0.02}, 0.9, &report);
  ASSERT_TRUE(finished.ok()) << finished.failure().message;
  ExpectSound(model, *finished);
  EXPECT_FALSE(report.apart.empty());
}

TEST(FinishMotion, NamesWhatForbidsAMotion) {
  RobotModel weak = NamedRobot("a1");
  for (Joint& joint : weak.joints) {
    if (joint.name.find("calf") != std::string::npos) joint.effort_limit = 1.0;
  }
  const Result<MotionPlan> finished = FinishMotion(weak, Trot(), {});
  ASSERT_FALSE(finished.ok());
  EXPECT_EQ(finished.failure().kind, FailureKind::kInfeasible);
  EXPECT_NE(finished.failure().message.find("torque of '"), std::string::npos) << finished.failure().message;
}

TEST(FinishMotion, RefusesWhatItDoesNotTake) {
  const RobotModel& model = NamedRobot("a1");
  MotionPlan plan = Trot();
  plan.swings.pop_back();
  EXPECT_NE(ReasonNotFinished(model, plan).find("swing between"), std::string::npos);
  EXPECT_THROW(static_cast<void>(FinishMotion(model, plan, {})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(FinishMotion(model, MotionPlan{}, {})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(FinishMotion(model, Trot(), {.knot_step_s = 1.0})), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
