// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kinematics/description/mjcf_equality_internal.h"

namespace gaitwright {

/// Positions of joints in the keyframe `home`, or else in the first one, by the joint names of the URDF. A ball joint
/// has three angles about x, y and z. Empty without a keyframe. Positions outside the range of a joint, and keyframes
/// with a wrong number of positions, are left out with a note.
std::vector<std::pair<std::string, double>> ReadMjcfPosture(MjcfContext& context, const MjcfTree& tree,
                                                            const std::vector<MjcfCoupling>& couplings);

/// The angles of a rotation about x, y and z in the rotating frame, in this order [rad].
Vector3 MjcfTurns(const Matrix3& R);

}  // namespace gaitwright
