// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// `[{"file", "vertices_m": [[x, y, z], ...]}]`
nlohmann::ordered_json MeshesJson(const std::vector<MeshHull>& meshes);

/// @throws InvalidArgument naming the mesh whose vertices are none; nlohmann's exceptions where a key is missing.
std::vector<MeshHull> ToMeshes(const nlohmann::ordered_json& list);

}  // namespace gaitwright
