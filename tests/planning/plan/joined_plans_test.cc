// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/joined_plans.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/carried_plan.h"
#include "planning/plan/steady_stretch.h"
#include "tests/named_robot.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

/// A trot of several cycles, each a whole number of the plan's steps.
const MotionPlan& Trot() {
  static const MotionPlan plan = [] {
    WalkCommand command;
    command.extent = WalkCommand::Extent::kDuration;
    command.duration_s = 5.0;
    command.speed_m_s = 0.4;
    return PlanOf(NamedRobot("a1"), "trot", command, {.cycle_step_s = 0.005});
  }();
  return plan;
}

SteadyStretch Steady() { return SteadyStretchOf(Trot(), 0).value(); }

std::string Broken(const MotionPlan& plan) { return AuditText(Audit(NamedRobot("a1"), plan, {}).value()); }

bool Passes(const MotionPlan& plan) { return Audit(NamedRobot("a1"), plan, {})->pass(); }

TEST(JoinedPlans, OneThatIsCutInTwoAndJoinedIsAsItWas) {
  const double at_s = Steady().start_s;
  const MotionPlan joined = JoinedPlans(Trot(), at_s, PlanFrom(Trot(), at_s), at_s).value();
  ASSERT_EQ(joined.whole_body.size(), Trot().whole_body.size());
  for (std::size_t k = 0; k < joined.whole_body.q.size(); ++k)
    ASSERT_LT((joined.whole_body.q[k] - Trot().whole_body.q[k]).norm(), 1e-9) << k;
  ASSERT_EQ(joined.schedule.phases.size(), Trot().schedule.phases.size());
  EXPECT_EQ(joined.footsteps.footholds.size(), Trot().footsteps.footholds.size());
  EXPECT_EQ(joined.swings.size(), Trot().swings.size());
  EXPECT_EQ(joined.parts.size(), Trot().parts.size()) << "what was one is one again";
  EXPECT_TRUE(Passes(joined)) << Broken(joined);
}

TEST(JoinedPlans, LeaveOutOrRepeatWholeCyclesAndKeepAllLaws) {
  const SteadyStretch steady = Steady();
  ASSERT_GE(steady.cycles, 2);
  const MotionPlan shorter = JoinedPlans(Trot(), steady.start_s, Trot(), steady.start_s + steady.cycle_s).value();
  const MotionPlan longer = JoinedPlans(Trot(), steady.start_s + steady.cycle_s, Trot(), steady.start_s).value();
  EXPECT_NEAR(shorter.duration_s(), Trot().duration_s() - steady.cycle_s, 1e-9);
  EXPECT_NEAR(longer.duration_s(), Trot().duration_s() + steady.cycle_s, 1e-9);
  EXPECT_NEAR(longer.goal.x_m - shorter.goal.x_m, 2.0 * 0.4 * steady.cycle_s, 0.01);
  EXPECT_TRUE(Passes(shorter)) << Broken(shorter);
  EXPECT_TRUE(Passes(longer)) << Broken(longer);
}

TEST(JoinedPlans, GoOnWhereTheFirstOneIs) {
  const SteadyStretch steady = Steady();
  const MotionPlan elsewhere = CarriedPlan(PoseOf({5.0, 4.0, 1.0}), 100.0, Trot());
  const MotionPlan joined = JoinedPlans(Trot(), steady.end_s(), elsewhere, steady.start_s + 100.0).value();
  EXPECT_NEAR(YawOf(BaseRotation(joined.whole_body.q.back())), YawOf(BaseRotation(Trot().whole_body.q.back())), 1e-3);
  EXPECT_TRUE(Passes(joined)) << Broken(joined);
}

/// The largest change of a position over a step that the rates of the two rows do not explain.
double LargestJump(const MotionPlan& plan) {
  const WholeBodyTrajectory& w = plan.whole_body;
  double largest = 0.0;
  for (std::size_t k = 1; k < w.q.size(); ++k) {
    const VectorX change = w.q[k].tail(12) - w.q[k - 1].tail(12);
    const VectorX explained = 0.5 * w.step_s * (w.v[k].tail(12) + w.v[k - 1].tail(12));
    largest = std::max(largest, (change - explained).cwiseAbs().maxCoeff());
  }
  return largest;
}

TEST(JoinedPlans, BendWhatDiffersAwayBeforeTheSeam) {
  const SteadyStretch steady = Steady();
  MotionPlan other = Trot();
  for (VectorX& q : other.whole_body.q) q[7] += 0.02;  // a hip with a constant offset
  const Seam seam = SeamBetween(Trot(), steady.start_s, other, steady.start_s);
  EXPECT_NEAR(seam.joints, 0.02, 1e-12);
  const MotionPlan joined = JoinedPlans(Trot(), steady.end_s(), other, steady.end_s()).value();
  EXPECT_LT(LargestJump(joined), LargestJump(Trot()) + 1e-4);
  const auto row =
      static_cast<std::size_t>(std::lround((steady.end_s() - joined.whole_body.start_s) / joined.whole_body.step_s));
  EXPECT_NEAR(joined.whole_body.q[row][7], other.whole_body.q[row][7], 1e-9);
  EXPECT_NEAR(joined.whole_body.q[row - 81][7], Trot().whole_body.q[row - 81][7], 1e-12) << "more than 0.4 s before";
}

TEST(JoinedPlans, HaveAPendulumAsHighAsTheTwoOnAverage) {
  MotionPlan high = Trot();
  const double height_m = 9.81 / std::pow(Trot().centroidal.omega_rad_s, 2);
  high.centroidal.omega_rad_s = std::sqrt(9.81 / (2.0 * height_m));
  const SteadyStretch steady = Steady();
  const double before_s = steady.start_s - Trot().whole_body.start_s,
               after_s = Trot().whole_body.end_s() - steady.start_s;
  const MotionPlan joined = JoinedPlans(Trot(), steady.start_s, high, steady.start_s).value();
  const double mean_m = height_m * (before_s + 2.0 * after_s) / (before_s + after_s);
  EXPECT_NEAR(joined.centroidal.omega_rad_s, std::sqrt(9.81 / mean_m), 1e-9);
}

TEST(JoinedPlans, ThatDoNotFitAreRefused) {
  const SteadyStretch steady = Steady();
  const auto refused = [](const MotionPlan& before, double before_s, const MotionPlan& after, double after_s) {
    const Result<MotionPlan> joined = JoinedPlans(before, before_s, after, after_s);
    return joined ? std::string() : FailureCodeName(joined.failure().code);
  };
  const double step_s = Trot().whole_body.step_s, quarter_s = std::round(0.25 * steady.cycle_s / step_s) * step_s;
  EXPECT_EQ(refused(Trot(), steady.start_s, Trot(), steady.start_s + quarter_s), "misfit") << "the other feet stand";
  MotionPlan other = Trot();
  other.robot_hash = "another";
  EXPECT_EQ(refused(Trot(), steady.start_s, other, steady.start_s), "misfit");
  other = Trot();
  other.whole_body.step_s *= 2.0;
  EXPECT_EQ(refused(Trot(), steady.start_s, other, steady.start_s), "misfit");
  EXPECT_THROW(JoinedPlans(Trot(), steady.start_s + 0.001, Trot(), steady.start_s).ok(), InvalidArgument);
  EXPECT_THROW(PlanFrom(Trot(), Trot().whole_body.end_s() + 1.0), InvalidArgument);
}

TEST(SeamBetween, IsTheSameWhereverThePlansAre) {
  const double at_s = Steady().start_s;
  const MotionPlan there = CarriedPlan(PoseOf({2.0, -1.0, 0.8}), 7.0, Trot());
  const Seam none = SeamBetween(Trot(), at_s, there, at_s + 7.0);
  for (const double apart : {none.height_m, none.tilt_rad, none.joints, none.base_rates, none.joint_rates})
    EXPECT_LT(apart, 1e-7);
  const Seam some = SeamBetween(Trot(), at_s, Trot(), at_s + 0.1),
             same = SeamBetween(there, at_s + 7.0, Trot(), at_s + 0.1);
  EXPECT_GT(some.joint_rates, 0.1);
  EXPECT_NEAR(some.joint_rates, same.joint_rates, 1e-9);
  EXPECT_NEAR(some.height_m, same.height_m, 1e-9);
}

TEST(PlanFrom, IsTheRestOfAPlan) {
  const double at_s = Steady().start_s;
  const MotionPlan rest = PlanFrom(Trot(), at_s);
  EXPECT_NEAR(rest.whole_body.start_s, at_s, 1e-9);
  EXPECT_EQ(rest.whole_body.q.back(), Trot().whole_body.q.back());
  for (const SwingTrajectory& swing : rest.swings) EXPECT_GT(swing.end_s, at_s);
  for (const Foothold& foothold : rest.footsteps.footholds) EXPECT_GT(foothold.liftoff_s, at_s);
  EXPECT_NEAR(rest.schedule.start_s(), at_s, 1e-9);
}

}  // namespace
}  // namespace gaitwright
