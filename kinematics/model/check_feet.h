// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/derive_legs.h"

namespace gaitwright {

/// Checks that the feet named by the user can be the ends of legs. Each link must exist and be named once. It must not
/// be fixed to the base or lie on the chain to another foot.
/// @param ends the bodies of the feet, one for each of `feet`.
/// @return the first error, with the foot and a remedy, or nothing.
std::optional<Failure> CheckNamedFeet(const RobotModel& model, const std::vector<FootOverride>& feet,
                                      const std::vector<int>& ends);

/// Checks that the contact geometry of each foot is known: from a shape, from a link fixed to the foot at its contact
/// point, or from the user. Adds a warning to the model's findings if only such a link is known, or if other shapes
/// replace a missing mesh.
/// @return nothing, or a failure with the foot, the missing mesh and a remedy.
std::optional<Failure> CheckFeetAreKnown(RobotModel& model, const std::vector<FootOverride>& given,
                                         const std::vector<MissingMesh>& missing);

}  // namespace gaitwright
