// SPDX-License-Identifier: BSD-3-Clause
#include "examples/standing.h"

#include <gtest/gtest.h>

#include "examples/standing_controllers.h"
#include "kinematics/base/result.h"
#include "kinematics/model/load_robot.h"
#include "optimisation/pipeline/plan_posture.h"
#include "planning/tasks/repertoire.h"

namespace gaitwright::examples {
namespace {

/// The humanoid stands with each, and the whole body takes more than joints alone do.
TEST(StandingExample, TheHumanoidStandsWithEach) {
  const std::vector<Withstood> all = CompareStanding("humanoid");
  ASSERT_EQ(all.size(), StandingStrategies().size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(all[k].strategy, StandingStrategies()[k]);
    EXPECT_GT(all[k].ahead_n, 0.0) << all[k].strategy;
    EXPECT_GT(all[k].back_n, 0.0) << all[k].strategy;
    EXPECT_GT(all[k].left_n, 0.0) << all[k].strategy;
  }
  EXPECT_GT(all.back().ahead_n, all.front().ahead_n);
  EXPECT_NE(StandingPlot("humanoid", all).find("<svg"), std::string::npos);
}

TEST(StandingExample, AnUnknownStrategyIsNamed) {
  const RobotModel nao = LoadNamedRobot("nao").value();
  const MotionPlan plan = PlanPosture(nao, Hold(StandingKey(nao), 1.0), {}).value();
  EXPECT_THROW(MakeStandingController("toes", nao, plan), InvalidArgument);
  EXPECT_THROW(CompareStanding("nobody"), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright::examples
