// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "kinematics/base/result.h"
#include "planning/plan/plan_meshes_internal.h"

namespace gaitwright {

nlohmann::ordered_json MeshesJson(const std::vector<MeshHull>& meshes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const MeshHull& mesh : meshes) {
    nlohmann::ordered_json vertices = nlohmann::ordered_json::array();
    for (const Vector3& v : mesh.vertices) vertices.push_back({v.x(), v.y(), v.z()});
    list.push_back({{"file", mesh.file}, {"vertices_m", vertices}});
  }
  return list;
}

std::vector<MeshHull> ToMeshes(const nlohmann::ordered_json& list) {
  std::vector<MeshHull> meshes;
  for (const auto& entry : list) {
    MeshHull mesh{entry.at("file").get<std::string>(), {}};
    for (const auto& v : entry.at("vertices_m").get<std::vector<std::vector<double>>>()) {
      if (v.size() != 3) {
        throw InvalidArgument(
            fmt::format("a vertex of the mesh '{}' has {} numbers, 3 are needed", mesh.file, v.size()));
      }
      mesh.vertices.emplace_back(v[0], v[1], v[2]);
    }
    if (mesh.vertices.empty()) throw InvalidArgument(fmt::format("the mesh '{}' has no vertices", mesh.file));
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

}  // namespace gaitwright
