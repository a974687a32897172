// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"
#include "playback/play/play.h"

namespace gaitwright {

/// One step of a playback: the feet that the plan lands at one time, the disturbances since the previous step, and the
/// landing. Values are means over the feet.
struct GaitStep {
  double ground_m = 0.0;  ///< bump height at the landing feet minus bump height at the other feet [m]
  double push_forward_n_s = 0.0, push_left_n_s = 0.0;  ///< impulse of pushes, in the planned heading at the step [N s]
  bool landed = false;                   ///< all feet landed near their time; otherwise the values below are zero
  double late_s = 0.0;                   ///< measured minus planned time
  double forward_m = 0.0, left_m = 0.0;  ///< measured minus planned place, each relative to its own base at that time

  bool operator==(const GaitStep&) const = default;
};

/// Scales of a robot's steps, so that values of different robots can be compared.
struct GaitScale {
  double leg_length_m = 0.0, mass_kg = 0.0;
  double step_s = 0.0;  ///< mean time between steps; 0 without steps

  bool operator==(const GaitScale&) const = default;
};

/// The scales of a robot and a plan.
GaitScale GaitScaleOf(const RobotModel& model, const MotionPlan& plan);

/// The steps of a plan as played: one per landing time, in order, so that two playbacks of one plan have the same
/// number. The bumps follow from the options and their seed, and the pushes from the options; times and places of
/// landing are those of the log.
std::vector<GaitStep> GaitStepsOf(const RobotModel& model, const MotionPlan& plan, const PlayOptions& options,
                                  const PlaybackLog& log);

}  // namespace gaitwright
