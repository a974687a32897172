// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"
#include "playback/play/play.h"

namespace gaitwright {

/// One step of a playback: the feet that the plan has landing at one time, what disturbed them since the step before,
/// and how they landed. Figures of several feet are their mean.
struct GaitStep {
  double ground_m = 0.0;  ///< height of the bumps where they land, less that of the bumps under the other feet [m]
  double push_ahead_n_s = 0.0, push_left_n_s = 0.0;  ///< impulse of pushes, as the planned base heads at the step [N s]
  bool landed = false;                               ///< all of them did, near their time; else what follows is zero
  double late_s = 0.0;                               ///< after the plan
  double ahead_m = 0.0, left_m = 0.0;                ///< off the plan, each beside the base of its own at that time

  bool operator==(const GaitStep&) const = default;
};

/// By what steps of a robot are scaled, so that those of others compare.
struct GaitScale {
  double leg_length_m = 0.0, mass_kg = 0.0;
  double step_s = 0.0;  ///< mean time from step to step; 0 where there are none

  bool operator==(const GaitScale&) const = default;
};

/// Those of a robot and a plan.
GaitScale GaitScaleOf(const RobotModel& model, const MotionPlan& plan);

/// The steps of a plan as they were played: one for each time at which feet land, in order, so that two playbacks of
/// one plan have as many. The bumps are known from the options, whose seed makes them, and so is what pushed; times and
/// places of landing are those of the log.
std::vector<GaitStep> GaitStepsOf(const RobotModel& model, const MotionPlan& plan, const PlayOptions& options,
                                  const PlaybackLog& log);

}  // namespace gaitwright
