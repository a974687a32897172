// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/steady_stretch.h"

#include <gtest/gtest.h>

#include <bit>

#include "kinematics/model/load_robot.h"
#include "tests/named_robot.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

MotionPlan Trot(const GaitOptions& options) {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kDuration;
  command.duration_s = 5.0;
  command.speed_m_s = 0.4;
  return PlanOf(NamedRobot("a1"), "trot", command, options);
}

const MotionPlan& Even() {
  static const MotionPlan plan = Trot({.cycle_step_s = 0.005});
  return plan;
}

TEST(SteadyStretch, RepeatsItselfAfterEachCycle) {
  const auto stretch = SteadyStretchOf(Even(), 0);
  ASSERT_TRUE(stretch);
  EXPECT_GE(stretch->cycles, 3);
  EXPECT_NEAR(stretch->cycle_s, Even().parts[0].gait.cycle_s, 1e-9);
  for (int cycle = 0; cycle < stretch->cycles; ++cycle) {
    const double at_s = stretch->start_s + cycle * stretch->cycle_s;
    EXPECT_TRUE(Within(SeamBetween(Even(), at_s, Even(), at_s + stretch->cycle_s), kSteady)) << cycle;
    EXPECT_TRUE(SameStance(Even(), at_s, Even(), at_s + stretch->cycle_s));
  }
}

TEST(SteadyStretch, BeginsWhereAsManyFeetStandAsEver) {
  const SteadyStretch stretch = SteadyStretchOf(Even(), 0).value();
  int most = 0;
  for (const ContactPhase& phase : Even().schedule.phases) {
    if (phase.start_s > stretch.start_s && phase.start_s < stretch.end_s())
      most = std::max(most, std::popcount(phase.stance));
  }
  const int at = PhaseAt(Even().schedule, stretch.start_s);
  EXPECT_EQ(std::popcount(Even().schedule.phases[static_cast<std::size_t>(at)].stance), most);
}

TEST(SteadyStretch, IsOnlyWhereThePlansStepsFitTheCycle) {
  EXPECT_FALSE(SteadyStretchOf(Trot({.cycle_s = 0.4321}), 0));
  EXPECT_FALSE(SteadyStretchOf(Even(), 0, {})) << "nothing repeats itself to the last digit";
  EXPECT_THROW(SteadyStretchOf(Even(), 1).has_value(), InvalidArgument);
}

/// Measurements of playbacks need no rows that are the same.
TEST(NearlySteadyStretch, AlsoHasCyclesThatAreNoMultipleOfThePlansSteps) {
  const MotionPlan uneven = Trot({.cycle_s = 0.4321});
  const auto nearly = NearlySteadyStretchOf(uneven, 0);
  ASSERT_TRUE(nearly);
  EXPECT_GE(nearly->cycles, 5);
  EXPECT_NEAR(nearly->cycle_s, 0.43, 1e-9);
  EXPECT_GE(NearlySteadyStretchOf(Even(), 0).value().cycles, SteadyStretchOf(Even(), 0).value().cycles);
  EXPECT_THROW(NearlySteadyStretchOf(Even(), 1).has_value(), InvalidArgument);
}

TEST(LastLikeStart, IsWholeCyclesLaterAndNoEarlierThanTheStretchsEnd) {
  const SteadyStretch stretch = SteadyStretchOf(Even(), 0).value();
  const double last_s = LastLikeStart(Even(), stretch);
  EXPECT_GE(last_s, stretch.end_s() - 1e-9);
  EXPECT_LT(last_s, Even().whole_body.end_s());
  const double cycles = (last_s - stretch.start_s) / stretch.cycle_s;
  EXPECT_NEAR(cycles, std::round(cycles), 1e-6);
  EXPECT_TRUE(Within(SeamBetween(Even(), stretch.start_s, Even(), last_s), kSteady) || last_s == stretch.end_s());
}

TEST(SameMoment, OfAPlanInItselfIsThatMomentInItsLastCycle) {
  const SteadyStretch stretch = SteadyStretchOf(Even(), 0).value();
  for (const double into_s : {0.0, 0.05, 0.1, 0.155}) {
    const double time_s = stretch.end_s() - stretch.cycle_s + into_s;
    const auto same = SameMoment(Even(), time_s, Even(), stretch);
    ASSERT_TRUE(same) << into_s;
    EXPECT_NEAR(*same, time_s, 1e-9);
  }
  const auto earlier = SameMoment(Even(), stretch.start_s, Even(), stretch);
  ASSERT_TRUE(earlier);
  EXPECT_NEAR(*earlier, stretch.end_s() - stretch.cycle_s, 1e-9) << "whole cycles later";
}

TEST(SameMoment, IsNoneWhereOtherFeetStand) {
  const SteadyStretch stretch = SteadyStretchOf(Even(), 0).value();
  MotionPlan flying = Even();
  for (ContactPhase& phase : flying.schedule.phases) phase.stance = 0;
  EXPECT_FALSE(SameMoment(flying, stretch.start_s, Even(), stretch));
}

}  // namespace
}  // namespace gaitwright
