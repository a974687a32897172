// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>

#include "kinematics/model/mesh_file.h"
#include "playback/viewer/packed_columns_internal.h"
#include "playback/viewer/scene_parts_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

const char* NameOf(JointType type) {
  switch (type) {
    case JointType::kRevolute:
      return "revolute";
    case JointType::kContinuous:
      return "continuous";
    case JointType::kPrismatic:
      break;
  }
  return "prismatic";
}

Json BodiesJson(const RobotModel& model) {
  Json list = Json::array();
  for (const Body& body : model.bodies) list.push_back(body.name);
  return list;
}

Json JointsJson(const RobotModel& model) {
  Json list = Json::array();
  for (const Joint& joint : model.joints) {
    list.push_back({{"name", joint.name},
                    {"type", NameOf(joint.type)},
                    {"parent_body", joint.parent_body},
                    {"pose", PoseJson(joint.X_PJ)},
                    {"axis", {joint.axis_J.x(), joint.axis_J.y(), joint.axis_J.z()}},
                    {"dof", joint.dof},
                    {"multiplier", joint.multiplier},
                    {"offset", joint.offset}});
  }
  return list;
}

Json DofsJson(const RobotModel& model) {
  Json list = Json::array();
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    const bool shared = model.TransmissionOf(dof) != nullptr;  // the joint has no limit of its own
    list.push_back({{"name", model.dof_names[static_cast<std::size_t>(dof)]},
                    {"unit", model.LeaderOf(dof).is_prismatic() ? "m" : "rad"},
                    {"lower", FiniteOrNull(model.dof_lower(dof))},
                    {"upper", FiniteOrNull(model.dof_upper(dof))},
                    {"effort_limit", shared ? Json(nullptr) : FiniteOrNull(model.dof_effort_limit(dof))}});
  }
  return list;
}

Json FeetJson(const RobotModel& model) {
  Json list = Json::array();
  for (const Foot& foot : model.feet) list.push_back({{"name", foot.name}, {"body", foot.body}});
  return list;
}

Json SizeJson(const Shape& shape) {
  switch (shape.type) {
    case ShapeType::kSphere:
      return Json::array({shape.size.x()});
    case ShapeType::kCylinder:
    case ShapeType::kCapsule:
      return Json::array({shape.size.x(), shape.size.y()});
    case ShapeType::kBox:
    case ShapeType::kMesh:
      break;
  }
  return Json::array({shape.size.x(), shape.size.y(), shape.size.z()});
}

/// Collects the drawable shapes of a robot, and the meshes that they need.
class Shapes {
 public:
  Shapes(const RobotModel& model, const std::optional<std::string>& mesh_folder) : mesh_folder_(mesh_folder) {
    std::set<std::string> not_drawn, drawn;
    for (const Shape& shape : model.visual_shapes) (Add(shape) ? drawn : not_drawn).insert(shape.link);
    for (const Shape& shape : model.collision_shapes) {
      if (not_drawn.count(shape.link) > 0 || (model.visual_shapes.empty() && drawn.empty())) Add(shape);
    }
  }

  Json shapes = Json::array(), meshes = Json::array();

 private:
  bool Add(const Shape& shape) {
    constexpr const char* kNames[] = {"box", "cylinder", "sphere", "capsule"};
    Json json = {{"body", shape.body}, {"pose", PoseJson(shape.X_BS)}, {"size_m", SizeJson(shape)}};
    if (shape.type != ShapeType::kMesh) {
      json["type"] = kNames[static_cast<std::size_t>(shape.type)];
    } else if (!shape.vertices.empty()) {
      json["type"] = "hull";
      json["points_m"] = PackedPoints(shape.vertices);
    } else {
      const int mesh = MeshNumber(shape.mesh_file);
      if (mesh < 0) return false;
      json["type"] = "mesh";
      json["mesh"] = mesh;
    }
    shapes.push_back(std::move(json));
    return true;
  }

  /// Index of a file in `meshes`; -1 if it is not available.
  int MeshNumber(const std::string& file) {
    const auto [known, is_new] = numbers_.try_emplace(file, -1);
    if (!is_new || !mesh_folder_) return known->second;
    const Result<std::string> path = FindMeshFile(file, *mesh_folder_);
    if (!path) return -1;
    const Result<Mesh> mesh = ReadMesh(*path);
    if (!mesh) return -1;
    std::vector<std::uint32_t> corners;
    for (const Eigen::Vector3i& triangle : mesh->triangles)
      for (Eigen::Index i = 0; i < 3; ++i) corners.push_back(static_cast<std::uint32_t>(triangle[i]));
    known->second = static_cast<int>(meshes.size());
    meshes.push_back({{"vertices_m", PackedPoints(mesh->vertices)}, {"triangles", Packed(3, corners)}});
    return known->second;
  }

  const std::optional<std::string>& mesh_folder_;
  std::map<std::string, int> numbers_;
};

}  // namespace

Json RobotScene(const RobotModel& model, const std::optional<std::string>& mesh_folder) {
  Shapes shapes(model, mesh_folder);
  return {{"name", model.name},          {"weight_n", model.weight_n()},       {"leg_length_m", model.leg_length_m()},
          {"bodies", BodiesJson(model)}, {"joints", JointsJson(model)},        {"dofs", DofsJson(model)},
          {"feet", FeetJson(model)},     {"shapes", std::move(shapes.shapes)}, {"meshes", std::move(shapes.meshes)}};
}

}  // namespace gaitwright
