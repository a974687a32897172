// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/collision_meshes.h"

#include <fmt/format.h>

#include <algorithm>

namespace gaitwright {
namespace {

/// The hull of a mesh file. Reads the file and stores the hull in `meshes` unless it is already there.
const MeshHull* HullOf(const std::string& file, const MeshSource& source, std::vector<MeshHull>& meshes) {
  const auto known = std::find_if(meshes.begin(), meshes.end(), [&](const MeshHull& m) { return m.file == file; });
  if (known != meshes.end()) return &*known;
  Result<std::vector<Vector3>> hull = source(file);
  if (!hull) return nullptr;
  meshes.push_back({file, std::move(*hull)});
  return &meshes.back();
}

}  // namespace

std::vector<MeshHull> FillMeshes(std::vector<Shape>& shapes, const MeshSource& source,
                                 std::vector<MissingMesh>& missing) {
  std::vector<MeshHull> meshes;
  for (Shape& shape : shapes) {
    if (shape.type != ShapeType::kMesh) continue;
    auto known = std::find_if(meshes.begin(), meshes.end(), [&](const auto& m) { return m.file == shape.mesh_file; });
    if (known == meshes.end()) {
      Result<std::vector<Vector3>> hull = source(shape.mesh_file);
      if (!hull) {
        missing.push_back({shape.link, hull.failure().message});
        continue;
      }
      known = meshes.insert(meshes.end(), {shape.mesh_file, std::move(*hull)});
    }
    for (const Vector3& v : known->vertices) shape.vertices.push_back(shape.size.cwiseProduct(v));
  }
  std::erase_if(shapes, [](const Shape& shape) { return shape.type == ShapeType::kMesh && shape.vertices.empty(); });
  return meshes;
}

void TakeVisualsOfFeet(const std::vector<FootOverride>& named, const MeshSource& source, RobotModel& model,
                       std::vector<MeshHull>& meshes) {
  std::vector<int> ends;
  for (const FootOverride& foot : named) {
    for (const Frame& frame : model.frames) {
      if (frame.name == foot.link) ends.push_back(frame.body);
    }
  }
  if (named.empty()) ends = EndBodies(model);
  for (const int body : ends) {
    const auto of_body = [&](const Shape& shape) { return shape.body == body; };
    if (std::any_of(model.collision_shapes.begin(), model.collision_shapes.end(), of_body)) continue;
    for (Shape shape : model.visual_shapes) {
      if (!of_body(shape)) continue;
      if (shape.type == ShapeType::kMesh) {
        const MeshHull* hull = HullOf(shape.mesh_file, source, meshes);
        if (hull == nullptr) continue;
        for (const Vector3& v : hull->vertices) shape.vertices.push_back(shape.size.cwiseProduct(v));
      }
      model.findings.push_back({FindingLevel::kWarning, FailureCode::kVisualFoot,
                                RobotPart{PartKind::kLink, shape.link}, 0,
                                "its foot has no collision geometry; its visual geometry is used for contact"});
      model.collision_shapes.push_back(std::move(shape));
    }
  }
}

}  // namespace gaitwright
