// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/whole_body_bench.h"

#include <gtest/gtest.h>

#include <set>

namespace gaitwright {
namespace {

TEST(WholeBodyBench, NamesItsCases) {
  std::set<std::string> names;
  for (const WholeBodyCase& one : WholeBodyCases()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_TRUE(one.name.starts_with(one.robot)) << one.name;
    EXPECT_GT(one.distance_m, 0.0);
  }
  EXPECT_EQ(WholeBodyCases("a1-chain").size(), 4U);
  EXPECT_TRUE(WholeBodyCases("horse").empty());
}

/// Of Crocoddyl's examples: a quadruped's walk has four swings of 0.25 s and 0.25 m in a cycle of 1.08 s.
TEST(WholeBodyBench, StatesTasksByTheirSteps) {
  const std::vector<WholeBodyCase> tasks = StepTasks("dog", 4);
  ASSERT_EQ(tasks.size(), 5U);
  EXPECT_EQ(tasks[0].name, "dog-step-walk");
  EXPECT_NEAR(tasks[0].timing.cycle_s, 1.08, 1e-12);
  EXPECT_NEAR((1.0 - tasks[0].timing.duty_factor) * 1.08, 0.25, 1e-12);
  EXPECT_NEAR(tasks[0].speed_m_s * 1.08, 0.25, 1e-12);
  EXPECT_EQ(tasks[0].swing_height_m, 0.15);
  ASSERT_EQ(StepTasks("man", 2).size(), 1U);
  EXPECT_NEAR(StepTasks("man", 2)[0].timing.cycle_s, 2.7, 1e-12);
  EXPECT_TRUE(StepTasks("ant", 6).empty());
}

TEST(WholeBodyBench, MeasuresAFinishedPlan) {
  const WholeBodyOutcome outcome = RunWholeBodyCase({"a1-pronk", "a1", "pronk", 0.5, 0.3}, {});
  ASSERT_TRUE(outcome.finished) << outcome.reason;
  EXPECT_TRUE(outcome.passes_audit);
  EXPECT_LE(outcome.finished->residual_force, 1e-3);
  EXPECT_GT(outcome.MsAnIteration(), 0.0);
  EXPECT_GE(outcome.planning_cpu_s, outcome.finished->solve_cpu_s);
  EXPECT_NE(WholeBodyTable({outcome}).find("pass"), std::string::npos);
}

TEST(WholeBodyBench, SaysWhyThereIsNoPlan) {
  const WholeBodyOutcome outcome = RunWholeBodyCase({"a1-leap", "a1", "pronk", 60.0, 1.0}, {});
  EXPECT_FALSE(outcome.finished);
  EXPECT_FALSE(outcome.reason.empty());
  EXPECT_NE(WholeBodyTable({outcome}).find(outcome.reason), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
