// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kinematics/description/mjcf_equality_internal.h"

namespace gaitwright {

/// Positions of joints in the keyframe `home`, or else in the first one: by the URDF's names of joints, a ball joint's
/// as those of its three turns about x, y and z. Empty without a keyframe. Positions outside of a joint's range, and
/// keyframes of another number of positions than the model has, are noted and left out.
std::vector<std::pair<std::string, double>> ReadMjcfPosture(MjcfContext& context, const MjcfTree& tree,
                                                            const std::vector<MjcfCoupling>& couplings);

/// The turns about x, y and z, one after the other in the turned frame, that make up a rotation [rad].
Vector3 MjcfTurns(const Matrix3& R);

}  // namespace gaitwright
