// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/joint_pd.h"

#include <fmt/format.h>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

const WholeBodyTrajectory& Checked(const RobotModel& model, const WholeBodyTrajectory& trajectory) {
  if (trajectory.size() == 0) throw InvalidArgument("the plan has no whole-body trajectory to replay");
  if (trajectory.q.front().size() != model.nq() || trajectory.tau.front().size() != model.num_dofs()) {
    throw InvalidArgument(fmt::format("the plan's states have {} numbers; robot '{}' has {}",
                                      trajectory.q.front().size(), model.name, model.nq()));
  }
  return trajectory;
}

}  // namespace

JointPd::JointPd(const RobotModel& model, const MotionPlan& plan, const GainOptions& options)
    : trajectory_(Checked(model, plan.whole_body)) {
  const Gains gains = DeriveGains(model, options);
  command_.stiffness = gains.stiffness;
  command_.damping = gains.damping;
}

JointCommand JointPd::Update(const ControlInput& input) {
  const Eigen::Index n = command_.stiffness.size();
  SampleWholeBody(trajectory_, input.time_s, sample_);
  command_.tau_ff = sample_.tau;
  SampleWholeBody(trajectory_, input.time_s + 0.5 * input.step_s, sample_);
  command_.v = sample_.v.tail(n);
  SampleWholeBody(trajectory_, input.time_s + input.step_s, sample_);
  command_.q = sample_.q.tail(n);
  return command_;
}

}  // namespace gaitwright
