// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/placed_steps.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/terrain.h"
#include "workflows/exchange/footstep_file.h"

namespace gaitwright {
namespace {

const RobotModel& Robot() {
  static const RobotModel model = *LoadNamedRobot("a1");
  return model;
}

/// One step of each foot, 5 cm forward.
std::vector<PlacedStep> OneRound() {
  std::vector<PlacedStep> steps;
  for (const int foot : {3, 1, 2, 0}) {
    const Vector3 p_W = StandingFeet(Robot())[static_cast<std::size_t>(foot)].translation();
    steps.push_back({foot, {p_W.x() + 0.05, p_W.y(), 0.0}});
  }
  return steps;
}

TEST(PlacedSteps, TheFileSaysTheSame) {
  const std::string yaml = FootstepsYaml(Robot(), OneRound(), {.swing_s = 0.4, .pause_s = 0.1});
  const FootstepPlan read = ReadFootsteps(Robot(), FlatTerrain(), yaml, "steps", 0.005).value().footsteps;
  ASSERT_EQ(read.footholds.size(), 8U);  // including the initial positions
  for (std::size_t k = 0; k < 4; ++k) {
    const PlacedStep step = OneRound()[k];
    EXPECT_EQ(read.footholds[4 + k].foot, step.foot);
    EXPECT_NEAR(read.footholds[4 + k].X_WF.translation().x(), step.place.x_m, 1e-12);
    EXPECT_NEAR(read.footholds[4 + k].X_WF.translation().y(), step.place.y_m, 1e-12);
    EXPECT_NEAR(read.footholds[4 + k].touchdown_s, 0.8 + 0.4 + 0.5 * static_cast<double>(k), 1e-9);
  }
}

TEST(PlacedSteps, AreWhatThePlanIsMadeOf) {
  const Result<MotionPlan> plan = PlanOverSteps(Robot(), FlatTerrain(), OneRound());
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  EXPECT_EQ(plan->footsteps.footholds.size(), 8U);
  EXPECT_NEAR(plan->whole_body.q.back()[0] - plan->whole_body.q.front()[0], 0.05, 0.01);
}

TEST(PlacedSteps, OfNoFootAreRefused) {
  EXPECT_THROW(FootstepsYaml(Robot(), {{4, {}}}, {}), InvalidArgument);
  EXPECT_THROW(FootstepsYaml(Robot(), {{-1, {}}}, {}), InvalidArgument);
  EXPECT_FALSE(PlanOverSteps(Robot(), FlatTerrain(), {}).ok());
  EXPECT_FALSE(PlanOverSteps(Robot(), FlatTerrain(), {{0, {9.0, 0.0, 0.0}}}).ok());
}

}  // namespace
}  // namespace gaitwright
