// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/description/mjcf_equality_internal.h"

namespace gaitwright {

/// Applies <connect> and <weld> to a tree of joints. A loop in a small part of the robot that carries no foot, such as
/// a gripper or a neck with rods, is locked in the posture of the file, with a note. Throws a Failure for any other
/// loop, with its joints, and for ties to the world.
/// @param masses     by body [kg].
/// @param couplings  by joint; the couplings of joints in loops are changed.
void LockMjcfLoops(MjcfContext& context, const MjcfTree& tree, const std::vector<double>& masses,
                   std::vector<MjcfCoupling>& couplings);

}  // namespace gaitwright
