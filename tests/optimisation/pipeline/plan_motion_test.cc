// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/plan_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/dynamics/foot_contact.h"
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

/// Arms held forward move the hips backward, so that in long steps the knee of the rear leg straightens too fast.
TEST(PlanMotion, GoesLowerWhereStraightKneesWouldBeTooFast) {
  const RobotModel model =
      *LoadRobotFromText(LoadNamedRobot("nao")->urdf_text,
                         "nominal_speed_m_s: 0.06\n"
                         "standing: {LShoulderPitch: 0, RShoulderPitch: 0, LShoulderRoll: 0, RShoulderRoll: 0}",
                         "nao");
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

TEST(PlanMotion, OptionsOfARigidBodyAreNamedWhereTheMotionIsAPendulums) {
  const RobotModel model = *LoadNamedRobot("a1");
  MotionOptions timed;
  timed.timing = "optimised";
  timed.footholds = "free";
  const MotionPlan usual = Planned(model, {}), asked = Planned(model, timed);
  EXPECT_TRUE(usual.warnings.empty());
  ASSERT_EQ(asked.warnings.size(), 2U);
  EXPECT_EQ(asked.warnings[0].substr(0, 17), "timing=optimised ");
  EXPECT_EQ(asked.warnings[1].substr(0, 15), "footholds=free ");
  EXPECT_EQ(asked.whole_body.q, usual.whole_body.q);
}

/// The initial guess is the standing posture, whose feet have another rotation than those of a lowered posture.
TEST(PlanMotion, SpheresStandStillOnTheirFootholdsFromTheFirstRowAtAnyHeight) {
  const RobotModel model = *LoadNamedRobot("a1");
  MotionOptions low;
  low.pipeline.com_height_m = 0.9 * Height(Planned(model, {}));
  const MotionPlan plan = Planned(model, low);
  DynamicsScratch scratch(model);
  for (const std::size_t row : {0U, 1U}) {
    ForwardKinematics(model, plan.whole_body.q[row], scratch);
    for (const Foothold& foothold : plan.footsteps.footholds) {
      if (foothold.touchdown_s > 0.0) continue;
      const Vector3 p_WF = ContactFrame(model, scratch, foothold.foot).translation();
      EXPECT_LT((p_WF - foothold.X_WF.translation()).norm(), 1e-6) << "row " << row << ", foot " << foothold.foot;
    }
  }
  EXPECT_TRUE(Passes(model, plan));
}

TEST(PlanMotion, TheSameTwice) {
  const RobotModel model = *LoadNamedRobot("nao");
  const MotionPlan first = Planned(model, {}), second = Planned(model, {});
  EXPECT_EQ(first.whole_body.q, second.whole_body.q);
  EXPECT_EQ(first.whole_body.tau, second.whole_body.tau);
}

}  // namespace
}  // namespace gaitwright
