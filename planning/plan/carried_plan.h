// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The transform that turns about z and moves in the plane: a pose of plan view as one of space.
Pose PoseOf(const PlanarPose& pose);

/// Where the base of a configuration is in plan view.
PlanarPose BaseInPlan(const VectorX& q);

/// A configuration, or the velocities or accelerations of one, of the whole robot moved rigidly by X.
VectorX CarriedState(const Pose& X, VectorX q);
VectorX CarriedRates(const Pose& X, VectorX v);

/// A plan moved in space and time: the motion is transformed by X, and begins `later_s` later. The ground is not moved,
/// so the motion fits it only if the ground is the same there.
/// @param X  rotates about z only.
MotionPlan CarriedPlan(const Pose& X, double later_s, MotionPlan plan);

}  // namespace gaitwright
