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
/// @throws InvalidArgument for plans of different robots, or a time that is not of a row.
Seam SeamBetween(const MotionPlan& before, double before_s, const MotionPlan& after, double after_s);

/// Whether the same feet are on the ground just before and just after two times; beyond the ends of a motion, any are
/// accepted.
bool SameStance(const MotionPlan& one, double one_s, const MotionPlan& other, double other_s);

/// A plan from a time on, without the earlier part. Feet that are in the air then have no foothold before.
/// @throws InvalidArgument for a time that is not of one of its rows, or of the last.
MotionPlan PlanFrom(MotionPlan plan, double from_s);

/// One motion: `before` up to `before_s`, and then what `after` does from `after_s` on, turned about z, moved in plan
/// view and in time so that its base goes on where that of `before` is. The ground is that of `before`. Differences at
/// the seam are blended over the last 0.4 s of `before`; torques and forces stay, so the differences must be small. A
/// part that the seam cuts in two is one that lasts so long as it does (WalkCommand::Extent::kDuration); two of the
/// same gait and command that meet become one. The pendulum of the whole is as high as those of the two on average over
/// time. Failure kBadInput `misfit`: plans of different robots or time steps, times that are not of rows, feet that
/// stand in the one and are in the air in the other just before or just after the seam.
Result<MotionPlan> JoinedPlans(const MotionPlan& before, double before_s, const MotionPlan& after, double after_s);

}  // namespace gaitwright
