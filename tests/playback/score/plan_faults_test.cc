// SPDX-License-Identifier: BSD-3-Clause
// Faults of the plan itself in the reason of a failed playback.
#include <gtest/gtest.h>

#include "tests/playback/played.h"

namespace gaitwright {
namespace {

using synthetic::PerfectLog;
using synthetic::Robot;
using synthetic::Says;
using synthetic::StandingPlan;
using synthetic::SteppingPlan;

/// Reason for the plan's failure if the trunk touches the ground at the end.
std::string ReasonOf(const RobotModel& model, const MotionPlan& plan) {
  PlaybackLog log = PerfectLog(model, plan);
  log.body_contacts = {{plan.whole_body.end_s(), "trunk"}};
  return Score(model, plan, log).reason;
}

/// Moves the ZMP that follows from the accelerations.
void ShiftZmp(double y_m, MotionPlan& plan) {
  for (VectorX& a : plan.whole_body.a) a[1] -= y_m * kGravity / synthetic::kHeight;
}

TEST(PlanFaults, ASoundPlanIsNotBlamed) {
  for (const FootType type : {FootType::kPoint, FootType::kSphere}) {
    const RobotModel model = Robot(4, type);
    for (const MotionPlan& plan : {SteppingPlan(model), StandingPlan(model, 1.0)}) {
      const std::string reason = ReasonOf(model, plan);
      EXPECT_TRUE(Says(reason, "'trunk'")) << reason;
      EXPECT_FALSE(Says(reason, "the plan")) << reason;
    }
  }
}

TEST(PlanFaults, AZmpOffTheLineOfTwoPointFeetIsBlamed) {
  const RobotModel model = Robot(4, FootType::kPoint);
  MotionPlan plan = SteppingPlan(model);
  ShiftZmp(0.02, plan);
  const std::string reason = ReasonOf(model, plan);
  EXPECT_TRUE(Says(reason, "the plan itself has its ZMP outside the support of 'front_right', 'rear_left', by up to"))
      << reason;
}

TEST(PlanFaults, AZmpOutsideIsNotBlamedTwice) {
  const RobotModel model = Robot(2, FootType::kSole);
  MotionPlan plan = StandingPlan(model, 1.0, {0.1, 0.0});  // 20 mm in front of the toes
  for (VectorX& tau : plan.whole_body.tau) tau *= 1.5;
  const std::string reason = ReasonOf(model, plan);
  EXPECT_TRUE(Says(reason, "the plan itself has its ZMP outside")) << reason;
  EXPECT_FALSE(Says(reason, "do not match its motion")) << reason;
}

TEST(PlanFaults, ForcesThatTheGroundCannotGiveAreBlamed) {
  const RobotModel model = Robot(2, FootType::kSole);
  MotionPlan plan = StandingPlan(model, 1.0);
  const double normal = plan.whole_body.wrenches[0][0].force_W.z();
  for (auto& wrenches : plan.whole_body.wrenches) wrenches[1].force_W.x() = normal;
  const std::string reason = ReasonOf(model, plan);
  EXPECT_TRUE(
      Says(reason, "the plan itself needs a tangential force of up to 49.1 N at 'right', but friction allows 39.2"))
      << reason;
}

TEST(PlanFaults, TorquesOfAnotherMotionAreBlamed) {
  const RobotModel model = Robot(2, FootType::kSole);
  MotionPlan plan = StandingPlan(model, 1.0);
  for (VectorX& tau : plan.whole_body.tau) tau *= 1.5;
  const std::string reason = ReasonOf(model, plan);
  EXPECT_TRUE(Says(reason, "the plan's torques do not match its motion: 'left_z' has -73.58 N, needed -49.05 N"))
      << reason;
}

TEST(PlanFaults, ForcesOfAnotherMassAreBlamed) {
  const RobotModel model = Robot(2, FootType::kSole);
  MotionPlan plan = StandingPlan(model, 1.0);
  for (auto& wrenches : plan.whole_body.wrenches) {
    for (ContactWrench& wrench : wrenches) wrench.force_W *= 1.5;
  }
  const std::string reason = ReasonOf(model, plan);
  EXPECT_TRUE(Says(reason, "the plan's contact forces do not match its motion: 147 N in all, needed 98 N")) << reason;
}

TEST(PlanFaults, APlanWithoutForcesIsNotBlamedForThem) {
  const RobotModel model = Robot(2, FootType::kSole);
  MotionPlan plan = StandingPlan(model, 1.0);
  for (VectorX& tau : plan.whole_body.tau) tau.setZero();
  for (auto& wrenches : plan.whole_body.wrenches) wrenches.assign(wrenches.size(), ContactWrench{});
  EXPECT_FALSE(Says(ReasonOf(model, plan), "the plan")) << ReasonOf(model, plan);
}

TEST(PlanFaults, AFigureThatReadsLikeItsLimitIsNotRepeated) {
  const RobotModel model = Robot(2, FootType::kSole);
  const MotionPlan plan = SteppingPlan(model);
  PlaybackLog log = PerfectLog(model, plan);
  log.stances[0].penetration_m = 0.00201;
  const std::string reason = Score(model, plan, log).reason;
  EXPECT_TRUE(Says(reason, "penetration_max_m is just over its limit 2.0 mm (by 1e-05 m)")) << reason;
}

}  // namespace
}  // namespace gaitwright
