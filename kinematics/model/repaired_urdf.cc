// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/repaired_urdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "kinematics/model/ball_joints.h"
#include "kinematics/model/build_model.h"
#include "kinematics/model/mend_urdf.h"
#include "kinematics/model/robot_yaml.h"
#include "kinematics/model/urdf_pose_internal.h"
#include "kinematics/model/urdf_xml_internal.h"

namespace gaitwright {
namespace {

using tinyxml2::XMLElement;

/// The rotation of <origin rpy>.
Matrix3 AxesOf(const XMLElement& inertial) {
  const XMLElement* origin = inertial.FirstChildElement("origin");
  if (origin == nullptr || origin->Attribute("rpy") == nullptr) return Matrix3::Identity();
  const std::vector<double> rpy = Numbers(origin->Attribute("rpy"), 3, "rpy");
  urdf::Pose pose;
  pose.rotation.setFromRPY(rpy[0], rpy[1], rpy[2]);
  return FromUrdf(pose).linear();
}

/// The inertias of the model that replace inertias of its URDF. @param text  the repaired text of the URDF.
std::vector<LinkInertia> InertiasOf(const RobotModel& model, const std::string& text) {
  const double scale = ParseRobotYaml(model.yaml_text).scale;
  UrdfParts parts = SplitUrdf(WithoutBallJoints(text), scale);
  for (Shape& shape : parts.collision) {
    const auto hull = std::find_if(model.meshes.begin(), model.meshes.end(),
                                   [&](const MeshHull& mesh) { return mesh.file == shape.mesh_file; });
    if (shape.type != ShapeType::kMesh || hull == model.meshes.end()) continue;
    for (const Vector3& v : hull->vertices) shape.vertices.push_back(shape.size.cwiseProduct(v));
  }
  std::erase_if(parts.collision,
                [](const Shape& shape) { return shape.type == ShapeType::kMesh && shape.vertices.empty(); });
  for (const MissingMesh& mesh : model.missing_meshes) parts.incomplete.insert(mesh.link);
  return InertiasUsed(parts, scale);
}

/// Writes the replacement of a link's inertia, if there is one. @return whether there was one.
bool WriteInertia(const std::vector<LinkInertia>& used, XMLElement& link) {
  XMLElement* inertial = link.FirstChildElement("inertial");
  const std::string name = link.Attribute("name");
  const auto mended =
      std::find_if(used.begin(), used.end(), [&](const LinkInertia& inertia) { return inertia.link == name; });
  if (inertial == nullptr || mended == used.end()) return false;
  const Matrix3 R = AxesOf(*inertial);
  const Matrix3 I = R.transpose() * mended->I * R;
  XMLElement& inertia = *inertial->FirstChildElement("inertia");
  const auto put = [&](const char* key, double value) { inertia.SetAttribute(key, fmt::format("{}", value).c_str()); };
  put("ixx", I(0, 0));
  put("ixy", I(0, 1));
  put("ixz", I(0, 2));
  put("iyy", I(1, 1));
  put("iyz", I(1, 2));
  put("izz", I(2, 2));
  return true;
}

}  // namespace

std::string RepairedUrdf(const RobotModel& model) {
  std::string text = MendUrdf(model.urdf_text).text;
  tinyxml2::XMLDocument document;
  if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS) return text;
  const std::vector<LinkInertia> used = InertiasOf(model, text);
  bool changed = false;
  XMLElement* robot = document.RootElement();
  for (XMLElement* link = robot->FirstChildElement("link"); link != nullptr; link = link->NextSiblingElement("link"))
    changed = WriteInertia(used, *link) || changed;
  if (!changed) return text;
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace gaitwright
