// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/derive_legs.h"

namespace gaitwright {

/// Applies the user's overrides of legs. Both functions throw InvalidArgument with the line for an unknown foot or
/// joint (with the known ones), joints that are not the chain to the foot, a knee side for a leg without a knee, or a
/// leg in two pairs.
void ApplyLegs(const std::vector<LegOverride>& given, RobotModel& model);

/// Replaces the derived mirrored legs by the given pairs of feet.
void ApplyMirrors(const std::vector<MirrorPair>& pairs, RobotModel& model);

}  // namespace gaitwright
