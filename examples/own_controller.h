// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "planning/plan/motion_plan.h"
#include "planning/plan/sample_plan.h"
#include "playback/control/controller.h"
#include "playback/control/gains.h"
#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// A controller of one's own: state in, command out. It holds the joints on the plan by PD, with a feed-forward torque
/// that fades in over the first `fade_s`, as one does on hardware that is just being lifted off its stand.
class FadingIn : public Controller {
 public:
  /// The plan must outlive it. @throws InvalidArgument unless fade_s > 0.
  FadingIn(const RobotModel& model, const MotionPlan& plan, double fade_s);

  JointCommand Update(const ControlInput& input) override;
  std::string Name() const override { return "fading-in"; }

 private:
  const MotionPlan& plan_;
  Gains gains_;
  double fade_s_;
  WholeBodySample wanted_;
};

/// Plans 0.3 m of walking for a robot that comes with the program, plays it with FadingIn and judges it.
/// @throws InvalidArgument with the reason when it cannot be planned or played.
StabilityReport WalkWithOwnController(const std::string& robot, double fade_s);

}  // namespace gaitwright::examples
