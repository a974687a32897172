// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/pipeline/repeat_cycles_internal.h"
#include "planning/audit/audit.h"
#include "planning/gait/find_gait.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/plan/steady_stretch.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

PlannedMotion Planned(const std::string& robot, const std::string& gait, const WalkCommand& command,
                      const std::string& cycles) {
  const RobotModel& model = NamedRobot(robot);
  MotionOptions options;
  options.trajectory.cycles = cycles;
  const Result<PlannedMotion> planned =
      PlanMotion(model, FlatTerrain(0.8), *FindGait(model, gait, CommandedSpeed(model, command), {}), command, options);
  EXPECT_TRUE(planned.ok()) << (planned.ok() ? "" : planned.failure().message);
  if (!planned) return {};
  EXPECT_FALSE(planned->unfinished) << planned->unfinished->message;
  const Result<AuditReport> audit = Audit(model, planned->plan, {});
  for (const Violation& v : audit->violations)
    ADD_FAILURE() << LawName(v.law) << " at " << v.at_s << ", " << v.where << ": " << v.value << " over " << v.limit;
  return *planned;
}

WalkCommand Forward(double speed_m_s, double distance_m) {
  WalkCommand command;
  command.speed_m_s = speed_m_s;
  command.distance_m = distance_m;
  return command;
}

/// Largest difference of states over all whole cycles of a stretch.
Seam LargestSeam(const MotionPlan& plan, const SteadyStretch& stretch) {
  Seam largest;
  for (int i = 1; i <= stretch.cycles; ++i) {
    const Seam seam = SeamBetween(plan, stretch.start_s, plan, stretch.start_s + i * stretch.cycle_s);
    largest.height_m = std::max(largest.height_m, seam.height_m);
    largest.tilt_rad = std::max(largest.tilt_rad, seam.tilt_rad);
    largest.joints = std::max(largest.joints, seam.joints);
    largest.base_rates = std::max(largest.base_rates, seam.base_rates);
    largest.joint_rates = std::max(largest.joint_rates, seam.joint_rates);
  }
  return largest;
}

constexpr Seam kExact = {.height_m = 2e-5, .tilt_rad = 2e-5, .joints = 5e-5, .base_rates = 1e-3, .joint_rates = 2e-3};

struct PeriodicWalk {
  const char *robot, *gait;
  double speed_m_s, distance_m;
  int cycles;
};

class PeriodicWalks : public testing::TestWithParam<PeriodicWalk> {};

TEST_P(PeriodicWalks, RepeatEachCycleExactly) {
  const PeriodicWalk& walk = GetParam();
  const PlannedMotion planned = Planned(walk.robot, walk.gait, Forward(walk.speed_m_s, walk.distance_m), "periodic");
  ASSERT_TRUE(planned.finished);
  EXPECT_GE(planned.finished->cycles, walk.cycles);
  EXPECT_LE(planned.finished->residual_force, 1e-3);
  const auto stretch = SteadyStretchOf(planned.plan, 0, kExact);
  ASSERT_TRUE(stretch);
  EXPECT_GE(stretch->cycles, walk.cycles - 1);
  EXPECT_TRUE(Within(LargestSeam(planned.plan, *stretch), kExact));
}

INSTANTIATE_TEST_SUITE_P(All, PeriodicWalks,
                         testing::Values(PeriodicWalk{"a1", "trot", 0.8, 1.6, 2},
                                         PeriodicWalk{"a1", "pace", 0.8, 1.6, 1},
                                         PeriodicWalk{"nao", "walk", 0.1, 0.6, 1}),
                         [](const auto& walk) { return std::string(walk.param.robot) + walk.param.gait; });

TEST(RepeatCycles, TurnsWithTheWalk) {
  WalkCommand command = Forward(0.5, 1.5);
  command.yaw_rate_rad_s = 0.4;
  const PlannedMotion planned = Planned("a1", "trot", command, "periodic");
  ASSERT_TRUE(planned.finished);
  EXPECT_GE(planned.finished->cycles, 2);
  EXPECT_TRUE(SteadyStretchOf(planned.plan, 0, kExact));
}

TEST(RepeatCycles, NeedsACycleThatTheNextOneRepeats) {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kSteps;
  command.steps = 4;
  command.step_length_m = 0.05;
  const PlannedMotion planned = Planned("a1", "jump", command, "periodic");
  ASSERT_TRUE(planned.finished);
  EXPECT_EQ(planned.finished->cycles, 0);
  ASSERT_FALSE(planned.plan.warnings.empty());
  EXPECT_NE(planned.plan.warnings.back().find("trajectory.cycles"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
