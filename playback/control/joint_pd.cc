// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/joint_pd.h"

#include "planning/plan/check_motion.h"

namespace gaitwright {
namespace {

const WholeBodyTrajectory& Checked(const RobotModel& model, const WholeBodyTrajectory& trajectory) {
  CheckMotion(model, trajectory, {.torques = true});
  return trajectory;
}

}  // namespace

JointPd::JointPd(const RobotModel& model, const MotionPlan& plan, const GainOptions& options)
    : trajectory_(Checked(model, plan.whole_body)), losses_(model, options) {
  const Gains gains = DeriveGains(model, options);
  command_.stiffness = gains.stiffness;
  command_.damping = gains.damping;
}

JointCommand JointPd::Update(const ControlInput& input) {
  const Eigen::Index n = command_.stiffness.size();
  SampleWholeBody(trajectory_, input.time_s, sample_);
  command_.tau_ff = sample_.tau;
  losses_.AddInertia(sample_.a.tail(n), command_.tau_ff);
  SampleWholeBody(trajectory_, input.time_s + (input.lead_steps - 0.5) * input.step_s, sample_);
  command_.v = sample_.v.tail(n);
  losses_.AddDrag(command_.v, command_.tau_ff);
  SampleWholeBody(trajectory_, input.time_s + input.lead_steps * input.step_s, sample_);
  command_.q = sample_.q.tail(n);
  return command_;
}

}  // namespace gaitwright
