// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/description/mjcf_equality_internal.h"

namespace gaitwright {

/// What <connect> and <weld> do to a tree of joints. A loop in a small part of the robot that carries no foot, such as
/// a gripper or a neck that rods move, stands still as the file draws it: its joints are locked, which is noted. Throws
/// a Failure on any other loop, with the joints that it goes through, and on ties to the world.
/// @param masses     by body [kg].
/// @param couplings  by joint; those of the loops' joints are changed.
void LockMjcfLoops(MjcfContext& context, const MjcfTree& tree, const std::vector<double>& masses,
                   std::vector<MjcfCoupling>& couplings);

}  // namespace gaitwright
