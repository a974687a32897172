// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/gait_timing.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "optimisation/pipeline/compare_motions.h"
#include "planning/audit/audit.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {
namespace {

/// A bound of two cycles, with the gait's times and with optimised times; made once.
struct TimedBound {
  RobotModel model = *LoadNamedRobot("a1");
  std::vector<WalkPart> parts;
  MotionOptions options;
  Result<TimedGaits> timed = Failure{};
  Result<PlannedMotion> fixed = Failure{}, optimised = Failure{};

  TimedBound() {
    WalkCommand command;
    command.speed_m_s = 0.5;
    command.distance_m = 0.2;
    parts = {{*FindGait(model, "bound", 0.5, {}), command}};
    fixed = PlanMotion(model, FlatTerrain(), parts, options);
    options.timing = "optimised";
    timed = OptimiseGaits(model, FlatTerrain(), parts, options);
    optimised = PlanMotion(model, FlatTerrain(), parts, options);
  }
};

const TimedBound& Both() {
  static const TimedBound bounds;
  return bounds;
}

TEST(OptimiseGaits, CostsLessInTheSameCycle) {
  const TimedBound& both = Both();
  ASSERT_TRUE(both.timed.ok()) << both.timed.failure().message;
  EXPECT_LT(both.timed->cost, 0.97 * both.timed->cost_before);
  EXPECT_GT(both.timed->solves, 0);
  const Gait &from = both.parts.front().gait, &to = both.timed->parts.front().gait;
  EXPECT_NEAR(to.cycle_s, from.cycle_s, 1e-9);
  EXPECT_NE(to.duty_factor, from.duty_factor);
  for (std::size_t i = 0; i < to.phase.size(); ++i) {
    EXPECT_GE(1.0 - to.duty_factor[i], 0.7 * (1.0 - from.duty_factor[i]) - 1e-9) << "swings are not hurried";
    EXPECT_GE(to.phase[i], 0.0);
    EXPECT_LT(to.phase[i], 1.0);
  }
  EXPECT_EQ(both.timed->parts.front().command, both.parts.front().command);
}

TEST(PlanAtBestTimes, TakesLessTorqueInTheSameTimeAndPassesItsAudit) {
  const TimedBound& both = Both();
  ASSERT_TRUE(both.fixed.ok() && both.optimised.ok());
  const MotionPlan &fixed = both.fixed->plan, &plan = both.optimised->plan;
  const TorqueUse before = TorqueUseOf(both.model, fixed.whole_body), after = TorqueUseOf(both.model, plan.whole_body);
  EXPECT_LT(after.rms, before.rms);
  EXPECT_LT(after.peak, before.peak);
  EXPECT_TRUE(Audit(both.model, plan, {})->pass());
  EXPECT_NO_THROW(CheckSchedule(plan.schedule, 4));
  EXPECT_NEAR(plan.duration_s(), fixed.duration_s(), 0.1);
  ASSERT_EQ(plan.adjustments.size(), 1U);
  EXPECT_EQ(plan.adjustments.front().what, "gait.duty_factor");
  EXPECT_EQ(plan.adjustments.front().why, FailureCode::kTorque);
  EXPECT_NEAR(plan.adjustments.front().asked, 0.375, 1e-9);
  EXPECT_GT(plan.adjustments.front().given, 0.38);
  EXPECT_EQ(plan.parts.front().gait.name, "bound");
  EXPECT_TRUE(fixed.adjustments.empty());
}

TEST(PlanAtBestTimes, LeavesGaitsOnTheGroundAsTheyAre) {
  const RobotModel& model = Both().model;
  WalkCommand command;
  command.speed_m_s = 0.2;
  command.distance_m = 0.1;
  const Gait trot = *FindGait(model, "trot", 0.2, {});
  MotionOptions options;
  options.timing = "optimised";
  const Result<PlannedMotion> planned = PlanMotion(model, FlatTerrain(), trot, command, options);
  ASSERT_TRUE(planned.ok());
  EXPECT_TRUE(planned->plan.adjustments.empty());
  EXPECT_EQ(planned->plan.parts.front().gait, trot);
  const Result<TimedGaits> timed = OptimiseGaits(model, FlatTerrain(), {{trot, command}}, options);
  ASSERT_FALSE(timed.ok());
  EXPECT_EQ(timed.failure().code, FailureCode::kNoTiming);
}

}  // namespace
}  // namespace gaitwright
