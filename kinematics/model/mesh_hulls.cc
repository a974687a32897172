// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>

#include "kinematics/base/hash.h"
#include "kinematics/base/text.h"
#include "kinematics/model/mesh_hulls_internal.h"
#include "kinematics/model/mesh_parts.h"

namespace gaitwright {

Result<std::vector<Vector3>> MeshHulls::Of(const std::string& path) {
  const Result<std::string> bytes = ReadMeshBytes(path);
  if (!bytes) return bytes.failure();
  const std::string ending = LowerCase(std::filesystem::path(path).extension().string());
  const std::string key = fmt::format("{} {} {}", ending, bytes->size(), HexHash(*bytes));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto known = by_content_.find(key);
    if (known != by_content_.end()) return known->second;
  }
  Result<Mesh> mesh = MeshOfBytes(path, *bytes);
  if (!mesh) return mesh.failure();
  std::vector<Vector3> hull = HullPoints(std::move(mesh->vertices));
  const std::lock_guard<std::mutex> lock(mutex_);
  return by_content_.try_emplace(key, std::move(hull)).first->second;
}

std::size_t MeshHulls::size() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return by_content_.size();
}

MeshHulls& HullsOfThisRun() {
  static MeshHulls hulls;
  return hulls;
}

}  // namespace gaitwright
