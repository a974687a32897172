// SPDX-License-Identifier: BSD-3-Clause
// A biped with ankles whose pitch and roll are moved by two motors together.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/model/actuator.h"
#include "kinematics/model/load_robot.h"
#include "planning/audit/audit.h"
#include "tests/unusual_robots.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

/// Transmissions of both ankles, with motors of these ratios, torque and speed.
std::string Ankles(const std::string& first, const std::string& second, double effort, double speed) {
  std::string yaml = "transmissions:\n";
  for (const std::string leg : {"l", "r"}) {
    yaml += fmt::format(
        "  - name: {0}_ankle\n    joints: [{0}5_joint, {0}_foot_joint]\n    motors:\n"
        "      - {{name: {0}_front, ratios: [{1}], effort_nm: {3}, velocity_rad_s: {4}}}\n"
        "      - {{name: {0}_rear, ratios: [{2}], effort_nm: {3}, velocity_rad_s: {4}}}\n",
        leg, first, second, effort, speed);
  }
  return yaml;
}

RobotModel BipedWith(const std::string& yaml) {
  Result<RobotModel> model = LoadRobotFromText(unusual::SoledBiped(true, false), yaml);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  return std::move(model).value();
}

Result<PlannedWalk> WalkOf(const RobotModel& model) {
  WalkRequest request;
  request.command.distance_m = 0.3;
  return PlanWalk(model, request);
}

TEST(Transmissions, IdentityIsWhatBoxesAre) {
  const RobotModel plain = BipedWith(""), same = BipedWith(Ankles("1, 0", "0, 1", 90.0, 20.0));
  const Result<PlannedWalk> one = WalkOf(plain), other = WalkOf(same);
  ASSERT_TRUE(one.ok() && other.ok());
  const WholeBodyTrajectory &a = one->motion.plan.whole_body, &b = other->motion.plan.whole_body;
  ASSERT_EQ(a.q.size(), b.q.size());
  for (std::size_t k = 0; k < a.q.size(); ++k) {
    ASSERT_TRUE(a.q[k].isApprox(b.q[k], 1e-9)) << k;
    ASSERT_TRUE(a.tau[k].isApprox(b.tau[k], 1e-9)) << k;
  }
  EXPECT_TRUE(one->audit.pass());
  EXPECT_TRUE(other->audit.pass());
  const Result<PlayedWalk> played = PlayWalk(plain, one->motion.plan, PlayRequest{});
  const Result<PlayedWalk> again = PlayWalk(same, other->motion.plan, PlayRequest{});
  ASSERT_TRUE(played.ok() && again.ok());
  ASSERT_EQ(played->log.samples.size(), again->log.samples.size());
  for (std::size_t k = 0; k < played->log.samples.size(); ++k) {
    const LogSample &x = played->log.samples[k], &y = again->log.samples[k];
    ASSERT_TRUE(x.q.isApprox(y.q, 1e-9)) << x.time_s;
    ASSERT_LT((x.tau - y.tau).lpNorm<Eigen::Infinity>(), 1e-5) << x.time_s;
  }
  EXPECT_NEAR(played->report.score, again->report.score, 1e-6);
}

TEST(Transmissions, ABipedWalksWithADifferentialAnkle) {
  const RobotModel model = BipedWith(Ankles("1.5, 1", "1.5, -1", 40.0, 30.0));
  const Result<PlannedWalk> planned = WalkOf(model);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  const Result<PlayedWalk> played = PlayWalk(model, planned->motion.plan, PlayRequest{});
  ASSERT_TRUE(played.ok()) << played.failure().message;
  EXPECT_TRUE(played->report.pass) << played->report.reason;
  const Actuator front = ActuatorOf(model, model.DofIndex("l5_joint"));
  ASSERT_EQ(front.name, "l_front");
  for (const LogSample& sample : played->log.samples)
    ASSERT_LE(std::abs(front.Effort(sample.tau)), sample.tau_peak[model.DofIndex("l5_joint")] + 1e-9);
}

TEST(Transmissions, TheAuditFindsAMotorPastItsLimitWhereBoxesWouldPass) {
  const RobotModel plain = BipedWith("");
  const Result<PlannedWalk> planned = WalkOf(plain);
  ASSERT_TRUE(planned.ok());
  const MotionPlan& plan = planned->motion.plan;
  const auto largest = [&](double of_pitch, double of_roll, const std::string& leg) {
    const int pitch = plain.DofIndex(leg + "5_joint"), roll = plain.DofIndex(leg + "_foot_joint");
    double most = 0.0;
    for (const VectorX& tau : plan.whole_body.tau)
      most = std::max(most, std::abs(of_pitch * tau[pitch] + of_roll * tau[roll]));
    return most;
  };
  double joint = 0.0, motor = 0.0;
  for (const std::string leg : {"l", "r"}) {
    joint = std::max({joint, largest(1.0, 0.0, leg), largest(0.0, 1.0, leg)});
    motor = std::max({motor, largest(0.5, 0.5, leg), largest(0.5, -0.5, leg)});
  }
  ASSERT_GT(motor, 1.02 * 0.5 * joint) << "the largest torques of pitch and roll come together";
  const double effort = 0.5 * (motor + 0.5 * joint);
  const RobotModel driven = BipedWith(Ankles("1, 1", "1, -1", effort, 100.0));
  for (const std::string leg : {"l", "r"}) {
    EXPECT_GT(driven.dof_effort_limit(driven.DofIndex(leg + "5_joint")), joint) << "boxes would pass";
    EXPECT_GT(driven.dof_effort_limit(driven.DofIndex(leg + "_foot_joint")), joint);
  }
  const Result<AuditReport> audit = Audit(driven, plan, {});
  ASSERT_TRUE(audit.ok());
  ASSERT_FALSE(audit->violations.empty());
  for (const Violation& violation : audit->violations) {
    EXPECT_EQ(violation.law, Law::kJointTorque);
    EXPECT_TRUE(violation.where.ends_with("_front") || violation.where.ends_with("_rear")) << violation.where;
    EXPECT_NEAR(violation.limit, effort, 1e-9);
    EXPECT_GT(violation.value, effort);
  }
  const Result<AuditReport> slow = Audit(BipedWith(Ankles("1, 1", "1, -1", 500.0, 0.01)), plan, {});
  ASSERT_TRUE(slow.ok());
  ASSERT_FALSE(slow->violations.empty());
  EXPECT_EQ(slow->violations[0].law, Law::kJointVelocity);
  EXPECT_TRUE(slow->violations[0].where.ends_with("_front") || slow->violations[0].where.ends_with("_rear"));
}

/// Largest share of a motor's speed limit in a plan.
double SpeedUseOf(const RobotModel& model, const MotionPlan& plan) {
  double most = 0.0;
  for (const VectorX& v : plan.whole_body.v)
    most = std::max(most, LargestSpeedUse(model, v.tail(model.num_dofs())).share);
  return most;
}

TEST(Transmissions, APlanKeepsTheLimitsOfTheMotors) {
  const std::string slow = Ankles("1, 1", "1, -1", 90.0, 1.5);
  const RobotModel model = BipedWith(slow);
  const Result<PlannedWalk> plain = WalkOf(BipedWith("")), planned = WalkOf(model);
  ASSERT_TRUE(plain.ok());
  EXPECT_GT(SpeedUseOf(model, plain->motion.plan), 1.05) << "motors without limits would be faster";
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_LE(SpeedUseOf(model, planned->motion.plan), 1.0 + 1e-6);
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
}

TEST(Transmissions, InPlaybackEachMotorGivesItsLimitAtMost) {
  RobotModel weak = BipedWith(Ankles("1, 1", "1, -1", 90.0, 100.0));
  const Result<PlannedWalk> planned = WalkOf(weak);
  ASSERT_TRUE(planned.ok());
  const int front = weak.DofIndex("l5_joint"), rear = weak.DofIndex("l_foot_joint");
  double most = 0.0;
  for (const VectorX& tau : planned->motion.plan.whole_body.tau) {
    for (const int motor : {front, rear}) most = std::max(most, std::abs(ActuatorOf(weak, motor).Effort(tau)));
  }
  const double effort = 0.7 * most;
  for (Transmission& ankle : weak.transmissions) {
    for (TransmissionMotor& motor : ankle.motors) motor.effort_limit = effort;
  }
  const Result<PlayedWalk> played = PlayWalk(weak, planned->motion.plan, PlayRequest{});
  ASSERT_TRUE(played.ok()) << played.failure().message;
  EXPECT_GT(std::max(played->log.saturated_s[front], played->log.saturated_s[rear]), 0.0);
  double largest_of_a_joint = 0.0;
  for (const LogSample& sample : played->log.samples) {
    for (const int motor : {front, rear}) {
      ASSERT_LE(std::abs(ActuatorOf(weak, motor).Effort(sample.tau)), effort * (1.0 + 1e-9));
      ASSERT_LE(sample.tau_peak[motor], effort * (1.0 + 1e-9));
      largest_of_a_joint = std::max(largest_of_a_joint, std::abs(sample.tau[motor]));
    }
  }
  EXPECT_GT(largest_of_a_joint, 1.2 * effort) << "a joint has what both motors give it";
}

}  // namespace
}  // namespace gaitwright
