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

/// The same motion elsewhere and at another time: all that moves is turned about z and moved by X, and begins `later_s`
/// later. The ground stays where it is, so that the motion fits it only where the ground is the same there.
/// @param X  turns about z alone.
MotionPlan CarriedPlan(const Pose& X, double later_s, MotionPlan plan);

}  // namespace gaitwright
