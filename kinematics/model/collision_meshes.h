// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/derive_legs.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Returns the hull of a mesh for the file name in the URDF.
using MeshSource = std::function<Result<std::vector<Vector3>>(const std::string& file)>;

/// Gives the collision meshes their vertices, and takes out those that do not exist or cannot be read.
/// @return the hulls used.
std::vector<MeshHull> FillMeshes(std::vector<Shape>& shapes, const MeshSource& source,
                                 std::vector<MissingMesh>& missing);

/// Uses the visual shapes of a foot without collision shapes for contact.
/// @param named  feet that the user names; empty if the feet are derived.
void TakeVisualsOfFeet(const std::vector<FootOverride>& named, const MeshSource& source, RobotModel& model,
                       std::vector<MeshHull>& meshes);

}  // namespace gaitwright
