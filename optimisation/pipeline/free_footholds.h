// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "optimisation/pipeline/rigid_body_passes.h"

namespace gaitwright {

/// The passes of a rigid body (RigidBodyPasses) over a task. With options.footholds "free" and ground that is not level
/// they are made twice, with footholds held and free on their patches, and the better motion is taken (IsBetterMotion).
/// @param passes  made for the motion that is given.
Result<MotionPass> RunRigidBodyPasses(const MotionTask& task, const Crouch* crouch, int& passes);

}  // namespace gaitwright
