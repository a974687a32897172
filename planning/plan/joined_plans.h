// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Differences between two motions at a transition, each as its largest component.
struct Seam {
  double height_m = 0.0;     ///< of the base
  double tilt_rad = 0.0;     ///< of the base's z axis
  double joints = 0.0;       ///< positions [rad] or [m]
  double base_rates = 0.0;   ///< [m/s] or [rad/s]
  double joint_rates = 0.0;  ///< [rad/s] or [m/s]
};

/// Difference of the states of two plans at given times, independent of their pose in plan view.
/// @throws InvalidArgument for plans of different robots, or a time that is not the time of a row.
Seam SeamBetween(const MotionPlan& before, double before_s, const MotionPlan& after, double after_s);

/// Whether the same feet are on the ground just before and just after the given times. Beyond the ends of a motion, any
/// stance is accepted.
bool SameStance(const MotionPlan& one, double one_s, const MotionPlan& other, double other_s);

/// The later part of a plan, from a time on. Feet that are in the air at that time have no earlier foothold.
/// @throws InvalidArgument for a time that is not the time of a row, or that of the last row.
MotionPlan PlanFrom(MotionPlan plan, double from_s);

/// Joins two motions: `before` up to `before_s`, then `after` from `after_s` on, rotated about z and moved in plan view
/// and in time so that its base continues from that of `before`. The ground is that of `before`. Differences at the
/// seam are blended over the last 0.4 s of `before`; torques and forces are not changed, so the differences must be
/// small. A part that the seam cuts in two gets its duration as extent (WalkCommand::Extent::kDuration). Two parts with
/// the same gait and command that meet at the seam become one. The pendulum height is the mean of the two heights over
/// time. Failure kBadInput `misfit`: plans of different robots or time steps, times that are not times of rows, feet
/// that are on the ground in only one of the motions just before or just after the seam.
Result<MotionPlan> JoinedPlans(const MotionPlan& before, double before_s, const MotionPlan& after, double after_s);

}  // namespace gaitwright
