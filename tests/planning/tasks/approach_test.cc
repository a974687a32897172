// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/approach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/collision/collision_checker.h"
#include "kinematics/dynamics/dynamics.h"
#include "planning/plan/plan_json.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

class Approaching : public testing::TestWithParam<std::string> {
 protected:
  const RobotModel& model() const { return GoodPlanOf(GetParam()).model; }
  const MotionPlan& plan() const { return GoodPlanOf(GetParam()).plan; }
  int n() const { return model().num_dofs(); }
  VectorX First() const { return plan().whole_body.q.front().tail(n()); }
  /// The first posture with each knee bent more, by different amounts, within its limits.
  StartPosture Off(double by) const {
    StartPosture start{First(), {}};
    double share = 1.0;
    for (const Leg& leg : model().legs) {
      const int d = model().joints[static_cast<std::size_t>(leg.knee_joint)].dof;
      const double wanted = start.joints[d] + share * by * leg.knee_sign;
      start.joints[d] = std::clamp(wanted, model().dof_lower(d), model().dof_upper(d));
      share *= 0.8;
    }
    return start;
  }
};

INSTANTIATE_TEST_SUITE_P(Robots, Approaching, testing::Values("a1", "nao"),
                         [](const auto& robot) { return robot.param; });

TEST_P(Approaching, LeadsFromRestToRestAndPassesItsAudit) {
  const StartPosture start = Off(0.3);
  const auto approach = PlanApproach(model(), plan(), start);
  ASSERT_TRUE(approach) << approach.failure().message;
  const WholeBodyTrajectory& w = approach->plan.whole_body;
  EXPECT_LT((w.q.front().tail(n()) - start.joints).norm(), 1e-12);
  EXPECT_LT((w.q.back().tail(n()) - First()).norm(), 1e-12);
  EXPECT_LT(w.v.front().norm() + w.v.back().norm() + w.a.front().norm() + w.a.back().norm(), 1e-9);
  const AuditReport report = Audit(model(), approach->plan, {}).value();
  EXPECT_TRUE(report.pass()) << AuditText(report);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes.back().find("held externally"), std::string::npos) << "what it takes for granted is said";
  EXPECT_FALSE(approach->plan.warnings.empty());
  const auto read = PlanFromJson(PlanToJson(approach->plan), "approach.json");
  ASSERT_TRUE(read) << read.failure().message;
  EXPECT_TRUE(Audit(model(), *read, {})->pass());
}

TEST_P(Approaching, IsNotNeededWithinTheTolerance) {
  AuditOptions audit;
  StartPosture start = Off(0.0);
  EXPECT_FALSE(NeedsApproach(model(), plan(), start, audit));
  start.R_WB = Quaternion(Eigen::AngleAxisd(0.3, Vector3::UnitX()));
  EXPECT_FALSE(NeedsApproach(model(), plan(), start, audit)) << "no joint levels the base";
  start.joints[1] += 0.04;
  EXPECT_FALSE(NeedsApproach(model(), plan(), start, audit));
  audit.start_tolerance_rad = 0.03;
  EXPECT_TRUE(NeedsApproach(model(), plan(), start, audit));
}

TEST_P(Approaching, KeepsToItsShareOfSpeedAndIsNoSlowerThanThatAsksFor) {
  const auto approach = PlanApproach(model(), plan(), Off(0.3));
  ASSERT_TRUE(approach) << approach.failure().message;
  double most = 0.0;
  for (const VectorX& v : approach->plan.whole_body.v) {
    for (int d = 0; d < n(); ++d)
      most = std::max(most, std::abs(v[6 + d]) / std::min(0.5, 0.1 * model().dof_velocity_limit(d)));
  }
  EXPECT_LE(most, 1.0);
  EXPECT_TRUE(most > 0.97 || std::abs(approach->plan.duration_s() - 1.0) < 0.02) << most;
}

TEST_P(Approaching, LimitsOfAccelerationAndJerkSlowItDown) {
  const StartPosture start = Off(0.3);
  const double fast_s = PlanApproach(model(), plan(), start)->plan.duration_s();
  RobotModel gentle = model();
  for (Motor& motor : gentle.motors) motor.acceleration_limit = 0.2;
  const auto by_acceleration = PlanApproach(gentle, plan(), start);
  ASSERT_TRUE(by_acceleration) << by_acceleration.failure().message;
  EXPECT_GT(by_acceleration->plan.duration_s(), 1.5 * fast_s);
  EXPECT_TRUE(Audit(gentle, by_acceleration->plan, {})->pass());
  for (Motor& motor : gentle.motors) motor = Motor();
  for (Motor& motor : gentle.motors) motor.jerk_limit = 0.5;
  const auto by_jerk = PlanApproach(gentle, plan(), start);
  ASSERT_TRUE(by_jerk) << by_jerk.failure().message;
  EXPECT_GT(by_jerk->plan.duration_s(), 1.2 * fast_s);
  EXPECT_TRUE(Audit(gentle, by_jerk->plan, {})->pass());
}

TEST_P(Approaching, HangsTiltedAsMeasuredWithTheHeadingOfThePlan) {
  StartPosture start = Off(0.1);
  start.R_WB = Quaternion(Eigen::AngleAxisd(2.0, Vector3::UnitZ()) * Eigen::AngleAxisd(0.3, Vector3::UnitX()));
  const auto approach = PlanApproach(model(), plan(), start);
  ASSERT_TRUE(approach) << approach.failure().message;
  const Matrix3 R_WB = BaseRotation(approach->plan.whole_body.q.front());
  EXPECT_NEAR(std::acos(R_WB(2, 2)), 0.3, 1e-9);
  EXPECT_NEAR(approach->plan.goal.yaw_rad, plan().parts.front().goal.yaw_rad, 1e-6);
}

TEST_P(Approaching, AMotorTooWeakToHoldIsNamed) {
  RobotModel weak = model();
  const int knee = weak.joints[static_cast<std::size_t>(weak.legs[0].knee_joint)].dof;
  weak.joints[static_cast<std::size_t>(weak.legs[0].knee_joint)].effort_limit = 1e-4;
  const auto approach = PlanApproach(weak, plan(), Off(0.3));
  ASSERT_FALSE(approach);
  EXPECT_EQ(approach.failure().kind, FailureKind::kInfeasible);
  EXPECT_NE(approach.failure().message.find("'" + weak.dof_names[static_cast<std::size_t>(knee)] + "' needs"),
            std::string::npos)
      << approach.failure().message;
}

TEST_P(Approaching, KeepsTheReserveThatThePlanIsHeldAgainst) {
  const StartPosture start = Off(0.3);
  AuditOptions reserve;
  reserve.derate_speed = 0.02;
  const auto slow = PlanApproach(model(), plan(), start, {}, reserve);
  ASSERT_TRUE(slow) << slow.failure().message;
  for (const VectorX& v : slow->plan.whole_body.v) {
    for (int d = 0; d < n(); ++d) EXPECT_LE(std::abs(v[6 + d]), 0.02 * model().dof_velocity_limit(d) * (1.0 + 1e-9));
  }
  EXPECT_FALSE(Audit(model(), PlanApproach(model(), plan(), start)->plan, reserve)->pass()) << "without being told it";
  EXPECT_TRUE(Audit(model(), slow->plan, reserve)->pass());
  const OptionTexts& shaped = slow->plan.provenance.options;
  EXPECT_EQ(std::count(shaped.begin(), shaped.end(), std::pair<std::string, std::string>("audit.derate_speed", "0.02")),
            1);
  // With hardly any torque left, a motor cannot even hold its leg up; the message says so.
  reserve.derate_torque = 0.01;
  const auto weak = PlanApproach(model(), plan(), start, {}, reserve);
  ASSERT_FALSE(weak);
  EXPECT_EQ(weak.failure().code, FailureCode::kTorque);
  // Faults that no approach motion can correct are found by the audit.
  RobotModel warm = model();
  for (Motor& motor : warm.motors) motor.continuous_effort = 1.0;
  reserve = {};
  reserve.derate_continuous = 0.01;
  const auto hot = PlanApproach(warm, plan(), start, {}, reserve);
  ASSERT_FALSE(hot);
  EXPECT_EQ(hot.failure().code, FailureCode::kContinuousTorque);
}

TEST_P(Approaching, OneThatTakesTooLongIsRefusedBeforeItsRowsAreMade) {
  RobotModel endless = model();
  MotionPlan far = plan();
  const int d = endless.joints[static_cast<std::size_t>(endless.legs[0].knee_joint)].dof;
  for (Joint& joint : endless.joints) {
    joint.lower = -std::numeric_limits<double>::infinity();
    joint.upper = std::numeric_limits<double>::infinity();
  }
  for (const double angle : {500.0, 1e9, 1e300}) {
    far.whole_body.q.front()[7 + d] = angle;
    const auto refused = PlanApproach(endless, far, StartPosture{First(), {}});
    ASSERT_FALSE(refused) << angle;
    EXPECT_EQ(refused.failure().code, FailureCode::kTooLong);
    EXPECT_NE(refused.failure().message.find("at most 600 s"), std::string::npos) << refused.failure().message;
    EXPECT_FALSE(refused.failure().suggestions.empty());
  }
  MotionPlan fine = plan();
  fine.whole_body.step_s = 1e-9;
  const auto rows = PlanApproach(model(), fine, Off(0.3));
  ASSERT_FALSE(rows);
  EXPECT_NE(rows.failure().message.find("at most 120000 rows"), std::string::npos) << rows.failure().message;
}

TEST_P(Approaching, PositionsThatCannotBeAreRefused) {
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity(), -1e6}) {
    StartPosture start = Off(0.0);
    start.joints[1] = wrong;
    const auto refused = PlanApproach(model(), plan(), start);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.failure().code, FailureCode::kMisfit);
    EXPECT_NE(refused.failure().message.find("'" + model().dof_names[1] + "'"), std::string::npos);
  }
}

TEST_P(Approaching, WhatDoesNotFitIsRefused) {
  StartPosture start = Off(0.0);
  start.joints.conservativeResize(n() - 1);
  const auto approach = PlanApproach(model(), plan(), start);
  ASSERT_FALSE(approach);
  EXPECT_EQ(approach.failure().code, FailureCode::kMisfit);
  ApproachOptions options;
  options.speed_share = 0.0;
  EXPECT_THROW((void)PlanApproach(model(), plan(), Off(0.0), options), InvalidArgument);
}

TEST(ApproachPastABall, IsByTheStandingPostureOrRefusedNamingIt) {
  const GoodPlan& a1 = GoodPlanOf("a1");
  const VectorX first = a1.plan.whole_body.q.front();
  const int n = a1.model.num_dofs();
  const int knee = a1.model.joints[static_cast<std::size_t>(a1.model.legs[0].knee_joint)].dof;
  const int thigh = knee - 1;
  // The foot moves along an arc with a ball in the middle of it.
  StartPosture start{first.tail(n), {}};
  start.joints[thigh] += 1.2;
  VectorX middle = first;
  middle[7 + thigh] += 0.6;
  DynamicsScratch scratch(a1.model);
  ForwardKinematics(a1.model, middle, scratch);
  const Foot& foot = a1.model.feet[0];
  const Vector3 p_WF = FramePose(scratch, foot.body, foot.X_BF).translation();
  RobotModel blocked = a1.model;
  Shape ball;
  ball.type = ShapeType::kSphere;
  ball.link = "ball";
  ball.body = 0;
  ball.X_BS.translation() = scratch.R_WB[0].transpose() * (p_WF - scratch.p_WB[0]);
  ball.size.x() = 0.02;
  blocked.collision_shapes.push_back(ball);
  ASSERT_TRUE(PlanApproach(a1.model, a1.plan, start)) << "free without the ball";
  const auto refused = PlanApproach(blocked, a1.plan, start);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.failure().code, FailureCode::kSelfCollision);
  EXPECT_NE(refused.failure().message.find("'ball'"), std::string::npos) << refused.failure().message;
  EXPECT_FALSE(refused.failure().suggestions.empty());
  // Via a standing posture with the leg beside the ball there is a free motion.
  blocked.standing_joints[thigh - 1] += a1.model.legs[0].mirror >= 0 ? 0.5 : -0.5;
  auto by_standing = PlanApproach(blocked, a1.plan, start);
  if (!by_standing) {
    blocked.standing_joints[thigh - 1] -= 1.0;
    by_standing = PlanApproach(blocked, a1.plan, start);
  }
  ASSERT_TRUE(by_standing) << by_standing.failure().message;
  EXPECT_TRUE(by_standing->via_standing);
  EXPECT_TRUE(Audit(blocked, by_standing->plan, {})->pass());
}

}  // namespace
}  // namespace gaitwright
