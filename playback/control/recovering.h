// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "kinematics/base/options.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/control/controller.h"
#include "playback/control/gains.h"
#include "playback/control/stabilised.h"

namespace gaitwright {

/// Tuning
///   steps though it would have stood            lower step_margin
///   steps too late, and falls all the same      raise step_margin
///   gets down though a step would have done     raise brace_margin
///   strikes the ground before it is down        lower brace_margin or brace_tilt_rad
struct RecoveringOptions {
  double step_margin = 0.02;
  double brace_margin = 0.25;
  double brace_tilt_rad = 0.6;
  double brace_gain = 0.5;

  OptionFields Fields() {
    return WithBasics(
        {"step_margin", "brace_margin"},
        {{"step_margin", &step_margin, "1, leg lengths", 0.0, 1.0,
          "The robot takes a recovery step if the DCM is closer than this to the edge of the feet's convex hull."},
         {"brace_margin", &brace_margin, "1, leg lengths", 0.0, 10.0,
          "Distance of the DCM outside the feet's convex hull beyond which a fall is considered certain."},
         {"brace_tilt_rad", &brace_tilt_rad, "rad", 0.1, 3.0, "Base tilt beyond which a fall is considered certain."},
         {"brace_gain", &brace_gain, "1", 0.0, 10.0,
          "Factor on the stiffness and damping of joints while the robot braces for a fall."}});
  }
};

/// Recovery motions of a standing robot.
struct RecoveryPlans {
  std::optional<MotionPlan> steps;  ///< on the spot, from standing to standing; nothing for a robot that cannot step
  VectorX low;                      ///< joints of a protective crouch, size n
};

/// Stands by `stabilised`, and
///   steps     when the DCM comes near to the edge of the support: the plan of steps, moved to where the robot is, from
///             the lift of a foot on, by `stabilised`, which moves its footholds to where the fall can be caught (the
///             foot towards which the robot falls stays); stands again by its end, and steps again where it has to;
///   braces when a fall is certain: the joints go to the protective crouch, softly, and stay there.
/// The DCM c + c' / w of the centre of mass c; Englsberger et al., T-RO 31(2), 2015. Steps of bipeds begin without the
/// shift of weight that walks begin with: there is no time for it.
/// @throws InvalidArgument for a plan that does not stand on all feet of legs from its start to its end, or steps of
/// another robot; as of MakeStabilised. Model and plan must outlive it; the recovery plans are copied.
std::unique_ptr<Controller> MakeRecovering(const RobotModel& model, const MotionPlan& plan, RecoveryPlans recovery,
                                           const RecoveringOptions& options = {},
                                           const StabilisedOptions& stabilised = {}, const GainOptions& gains = {});

}  // namespace gaitwright
