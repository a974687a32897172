// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/swing/former_motion.h"
#include "optimisation/whole_body/body_path.h"

namespace gaitwright {

/// Approximate base motion for a motion of the centre of mass, before any whole-body pass. The centre of mass is fixed
/// in the base as in the standing posture.
/// @param body, motion  must outlive the result.
BaseMotion CarriedBase(const RobotModel& model, const BodyPath& body, const CentroidalTrajectory& motion);

}  // namespace gaitwright
