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
///   steps although it would not have fallen       lower step_margin
///   steps too late and falls                      raise step_margin
///   braces although a step would have sufficed    raise brace_margin
///   falls before it has crouched                  lower brace_margin or brace_tilt_rad
struct RecoveringOptions {
  double step_margin = 0.02;
  double brace_margin = 0.25;
  double brace_tilt_rad = 0.6;
  double brace_gain = 0.5;

  OptionFields Fields() {
    return WithBasics(
        {"step_margin", "brace_margin"},
        {{"step_margin", &step_margin, "1", 0.0, 1.0,
          "The robot takes a recovery step if the DCM is closer than this share of the leg length to the edge of the "
          "feet's "
          "convex hull."},
         {"brace_margin", &brace_margin, "1", 0.0, 10.0,
          "Distance of the DCM outside the feet's convex hull, as a share of the leg length, beyond which a fall is "
          "considered certain."},
         {"brace_tilt_rad", &brace_tilt_rad, "rad", 0.1, 3.0, "Base tilt beyond which a fall is considered certain."},
         {"brace_gain", &brace_gain, "1", 0.0, 10.0,
          "Factor on the stiffness and damping of joints while the robot braces for a fall."}});
  }
};

/// Recovery motions of a standing robot.
struct RecoveryPlans {
  std::optional<MotionPlan> steps;  ///< on the spot, from standing to standing; empty for a robot that cannot step
  VectorX low;                      ///< joints of a protective crouch, size n
};

/// Stands by `stabilised`, and in addition:
///   steps     when the DCM comes near to the edge of the support. The plan of steps is moved to the robot's place and
///             starts at the lift of a foot. `stabilised` follows it and moves its footholds so that they stop the
///             fall. The foot towards which the robot falls stays on the ground. After the end of the plan the robot
///             stands again, and steps again if needed;
///   braces    when a fall is certain: the joints move to the protective crouch with low gains, and stay there.
/// The DCM is c + c' / w of the centre of mass c; Englsberger et al., T-RO 31(2), 2015. Steps of bipeds begin without
/// the weight shift of a planned walk, because there is no time for it.
/// @throws InvalidArgument for a plan that does not stand on all feet from its start to its end, for steps of another
/// robot, and as MakeStabilised. Model and plan must outlive the controller; the recovery plans are copied.
std::unique_ptr<Controller> MakeRecovering(const RobotModel& model, const MotionPlan& plan, RecoveryPlans recovery,
                                           const RecoveringOptions& options = {},
                                           const StabilisedOptions& stabilised = {}, const GainOptions& gains = {});

}  // namespace gaitwright
