// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "optimisation/pipeline/rigid_body_passes.h"

namespace gaitwright {

/// Runs the passes of a rigid body (RigidBodyPasses) for a task. With options.footholds "free" and uneven ground they
/// run twice, with fixed footholds and with footholds free on their patches, and the better motion is returned
/// (IsBetterMotion).
/// @param passes  number of passes of the returned motion.
Result<MotionPass> RunRigidBodyPasses(const MotionTask& task, const Crouch* crouch, int& passes);

}  // namespace gaitwright
