// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/sample_plan.h"
#include "playback/control/controller.h"
#include "playback/control/gains.h"
#include "playback/control/loss_feed_forward.h"

namespace gaitwright {

/// Replays a plan: joint targets and feed-forward torques of the plan at the time, no feedback but the joints' own PD.
/// To the feed-forward is added what the joints take for themselves (LossFeedForward). Targets are taken where the
/// simulator's semi-implicit step fits them to second order (see JointCommand). After the plan's end it holds the last
/// posture.
class JointPd : public Controller {
 public:
  /// @throws InvalidArgument when the plan has no whole-body trajectory of this robot's size, or none with torques, or
  /// a gain option is out of its range. The plan must outlive this.
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
