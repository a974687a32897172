// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/swing/former_motion.h"
#include "optimisation/whole_body/body_path.h"

namespace gaitwright {

/// Where the base is about when the centre of mass moves so, before any pass over the whole body: with the centre of
/// mass at its place in the standing posture, turned as the body is.
/// @param body, motion  outlive what is returned.
BaseMotion CarriedBase(const RobotModel& model, const BodyPath& body, const CentroidalTrajectory& motion);

}  // namespace gaitwright
