// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "planning/plan/motion_plan.h"
#include "planning/plan/sample_plan.h"
#include "playback/control/controller.h"
#include "playback/control/gains.h"
#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// Example of a user's own controller: state in, command out. It tracks the planned joint positions by PD. Its
/// feed-forward torque fades in over the first `fade_s`, as on hardware that is being lifted off its stand.
class FadingIn : public Controller {
 public:
  /// The plan must outlive the controller. @throws InvalidArgument unless fade_s > 0.
  FadingIn(const RobotModel& model, const MotionPlan& plan, double fade_s);

  JointCommand Update(const ControlInput& input) override;
  std::string Name() const override { return "fading-in"; }

 private:
  const MotionPlan& plan_;
  Gains gains_;
  double fade_s_;
  WholeBodySample wanted_;
};

/// Plans a walk of 0.3 m for a built-in robot, plays it with FadingIn and scores it.
/// @throws InvalidArgument if the walk cannot be planned or played.
StabilityReport WalkWithOwnController(const std::string& robot, double fade_s);

}  // namespace gaitwright::examples
