// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_motion.h"

namespace gaitwright {

/// In a rigid body's motion, contacts move at constant speed over each interval, but spheres roll as their legs rotate.
/// The additional moment of the forces for the contacts of `problem`, by sample:
///   sum (p_i - p_i of the motion) x f_i.
/// @param samples  of the motion, in order.
/// @return [N m], in W.
std::vector<Vector3> RollMoments(const RigidBodyProblem& problem, const RigidBodyMotion& motion,
                                 const std::vector<RigidBodySample>& samples);

}  // namespace gaitwright
