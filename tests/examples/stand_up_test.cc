// SPDX-License-Identifier: BSD-3-Clause
#include "examples/stand_up.h"

#include <gtest/gtest.h>

namespace gaitwright::examples {
namespace {

class StandUpExample : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Robots, StandUpExample, testing::Values("a1", "go1", "laikago", "mini_cheetah"),
                         [](const auto& robot) { return robot.param; });

/// Each phase ends when it is measured to be done, and the ZMP is where it should be at the end.
TEST_P(StandUpExample, GetsUpInPhases) {
  std::vector<std::string> phases;
  const StoodUp up = StandUp(GetParam(), [&](const GateRecord& phase) {
    phases.push_back(phase.phase);
    EXPECT_TRUE(phase.met) << phase.phase;
  });
  EXPECT_EQ(phases, (std::vector<std::string>{"init", "lift front", "lift rear", "balance"}));
  EXPECT_TRUE(up.report.pass) << up.report.reason;
  EXPECT_LT(up.zmp_error_m, 0.012);
  ASSERT_EQ(up.log.gates.size(), 4U);
  EXPECT_EQ(up.log.gates.front().phase, "init");
}

TEST(StandUpExamples, ABipedIsRefused) { EXPECT_THROW(StandUp("nao", {}), InvalidArgument); }

}  // namespace
}  // namespace gaitwright::examples
