// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_motion.h"

namespace gaitwright {

/// A motion of a rigid body has contacts that move evenly over each of its intervals; spheres roll as their legs turn.
/// What forces give besides, where contacts are those of `problem`, by sample:
///   sum (p_i - p_i of the motion) x f_i.
/// @param samples  of the motion, in order.
/// @return [N m], in W.
std::vector<Vector3> RollMoments(const RigidBodyProblem& problem, const RigidBodyMotion& motion,
                                 const std::vector<RigidBodySample>& samples);

}  // namespace gaitwright
