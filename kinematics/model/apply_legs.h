// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/derive_legs.h"

namespace gaitwright {

/// Puts in what a user says of legs. Both throw InvalidArgument with the line: no such foot or joint (with those that
/// there are), joints that are not the chain to the foot, a leg without a knee whose knee's side is given, a leg in two
/// pairs.
void ApplyLegs(const std::vector<LegOverride>& given, RobotModel& model);

/// Mirrors by pairs of feet in place of those that were derived.
void ApplyMirrors(const std::vector<MirrorPair>& pairs, RobotModel& model);

}  // namespace gaitwright
