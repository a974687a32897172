// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/derive_legs.h"

namespace gaitwright {

/// Whether the feet that a user names can be the ends of legs: links that exist, each once, none on the base body or
/// joined to it by fixed joints only, none on the way to another.
/// @param ends the bodies of the feet, one for each of `feet`.
/// @return the first thing wrong, naming the foot and what to do, or nothing.
std::optional<Failure> CheckNamedFeet(const RobotModel& model, const std::vector<FootOverride>& feet,
                                      const std::vector<int>& ends);

/// Checks that the contact geometry of each foot is known: from a shape, from a link fixed to the foot at its contact
/// point, or from the user. Adds a warning to the model's findings if only such a link is known, or if other shapes
/// replace a missing mesh.
/// @return nothing, or a failure that names the foot, the missing mesh and what to do.
std::optional<Failure> CheckFeetAreKnown(RobotModel& model, const std::vector<FootOverride>& given,
                                         const std::vector<MissingMesh>& missing);

}  // namespace gaitwright
