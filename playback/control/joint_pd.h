// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/sample_plan.h"
#include "playback/control/controller.h"
#include "playback/control/gains.h"
#include "playback/control/loss_feed_forward.h"

namespace gaitwright {

/// Replays a plan: joint targets and feed-forward torques of the plan at the current time. The only feedback is the PD
/// of the joints. Feed-forward includes the losses of the joints (LossFeedForward). Targets are sampled so that they
/// fit the simulator's semi-implicit step to second order (see JointCommand). After the plan's end it holds the last
/// posture.
class JointPd : public Controller {
 public:
  /// @throws InvalidArgument if the plan has no whole-body trajectory of this robot's size or no torques, or if a gain
  /// option is out of its range. The plan must outlive this object.
  JointPd(const RobotModel& model, const MotionPlan& plan, const GainOptions& options = {});

  JointCommand Update(const ControlInput& input) override;
  std::string Name() const override { return "joint-pd"; }

 private:
  const WholeBodyTrajectory& trajectory_;
  WholeBodySample sample_;
  JointCommand command_;
  LossFeedForward losses_;
};

}  // namespace gaitwright
