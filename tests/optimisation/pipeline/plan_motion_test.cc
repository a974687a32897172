// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/plan_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/model/load_robot.h"
#include "planning/audit/audit.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {
namespace {

WalkCommand LongSteps() {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kSteps;
  command.steps = 6;
  command.step_length_m = 0.06;
  return command;
}

MotionPlan Planned(const RobotModel& model, const MotionOptions& options) {
  const Result<Gait> gait = FindGait(model, "", CommandedSpeed(model, LongSteps()), {});
  const Result<PlannedMotion> motion = PlanMotion(model, FlatTerrain(), *gait, LongSteps(), options);
  EXPECT_TRUE(motion.ok()) << motion.failure().message;
  return motion->plan;
}

double Height(const MotionPlan& plan) { return plan.centroidal.p_WC.front().z(); }

bool Passes(const RobotModel& model, const MotionPlan& plan) { return Audit(model, plan, {})->pass(); }

/// Arms held ahead take NAO's hips back, until the knees of the leg behind straighten too fast in long steps.
TEST(PlanMotion, GoesLowerWhereStraightKneesWouldBeTooFast) {
  const RobotModel model =
      *LoadRobotFromText(LoadNamedRobot("nao")->urdf_text,
                         "standing: {LShoulderPitch: 0, RShoulderPitch: 0, LShoulderRoll: 0, RShoulderRoll: 0}", "nao");
  const MotionPlan chosen = Planned(model, {});
  EXPECT_TRUE(chosen.warnings.empty());
  EXPECT_TRUE(Passes(model, chosen));
  MotionOptions upright;
  upright.pipeline.com_height_m = Height(chosen) / 0.98;
  const MotionPlan asked = Planned(model, upright);
  EXPECT_NEAR(Height(asked), upright.pipeline.com_height_m, 1e-6) << "a height that is asked for is kept";
  EXPECT_FALSE(asked.warnings.empty());
  EXPECT_FALSE(Passes(model, asked));
}

TEST(PlanMotion, TheSameTwice) {
  const RobotModel model = *LoadNamedRobot("nao");
  const MotionPlan first = Planned(model, {}), second = Planned(model, {});
  EXPECT_EQ(first.whole_body.q, second.whole_body.q);
  EXPECT_EQ(first.whole_body.tau, second.whole_body.tau);
}

}  // namespace
}  // namespace gaitwright
