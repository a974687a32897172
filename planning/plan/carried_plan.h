// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// A planar pose as a pose in space: translation in the plane and rotation about z.
Pose PoseOf(const PlanarPose& pose);

/// Planar pose of the base of a configuration.
PlanarPose BaseInPlan(const VectorX& q);

/// The configuration q of the whole robot, or a velocity or acceleration of q, moved rigidly by X.
VectorX CarriedState(const Pose& X, VectorX q);
VectorX CarriedRates(const Pose& X, VectorX v);

/// A plan moved in space and time: the motion is transformed by X and begins `later_s` later. The ground is not moved,
/// so the motion is valid only if the ground is the same at the new place.
/// @param X  rotates about z only.
MotionPlan CarriedPlan(const Pose& X, double later_s, MotionPlan plan);

}  // namespace gaitwright
