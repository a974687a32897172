// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/joint_pd.h"

#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

/// A plan whose joints accelerate at a constant rate from rest.
MotionPlan Accelerating(const RobotModel& model) {
  MotionPlan plan = standing::Plan(model, 0.1);
  WholeBodyTrajectory& w = plan.whole_body;
  for (std::size_t k = 0; k < w.q.size(); ++k) {
    const double t = w.step_s * static_cast<double>(k);
    w.q[k].tail(model.num_dofs()).array() += 0.5 * 3.0 * t * t;
    w.v[k].tail(model.num_dofs()).array() += 3.0 * t;
    w.a[k].tail(model.num_dofs()).array() += 3.0;
    w.tau[k].array() += t;
  }
  return plan;
}

TEST(JointPd, SamplesWhereTheStepFits) {
  const RobotModel model = standing::Load("a1");
  const MotionPlan plan = Accelerating(model);
  JointPd controller(model, plan);
  ControlInput input;
  input.time_s = 0.0312;
  input.step_s = 0.002;
  const JointCommand command = controller.Update(input);
  EXPECT_NEAR(command.q[4] - model.standing_joints[4], 1.5 * 0.0332 * 0.0332, 1e-12);
  EXPECT_NEAR(command.v[4], 3.0 * 0.0322, 1e-12);
  EXPECT_NEAR(command.tau_ff[4] - plan.whole_body.tau[0][4], 0.0312, 1e-12);
  const Gains gains = DeriveGains(model);
  EXPECT_EQ(command.stiffness, gains.stiffness);
  EXPECT_EQ(command.damping, gains.damping);
}

/// Torques of the measured state are compared at the start of the step, half a step after the measured velocity.
TEST(JointPd, SamplesForTorquesWhereTheStateIs) {
  const RobotModel model = standing::Load("a1");
  const MotionPlan plan = Accelerating(model);
  JointPd controller(model, plan);
  ControlInput input;
  input.time_s = 0.0312;
  input.step_s = 0.002;
  input.lead_steps = 0.0;
  const JointCommand command = controller.Update(input);
  EXPECT_NEAR(command.q[4] - model.standing_joints[4], 1.5 * 0.0312 * 0.0312, 1e-12);
  EXPECT_NEAR(command.v[4], 3.0 * 0.0302, 1e-12);
}

TEST(JointPd, HoldsTheEnd) {
  const RobotModel model = standing::Load("a1");
  const MotionPlan plan = Accelerating(model);
  JointPd controller(model, plan);
  ControlInput input;
  input.time_s = 9.0;
  const JointCommand command = controller.Update(input);
  EXPECT_EQ(command.q, plan.whole_body.q.back().tail(model.num_dofs()));
  EXPECT_EQ(command.v.norm(), 0.0);
}

TEST(JointPd, RefusesPlansOfOthers) {
  const RobotModel a1 = standing::Load("a1"), nao = standing::Load("nao");
  const MotionPlan plan = standing::Plan(a1, 0.1);
  EXPECT_THROW(JointPd(nao, plan), InvalidArgument);
  EXPECT_THROW(JointPd(nao, MotionPlan{}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
