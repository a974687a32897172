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

/// Whether something tells the shape of each foot: a shape that is there, a link that is fixed to it and says where its
/// contact is, or the user. Findings of the model get a warning for a foot that is told by such a link, or by shapes
/// above a mesh that is missing.
/// @return a failure that names the foot, the mesh that is missing and what to do, or nothing.
std::optional<Failure> CheckFeetAreKnown(RobotModel& model, const std::vector<FootOverride>& given,
                                         const std::vector<MissingMesh>& missing);

}  // namespace gaitwright
